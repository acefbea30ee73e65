# What all charts share: colours that the colour-blind can tell apart (Okabe and Ito 2008), fonts, a grid in the back.
set datafile separator ','
set terminal pngcairo size 1000,620 font 'DejaVu Sans,15' background rgb 'white'
set border 3 lw 1.2 lc rgb '#444444'
set tics nomirror out
set grid lc rgb '#dddddd' lt 1 lw 1 back
set key Left reverse samplen 2.4 spacing 1.25
black = '#000000'; orange = '#e69f00'; sky = '#56b4e9'; green = '#009e73'; blue = '#0072b2'; red = '#d55e00'; pink = '#cc79a7'
line = 2.5
