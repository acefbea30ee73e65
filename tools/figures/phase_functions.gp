set terminal pngcairo size 1200,620
set multiplot layout 1,2
set xlabel 'scattering angle (degrees)'
set xrange [0:180]
set xtics 30
set ylabel 'phase function (1/sr)'
set yrange [0:0.16]
set title 'molecules'
set key bottom center
plot table using 'angle_deg':'rayleigh' with lines lw line lc rgb black title 'Rayleigh', \
     '' using 'angle_deg':'softened_rayleigh' with lines lw line lc rgb blue dt 2 title "Nielsen's, normalised", \
     '' using 'angle_deg':(13.0 / 8.0 * column('softened_rayleigh')) with lines lw line lc rgb red dt 4 title "Nielsen's as printed"
set title 'aerosol'
set key top right
set logscale y
set yrange [0.004:300]
set format y '%g'
plot table using 'angle_deg':'mie' with lines lw line lc rgb black title 'Mie, clean land, 550 nm', \
     '' using 'angle_deg':'henyey_greenstein' with lines lw line lc rgb blue dt 2 title 'Henyey–Greenstein', \
     '' using 'angle_deg':'cornette_shanks' with lines lw line lc rgb red dt 4 title 'Cornette–Shanks', \
     '' using 'angle_deg':'henyey_greenstein_0_2' with lines lw line lc rgb green dt 3 title 'Henyey–Greenstein, g = 0.2'
unset multiplot
