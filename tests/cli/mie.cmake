airlight_cli_help(mie)
# Wiscombe's x = 100, m = 1.33 - 1e-5 i: a radius of 50 um / pi at 1 um.
airlight_cli_test("mie: Wiscombe's sphere" OUT "^qext,qsca,qabs,g$" "^2\\.101321,2\\.096594,0\\.004727[0-9]*,0\\.868959"
  COMMAND mie --radius-um 15.915494309189535 --wavelength-nm 1000 --n 1.33 --k 1e-5)
airlight_cli_test("mie: a tiny sphere polarises what it scatters across the beam" OUT "^angle_deg,m11,polarisation,phase_per_sr$" "^90,[^,]+,1\\.000000,0\\.05968"
  COMMAND mie --radius-um 0.001 --wavelength-nm 500 --n 1.5 --angles 3)
airlight_cli_test("mie: a negative radius is refused" EXIT 1 ERR "^--radius-um: -1 is out of range: it must be above 0$"
  COMMAND mie --radius-um -1 --wavelength-nm 500 --n 1.5)
airlight_cli_test("mie: a negative k is refused" EXIT 1 ERR "^--k: -0.1 is out of range: it must be from 0 to 100$"
  COMMAND mie --radius-um 1 --wavelength-nm 500 --n 1.5 --k -0.1)
airlight_cli_test("mie: a sphere too large for the series is refused" EXIT 1 ERR "^--radius-um: the size parameter .*it must be from"
  COMMAND mie --radius-um 1e9 --wavelength-nm 500 --n 1.5)
airlight_cli_test("mie: one angle is refused" EXIT 1 ERR "^--angles: 1 is out of range"
  COMMAND mie --radius-um 1 --wavelength-nm 500 --n 1.5 --angles 1)
airlight_cli_test("mie: a missing option is wrong usage" EXIT 2 ERR "^airlight mie: --n is required$"
  COMMAND mie --radius-um 1 --wavelength-nm 500)
