airlight_cli_help(atmosphere)
airlight_cli_test("atmosphere: the presets are listed" OUT "^earth-clear$" "^earth-desert$" "^mars$" COMMAND atmosphere --list)
airlight_cli_test("atmosphere: the Rayleigh optical depth at 550 nm is Bodhaine's" OUT "^air,550,0\\.097" "^all,550,0\\.097"
  COMMAND atmosphere earth-rayleigh)
airlight_cli_test("atmosphere: a misspelt preset is refused with the nearest" EXIT 1 ERR "^earth-claer: there is no file and no preset" "Did you mean \"earth-clear\""
  COMMAND atmosphere earth-claer)
airlight_cli_test("atmosphere: no name is refused" EXIT 1 ERR "no atmosphere is named" COMMAND atmosphere)
airlight_cli_test("atmosphere: a wavelength without data is refused" EXIT 1 ERR "has no data at every wavelength from 250 nm"
  COMMAND atmosphere earth-clear --wavelengths 250,550)
airlight_cli_test("atmosphere: a folder that is not there is refused" EXIT 1 ERR "cannot be written" COMMAND atmosphere earth-rayleigh -o absent/a.toml)
airlight_cli_test("atmosphere: a METAR with a wrong visibility is refused" EXIT 1 ERR "^--metar: .*99999"
  COMMAND atmosphere earth-clear --metar "METAR EDDF 171950Z 05004KT 99999 HZ 22/12 Q1018")
airlight_cli_test("atmosphere: haze of 4 km is polluted air of its humidity" OUT "^# aerosol: continental_polluted" "^# relative humidity: 53 %" "^aerosol,550,"
  COMMAND atmosphere earth-clear --metar "METAR EDDF 171950Z 05004KT 4000 HZ 22/12 Q1018")
airlight_cli_test("atmosphere: an unknown option is wrong usage" EXIT 2 ERR "See airlight atmosphere --help" COMMAND atmosphere earth-clear --depth 3)
