set xlabel 'altitude of the eye (km)'
set ylabel 'luminance (cd/m²)'
set xrange [0:60]
set logscale y
set format y '10^{%L}'
set yrange [0.1:100000]
set key bottom left
plot table using 'altitude_km':'horizon_cd_m2' with lines lw line lc rgb green title '0.5° above the horizon that is seen', \
     '' using 'altitude_km':'low_cd_m2' with lines lw line lc rgb blue title '2° above the horizontal', \
     '' using 'altitude_km':'nielsen_low_cd_m2' with lines lw line lc rgb blue dt 2 title '2° above the horizontal, nielsen2003', \
     '' using 'altitude_km':'zenith_cd_m2' with lines lw line lc rgb black title 'zenith', \
     '' using 'altitude_km':'nielsen_zenith_cd_m2' with lines lw line lc rgb black dt 2 title 'zenith, nielsen2003'
