airlight_cli_help(sky)
set(small_sky --wavelengths 450,550,650 --sizes 16x8x16x8 --orders 3 --cache tables --size 32)
airlight_cli_test("sky: a place, a time and a weather report give pictures and illuminances"
  OUT "^# " "^quantity,value,unit$" "^sun zenith angle,[0-9.]+,deg$" "^global horizontal illuminance,[0-9.e+]+,lx$" "^file,sky.exr,$" "^file,sky.png,$"
  COMMAND sky earth-clear --lat 47.26 --lon 11.34 --time 2026-06-21T12:50:00Z --metar "LOWI 211250Z 07008KT 9999 FEW040 26/12 Q1018" ${small_sky} -o sky.exr -o sky.png)
foreach(projection fisheye sphere perspective cube)
  airlight_cli_test("sky: the ${projection} projection" OUT "^file,${projection}.png,$"
    COMMAND sky earth-clear --sun 80 --projection ${projection} ${small_sky} -o ${projection}.png)
endforeach()
airlight_cli_test("sky: night is dark, and no error" OUT "^global horizontal illuminance,0,lx$" COMMAND sky earth-clear --sun 150 ${small_sky} -o night.png)
airlight_cli_test("sky: a file that is neither EXR nor PNG is refused before anything is computed" EXIT 1 ERR "^sky.jpg: is neither a .exr nor a .png file"
  COMMAND sky earth-clear --sun 30 -o sky.jpg)
airlight_cli_test("sky: a folder that is not there is told before anything is computed" EXIT 1 ERR "^absent/sky.exr: cannot be written"
  COMMAND sky earth-clear --sun 30 -o absent/sky.exr)
airlight_cli_test("sky: a METAR with a wrong visibility is refused" EXIT 1 ERR "^--metar: " COMMAND sky earth-clear --sun 30 --metar "LOWI 211250Z 07008KT 99999 FEW040 26/12 Q1018")
airlight_cli_test("sky: a time without a place is wrong usage" EXIT 2 ERR "--lat" COMMAND sky earth-clear --time 2026-06-21T12:00Z)
airlight_cli_test("sky: a picture of no size is refused" EXIT 1 ERR "0" COMMAND sky earth-clear --sun 30 --size 0 -o sky.png)
airlight_cli_test("sky: an exposure that is none is refused" EXIT 1 ERR "^--exposure: \"bright\" is neither auto nor" COMMAND sky earth-clear --sun 30 --exposure bright -o sky.png)
