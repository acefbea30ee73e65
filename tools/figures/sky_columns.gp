set terminal pngcairo size 1200,620
set multiplot layout 1,2
set xlabel 'sine of the elevation (0 horizon, 1 zenith)'
set xrange [0:1]
set ylabel 'column of air (km at the density of the ground)'
set logscale y
set yrange [0.3:1000]
colours = "#000000 #0072b2 #009e73 #d55e00"
set title "Nielsen's interpolation"
plot for [i = 0:3] table using 'sine_of_elevation':sprintf('nielsen_%dkm', 10 * i) with lines lw line lc rgb word(colours, i + 1) dt i + 1 \
     title sprintf('eye at %d km', 10 * i)
set title 'integral around the sphere'
plot for [i = 0:3] table using 'sine_of_elevation':sprintf('exact_%dkm', 10 * i) with lines lw line lc rgb word(colours, i + 1) dt i + 1 \
     title sprintf('eye at %d km', 10 * i)
unset multiplot
