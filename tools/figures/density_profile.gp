set xlabel 'altitude (km)'
set xrange [0:60]
set multiplot layout 1,2
set key bottom left
set ylabel 'density relative to the ground'
set logscale y
set format y '10^{%L}'
set yrange [1e-4:1]
plot table using 'altitude_km':'standard' with lines lw line lc rgb black title 'standard atmosphere', \
     '' using 'altitude_km':'exponential_8_4km' with lines lw line lc rgb blue dt 2 title 'exponential, 8.4 km', \
     '' using 'altitude_km':'exponential_10km' with lines lw line lc rgb red dt 4 title 'exponential, 10 km'
unset logscale y
set format y '%g'
set yrange [0:1.2]
set ylabel 'standard atmosphere over the exponential'
plot 1 with lines lw 1 lc rgb '#888888' notitle, \
     table using 'altitude_km':(column('standard')/column('exponential_8_4km')) with lines lw line lc rgb blue dt 2 title '8.4 km', \
     '' using 'altitude_km':(column('standard')/column('exponential_10km')) with lines lw line lc rgb red dt 4 title '10 km'
unset multiplot
