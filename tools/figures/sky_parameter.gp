set xlabel 'sine of the elevation (0 horizon, 1 zenith)'
set ylabel 'weight of the zenith'
set xrange [0:1]
set yrange [0:1]
plot table using 'sine_of_elevation':'parameter' with lines lw line lc rgb black notitle
