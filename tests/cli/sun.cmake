airlight_cli_help(sun)
airlight_cli_test("sun: Reda and Andreas' example" OUT "^sun,2003-10-17T19:30:30Z,50\\.11[0-9]+,194\\.34[0-9]+,0\\.996[0-9]+,"
  COMMAND sun --lat 39.742476 --lon -105.1786 --altitude-m 1830.14 --refraction --pressure-hpa 820 --temperature-c 11
          --time 2003-10-17T12:30:30-07:00)
airlight_cli_test("sun: latitude 95 is refused" EXIT 1 ERR "^latitude: 95 deg is out of range: it must be -90 to 90$"
  COMMAND sun --lat 95 --lon 0 --time 2003-10-17T19:30:30Z)
airlight_cli_test("sun: a time that is none is refused" EXIT 1 ERR "^--time: \"noon\" is not a time: " "Write it as 2003-10-17T19:30:30Z"
  COMMAND sun --lat 0 --lon 0 --time noon)
airlight_cli_test("sun: a missing option is wrong usage" EXIT 2 ERR "^airlight sun: --time is required$" "See airlight sun --help"
  COMMAND sun --lat 0 --lon 0)
airlight_cli_test("sun: a word for a number is wrong usage" EXIT 2 ERR "^airlight sun: .*--lat.*north"
  COMMAND sun --lat north --lon 0 --time 2003-10-17)
airlight_cli_test("sun: the moon has a row of its own" OUT "^moon,2017-08-21T18:25:32Z,[0-9.]+,[0-9.]+,0\\.0024[0-9]+,0\\.27[0-9]+,0\\.0000$"
  COMMAND sun --lat 37 --lon -87.7 --time 2017-08-21T18:25:32Z --moon)
airlight_cli_test("sun: the events of a day in London"
  OUT "^sunrise,2024-06-21T03:43:" "^sunset,2024-06-21T20:21:" "^civil_dawn,2024-06-21T02:5" "^astronomical_twilight_always_above,$" "^moonrise,"
  COMMAND sun --lat 51.51 --lon -0.13 --time 2024-06-21 --events --moon)
airlight_cli_test("sun: the polar night is an answer" OUT "^sun_always_below,$" "^civil_dawn,2024-12-21T"
  COMMAND sun --lat 69.65 --lon 18.96 --time 2024-12-21 --events)
airlight_cli_test("sun: a pressure that cannot be is refused" EXIT 1 ERR "^pressure: 5000 hPa is out of range: it must be 0 to 1100$"
  COMMAND sun --lat 0 --lon 0 --time 2024-12-21 --refraction --pressure-hpa 5000)
airlight_cli_test("sun: a full disk is told" EXIT 1 ERR "^standard output: cannot be written: " OUT_TO /dev/full
  COMMAND sun --lat 0 --lon 0 --time 2024-12-21)
