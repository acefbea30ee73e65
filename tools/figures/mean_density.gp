set xlabel 'altitude of the eye (km)'
set ylabel 'mean density of the path, relative to the ground'
set xrange [0:30]
set yrange [0:1]
plot table using 'eye_km':'exact' with lines lw line lc rgb black title 'integral over the path', \
     '' using 'eye_km':'by_mean_altitude' with lines lw line lc rgb blue dt 2 title 'density at the mean altitude', \
     '' using 'eye_km':'by_ends' with lines lw line lc rgb red dt 4 title 'mean of the densities at both ends'
