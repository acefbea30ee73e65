set(small_air --sizes 16x4x8x12,32x16 --orders 2 --cache tables --quiet)
set(mountains ${PROJECT_SOURCE_DIR}/data/demo/mountains.toml)
if(AIRLIGHT_GPU)
  airlight_cli_help(render)
  airlight_cli_test("render: a scene gives light and a picture, and says who drew it in what time"
    OUT "^quantity,value,unit$" "^device,\".+\",$" "^pass terrain,[0-9.]+,ms$" "^pass shadows,[0-9.]+,ms$" "^pass shafts,[0-9.]+,ms$" "^pass air,[0-9.]+,ms$" "^patches,[0-9]+,$" "^file,m.exr,$" "^file,m.png,$"
    COMMAND render ${mountains} ${small_air} --width 64 --height 36 -o m.exr -o m.png)
else()
  airlight_cli_test("render: a build without OpenGL says so" EXIT 1 ERR "built without OpenGL" COMMAND render ${mountains} -o m.png)
endif()
airlight_cli_test("render: a scene that is not there is told" EXIT 1 ERR "^absent.toml: " COMMAND render absent.toml -o m.png)
airlight_cli_test("render: a misspelt key of a scene is told with its line" EXIT 1 ERR "misspelt.toml:2: camera.lattitude is no key"
  COMMAND render ${CMAKE_CURRENT_SOURCE_DIR}/../corpus/scene/misspelt.toml -o m.png)
airlight_cli_test("render: a missing elevation file is told" EXIT 1 ERR "corpus/scene/none.tif: there is no such file"
  COMMAND render ${CMAKE_CURRENT_SOURCE_DIR}/../corpus/scene/no-elevation.toml -o m.png)
airlight_cli_test("render: a file that is neither EXR nor PNG is refused" EXIT 1 ERR "^m.jpg: is neither" COMMAND render ${mountains} -o m.jpg)
airlight_cli_test("render: a picture of no size is refused" EXIT 1 ERR "0 x 720 is out of range" COMMAND render ${mountains} --width 0 -o m.png)
airlight_cli_test("render: an exposure that is none is refused" EXIT 1 ERR "^--exposure: \"bright\"" COMMAND render ${mountains} --exposure bright -o m.png)
if(AIRLIGHT_GPU)
  airlight_cli_test("render: a scene without air is drawn without it" OUT "^pass light,[0-9.]+,ms$"
    COMMAND render ${CMAKE_CURRENT_SOURCE_DIR}/../corpus/scene/no-air.toml --width 64 --height 36 -o m.png)
  airlight_cli_test("render: an atmosphere that is none is told" EXIT 1 ERR "no-such-air.toml: atmosphere"
    COMMAND render ${CMAKE_CURRENT_SOURCE_DIR}/../corpus/scene/no-such-air.toml --width 64 --height 36 -o m.png)
endif()
