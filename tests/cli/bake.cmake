airlight_cli_help(bake)
set(small --sizes 4x2x4x4,8x8 --orders 1 --wavelengths 450,550,650)
airlight_cli_test("bake: the tables' file is named, with its size" OUT "^tables/[0-9a-f]+\\.tables: [0-9.]+ MiB$" "^3 wavelengths, [0-9.]+ s$"
  COMMAND bake earth-rayleigh ${small} --cache tables)
airlight_cli_test("bake: all tables go to one file if asked" OUT "^all\\.tables: [0-9.]+ MiB$" COMMAND bake earth-rayleigh ${small} --cache tables -o all.tables)
airlight_cli_test("bake: a folder that is not there holds nothing" OUT "^absent: 0 files, 0\\.0 MiB$" COMMAND bake --list --cache absent)
airlight_cli_test("bake: what is listed is said to be what it is" OUT "^earth-clear\\.toml: [0-9.]+ MiB, is not a table file of Airlight$"
  COMMAND bake --list --cache data/presets)
airlight_cli_test("bake: a cache that cannot be written is a warning" OUT "^3 wavelengths" ERR "^warning: .*the cache folder cannot be made: Not a directory$"
  COMMAND bake earth-rayleigh ${small} --cache data/presets/earth-clear.toml/cache)
airlight_cli_test("bake: a file in a folder that is not there is refused before the bake" EXIT 1
  ERR "^absent/all\\.tables: cannot be written: No such file" "Check that the folder exists" COMMAND bake earth-rayleigh -o absent/all.tables)
airlight_cli_test("bake: an unknown atmosphere is refused" EXIT 1 ERR "moonshine" COMMAND bake moonshine)
airlight_cli_test("bake: no order is refused" EXIT 1 ERR "^--orders: orders: 0 is out of range: it must be 1 to 100$" COMMAND bake earth-rayleigh --orders 0)
airlight_cli_test("bake: one size is refused" EXIT 1 ERR "^--sizes: \"64\" are not table sizes$" "Write sun x azimuth" COMMAND bake earth-rayleigh --sizes 64)
airlight_cli_test("bake: wavelengths without data are refused" EXIT 1 ERR "100 nm|to 100" COMMAND bake earth-clear --wavelengths 100,200)
airlight_cli_test("bake: no atmosphere is wrong usage" EXIT 2 ERR "^airlight bake: <atmosphere> is required$" COMMAND bake)
add_test(NAME "cli: bake: an interrupted bake goes on, and two at once do not disturb each other"
         COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/interrupted_bake $<TARGET_FILE:airlight>)
