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
