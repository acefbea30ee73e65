set(view_small ${small_air} --width 160 --height 90)
airlight_cli_test("view: --help is the committed text" OUT_IS help/view.txt COMMAND view --help)
airlight_cli_test("view: a scene that is not there is told" EXIT 1 ERR "^absent.toml: " COMMAND view absent.toml)
airlight_cli_test("view: a misspelt key of a scene is told with its line and the nearest" EXIT 1
  ERR "misspelt.toml:2: camera.lattitude is no key" "Did you mean .latitude.[?]"
  COMMAND view ${CMAKE_CURRENT_SOURCE_DIR}/../corpus/scene/misspelt.toml)
airlight_cli_test("view: a picture of no size is refused" EXIT 1 ERR "0 x 720 is out of range" COMMAND view --width 0)
if(NOT AIRLIGHT_VIEWER)
  airlight_cli_test("view: a build without a window says so" EXIT 1 ERR "built without a window" COMMAND view ${mountains})
  return()
endif()
airlight_cli_test("view: no display is one clear message" EXIT 1 ERR "^airlight view: there is no display: " "airlight render. draws without"
  UNDER env -u DISPLAY -u WAYLAND_DISPLAY COMMAND view ${mountains})
airlight_cli_test("view: a file that is no camera path is told and left alone" EXIT 1 ERR "misspelt.toml:[0-9]+: camera is no key"
  COMMAND view ${mountains} --path ${CMAKE_CURRENT_SOURCE_DIR}/../corpus/scene/misspelt.toml)
find_program(AIRLIGHT_XVFB xvfb-run)
if(NOT AIRLIGHT_XVFB)
  message(STATUS "xvfb-run is absent: no test opens a window")
  return()
endif()
set(screen ${AIRLIGHT_XVFB} -a -s "-screen 0 1280x800x24")
airlight_cli_test("view: a scene is shown in a window, and says who drew it in what time"
  OUT "^quantity,value,unit$" "^device,\".+\",$" "^pass terrain,[0-9.]+,ms$" "^pass exposure,[0-9.]+,ms$" "^pass tone,[0-9.]+,ms$" "^file,window.png,$"
  UNDER ${screen} COMMAND view ${mountains} ${view_small} --frames 2 --screenshot window.png)
airlight_cli_test("view: the example of its help runs" UNDER ${screen}
  COMMAND view --frames 2 --width 160 --height 90 --sizes 16x4x8x12,32x16 --orders 2 --cache tables)
airlight_cli_test("view: a display without OpenGL 4.5 is one clear message" EXIT 1 ERR "^airlight view: the display offers no window with OpenGL 4.5: "
  UNDER env MESA_GL_VERSION_OVERRIDE=4.3 ${screen} COMMAND view ${mountains})
airlight_cli_test("view: a raster without georeference is told" EXIT 1 ERR "ground/no-place.pgm: it does not say where on the planet it lies"
  UNDER ${screen} COMMAND view ${CMAKE_CURRENT_SOURCE_DIR}/ground/no-place.toml)
add_test(NAME "cli: view: what is broken while it is shown is told, and the viewer goes on"
         COMMAND ${screen} ${CMAKE_CURRENT_SOURCE_DIR}/broken_while_shown $<TARGET_FILE:airlight> ${PROJECT_SOURCE_DIR}/data/demo/mountains.toml
                 ${PROJECT_SOURCE_DIR})
set_tests_properties("cli: view: what is broken while it is shown is told, and the viewer goes on" PROPERTIES TIMEOUT 300 RESOURCE_LOCK screen)
