airlight_cli_help(probe)
set(small_tables --sizes 16x8x16x8 --orders 3 --cache tables)
airlight_cli_test("probe: a row a wavelength, standard errors of tables are zero"
  OUT "^wavelength_nm,radiance_W_m-2_sr-1_nm-1,standard_error$" "^450,[0-9.e+-]+,0.0e[+]00$" "^650,"
  COMMAND probe earth-clear --zenith 45 --sun 30 --wavelengths 450,550,650 ${small_tables})
airlight_cli_test("probe: the reference tells its standard errors, and the same seed the same digits"
  OUT "^550,[0-9.]+e-0[0-9],[1-9].[0-9]e-0[0-9]$"
  COMMAND probe earth-rayleigh --zenith 45 --sun 30 --wavelengths 550 --model reference --paths 2000)
airlight_cli_test("probe: space looks at the limb" OUT "^550,[0-9.]+e-0"
  COMMAND probe earth-clear --zenith 109.5 --sun 60 --altitude-m 400000 --wavelengths 550 ${small_tables})
airlight_cli_test("probe: a sun above 180 degrees is refused" EXIT 1 ERR "^sun zenith angle: 200 deg is out of range: it must be 0 to 180 deg$"
  COMMAND probe earth-clear --zenith 45 --sun 200)
airlight_cli_test("probe: an eye below the ground is refused" EXIT 1 ERR "^eye altitude: -1 m is below the ground"
  COMMAND probe earth-clear --zenith 45 --altitude-m -1)
airlight_cli_test("probe: a wavelength without data is refused" EXIT 1 ERR "earth-clear: " COMMAND probe earth-clear --zenith 45 --wavelengths 2500)
airlight_cli_test("probe: a model that is none is refused" EXIT 1 ERR "^--model: \"refrence\" is no model" "Did you mean reference\\?"
  COMMAND probe earth-clear --zenith 45 --model refrence)
airlight_cli_test("probe: a published model answers within its range" OUT "^550,[0-9.]+e-0[0-9],0.0e[+]00$"
  COMMAND probe earth-clear --zenith 45 --sun 30 --wavelengths 550 --model preetham1999 --turbidity 3)
airlight_cli_test("probe: a view beyond the range of its model is refused" EXIT 1
  ERR "^preetham1999: does not answer a view zenith angle of 95 deg: its range is 0 to 90 deg$"
  COMMAND probe earth-clear --zenith 95 --wavelengths 550 --model preetham1999 --turbidity 3)
airlight_cli_test("probe: an eye beyond the range of its model is refused" EXIT 1 ERR "does not answer an eye at 100 m"
  COMMAND probe earth-clear --zenith 45 --altitude-m 100 --wavelengths 550 --model preetham1999 --turbidity 3)
airlight_cli_test("probe: a turbidity beyond the range of its model is refused" EXIT 1
  ERR "^preetham1999: does not answer a turbidity of 0.5: its range is 1.7 to 10$"
  COMMAND probe earth-clear --zenith 45 --wavelengths 550 --model preetham1999 --turbidity 0.5)
airlight_cli_test("probe: an atmosphere that is neither preset nor file is refused" EXIT 1 ERR "earth-cleer" COMMAND probe earth-cleer --zenith 45)
airlight_cli_test("probe: a missing zenith angle is wrong usage" EXIT 2 ERR "^airlight probe: --zenith is required$" COMMAND probe earth-clear)
