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
airlight_cli_test("render: a misspelt key of a scene is told with its line and the nearest" EXIT 1
  ERR "misspelt.toml:2: camera.lattitude is no key" "Did you mean .latitude.[?]"
  COMMAND render ${CMAKE_CURRENT_SOURCE_DIR}/../corpus/scene/misspelt.toml -o m.png)
airlight_cli_test("render: a missing elevation file is told" EXIT 1 ERR "corpus/scene/none.tif: there is no such file"
  COMMAND render ${CMAKE_CURRENT_SOURCE_DIR}/../corpus/scene/no-elevation.toml -o m.png)
set(grounds ${CMAKE_CURRENT_SOURCE_DIR}/ground)
airlight_cli_test("render: an elevation file that is no raster is told" EXIT 1 ERR "ground/words.tif: it is no raster that GDAL can read"
  COMMAND render ${grounds}/words.toml -o m.png)
airlight_cli_test("render: an elevation file that ends too early is told" EXIT 1 ERR "ground/cut.asc: it is damaged: " COMMAND render ${grounds}/cut.toml -o m.png)
airlight_cli_test("render: a raster without georeference is told, and how to give it one" EXIT 1
  ERR "ground/no-place.pgm: it does not say where on the planet it lies" "gdal_translate -a_srs EPSG:4326" COMMAND render ${grounds}/no-place.toml -o m.png)
set(objects ${CMAKE_CURRENT_SOURCE_DIR}/object)
airlight_cli_test("render: a misspelt key of an object is told with its line and the nearest" EXIT 1
  ERR "misspelt.toml:8: object.raduis is no key" "Did you mean .radius.[?]" COMMAND render ${objects}/misspelt.toml -o m.png)
airlight_cli_test("render: an object of no size is told" EXIT 1 ERR "no-size.toml:8: object.radius = .0 m.: it must be from 1 mm" COMMAND render ${objects}/no-size.toml -o m.png)
airlight_cli_test("render: a missing mesh is told" EXIT 1 ERR "object/none.obj: cannot be read" COMMAND render ${objects}/no-mesh.toml -o m.png)
airlight_cli_test("render: a mesh without triangles is told" EXIT 1 ERR "object/points.obj: it has no triangles" COMMAND render ${objects}/points.toml -o m.png)
airlight_cli_test("render: a file that is neither EXR nor PNG is refused" EXIT 1 ERR "^m.jpg: is neither" COMMAND render ${mountains} -o m.jpg)
airlight_cli_test("render: a picture of no size is refused" EXIT 1 ERR "0 x 720 is out of range" COMMAND render ${mountains} --width 0 -o m.png)
airlight_cli_test("render: samples that are no power of two are refused" EXIT 1 ERR "^--samples: 3 is none of 1, 2, 4" COMMAND render ${mountains} --samples 3 -o m.png)
airlight_cli_test("render: an exposure that is none is refused" EXIT 1 ERR "^--exposure: \"bright\"" COMMAND render ${mountains} --exposure bright -o m.png)
if(AIRLIGHT_GPU)
  airlight_cli_test("render: a scene without air is drawn without it" OUT "^pass light,[0-9.]+,ms$"
    COMMAND render ${CMAKE_CURRENT_SOURCE_DIR}/../corpus/scene/no-air.toml --width 64 --height 36 -o m.png)
  airlight_cli_test("render: a mesh is drawn" OUT "^pass objects,[0-9.]+,ms$" COMMAND render ${objects}/pyramid.toml --width 64 --height 36 -o m.png)
  airlight_cli_test("render: an atmosphere that is none is told" EXIT 1 ERR "no-such-air.toml: atmosphere"
    COMMAND render ${CMAKE_CURRENT_SOURCE_DIR}/../corpus/scene/no-such-air.toml --width 64 --height 36 -o m.png)
  airlight_cli_test("render: a weather report that is none is told" EXIT 1 ERR "wrong-weather.toml: weather: .*99999"
    COMMAND render ${CMAKE_CURRENT_SOURCE_DIR}/../corpus/scene/wrong-weather.toml --width 64 --height 36 -o m.png)
endif()
if(AIRLIGHT_GPU)
  airlight_cli_test("render: no GPU, and no driver that draws without one, is one clear message" EXIT 1
    ERR "^OpenGL: there is no EGL display without a window" "Debian: libgl1-mesa-dri renders in software"
    UNDER env __EGL_VENDOR_LIBRARY_FILENAMES=/none COMMAND render ${mountains} --width 64 --height 36 -o m.png)
endif()
set(paths ${CMAKE_CURRENT_SOURCE_DIR}/../corpus/path)
airlight_cli_test("render: a misspelt key of a path is told with its line" EXIT 1 ERR "misspelt.toml:6: key.headng is no key"
  COMMAND render ${mountains} --path ${paths}/misspelt.toml -o frames)
airlight_cli_test("render: the pictures of a path go into a folder" EXIT 1 ERR "^--output: the pictures of a path go into one folder"
  COMMAND render ${mountains} --path ${paths}/turn.toml -o m.png)
airlight_cli_test("render: no rate is refused" EXIT 1 ERR "^--rate: 0 is out of range" COMMAND render ${mountains} --path ${paths}/turn.toml --rate 0 -o frames)
airlight_cli_test("render: more pictures than have a name are refused" EXIT 1 ERR "^--rate: 1000 pictures a second make more than"
  COMMAND render ${mountains} --path ${paths}/long.toml --rate 1000 -o frames)
if(AIRLIGHT_GPU)
  airlight_cli_test("render: a path that leads into the ground is told before it is drawn" EXIT 1 ERR "^picture [0-9]+: .*is in the ground"
    COMMAND render ${mountains} ${small_air} --path ${paths}/buried.toml --width 64 --height 36 -o frames)
  add_test(NAME "cli: render: a path that is stopped goes on to the same pictures"
           COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/interrupted_path $<TARGET_FILE:airlight> ${PROJECT_SOURCE_DIR}/data/demo/mountains.toml ${paths}/sunset.toml)
  add_test(NAME "cli: render: a path becomes a video, stopped or not"
           COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/video_path $<TARGET_FILE:airlight> ${PROJECT_SOURCE_DIR}/data/demo/mountains.toml ${paths}/turn.toml)
  set_tests_properties("cli: render: a path that is stopped goes on to the same pictures" "cli: render: a path becomes a video, stopped or not"
                       PROPERTIES TIMEOUT 300)
endif()
