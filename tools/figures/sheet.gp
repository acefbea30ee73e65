# A sheet of pictures, each named by the first two cells of its row in the table: where the eye is, and what varies.
# The last cell is the luminance noted in each; the pictures are those that the program wrote beside the table.
array eye[64]
array air[64]
array light[64]
stats table using (eye[int($0) + 1] = strcol('row'), air[int($0) + 1] = strcol('column'), \
                   light[int($0) + 1] = column('luminance_cd_m2'), 0) nooutput
count = int(STATS_records)
columns = 1
while (columns < count && eye[columns + 1] eq eye[1]) { columns = columns + 1 }
rows = count / columns
# Three digits, without a power of ten.
digits(x) = x < 1 ? sprintf('%.2g', x) : x < 100 ? sprintf('%.1f', x) : sprintf('%.0f', x >= 1000 ? 10 * floor(0.1 * x + 0.5) : x)
stem = table[1:strlen(table) - 4]
file(i) = sprintf('%s-%d-%d.png', stem, (i - 1) / columns, (i - 1) % columns)

# Width and height are the big-endian words at bytes 16 and 20 of a PNG file.
wide = int(system(sprintf("od -An -tu4 --endian=big -j16 -N4 %s", file(1))))
high = int(system(sprintf("od -An -tu4 --endian=big -j20 -N4 %s", file(1))))
left = 38; top = 34; gap = 6
width = left + columns * (wide + gap); height = top + rows * (high + gap)
set terminal pngcairo size width, height
set multiplot
unset border; unset tics; unset key; unset grid
do for [i = 1:count] {
    column_of = (i - 1) % columns; row_of = (i - 1) / columns
    x0 = left + column_of * (wide + gap); y1 = height - top - row_of * (high + gap)
    set lmargin at screen 1.0 * x0 / width
    set rmargin at screen 1.0 * (x0 + wide) / width
    set tmargin at screen 1.0 * y1 / height
    set bmargin at screen 1.0 * (y1 - high) / height
    set xrange [-0.5:wide - 0.5]; set yrange [-0.5:high - 0.5]
    unset label
    if (row_of == 0) { set label 1 air[i] at screen (x0 + 0.5 * wide) / width, 1.0 - 0.5 * top / height center }
    if (column_of == 0) { set label 2 eye[i] at screen 0.5 * left / width, (y1 - 0.5 * high) / height center rotate by 90 }
    set label 3 digits(light[i]).' cd/m²' at graph 0.97, 0.06 right front textcolor rgb 'white' font ',12'
    plot file(i) binary filetype=png with rgbimage notitle
}
unset multiplot
