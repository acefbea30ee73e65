airlight_cli_help(compare)
set(small --suns 40 --wavelengths 450,550,650 --paths 128 --size 0 --quiet)
airlight_cli_test("compare: a row a model, and the files"
  OUT "^air,model,answered,asked,relative_rmse_percent," "^earth-hazy over snow,preetham1999,1,1,[0-9.]+,[0-9.]+," "^# judged/report\\.html$" "^# judged/scores\\.csv$" "^# judged/scores\\.json$" "^# models\\.md$"
  COMMAND compare --atmosphere earth-hazy --ground snow --models preetham1999 ${small} -o judged --table models.md)
airlight_cli_test("compare: a model that cannot answer has no number" OUT "^earth-clear,preetham1999,0,1,,,,,$"
  COMMAND compare --models preetham1999 --eyes-m 10000 --turbidity 2 ${small} -o refused)
airlight_cli_test("compare: an unknown model is refused" EXIT 1 ERR "^--models: \"preetam1999\" is no model$" "Did you mean preetham1999\\?"
  COMMAND compare --models preetam1999 -o judged)
airlight_cli_test("compare: an unknown ground is refused" EXIT 1 ERR "^--ground: \"gras\" is no ground$" COMMAND compare --ground gras -o judged)
airlight_cli_test("compare: an unknown truth is refused" EXIT 1 ERR "^--against: \"guess\" is none of: reference tables measured:FILE$" COMMAND compare --against guess -o judged)
airlight_cli_test("compare: an eye below the ground is refused" EXIT 1 ERR "^eye altitude: -1 m is below the ground" COMMAND compare --eyes-m=-1 -o judged)
airlight_cli_test("compare: data of no model is refused" EXIT 1 ERR "^--data: \"set.csv\" does not name a model and its file$" COMMAND compare --data set.csv -o judged)
airlight_cli_test("compare: wavelengths without data are refused" EXIT 1 ERR "^earth-clear: " COMMAND compare --wavelengths 100,200 -o judged)
airlight_cli_test("compare: no folder is wrong usage" EXIT 2 ERR "^airlight compare: -o,--output is required|--output is required" COMMAND compare)
set(day ${CMAKE_CURRENT_BINARY_DIR}/measured-day.csv)
file(WRITE ${day} "# made up\ntime,sun_zenith_deg,sun_azimuth_deg,view_zenith_deg,view_azimuth_deg,450,550\n09h,40,90,10,100,0.1,0.1\n09h,40,90,30,200,0.1,0.1\n")
airlight_cli_test("compare: a measured sky is a truth" OUT "^earth-hazy,preetham1999,1,1,[0-9.]+,0.000," COMMAND compare --atmosphere earth-hazy --models preetham1999 --against measured:${day} ${small} -o measured)
set(column ${CMAKE_CURRENT_BINARY_DIR}/measured-column.csv)
file(WRITE ${column} "time,sun_zenith_deg,view_zenith_deg,view_azimuth_deg,450,550\n09h,40,10,100,0.1,0.1\n")
airlight_cli_test("compare: a measured file with a missing column is refused by its name and place" EXIT 1
  ERR "measured-column\\.csv:1: the column sun_azimuth_deg is missing from the head$" COMMAND compare --against measured:${column} -o measured)
add_test(NAME "cli: compare: an interrupted comparison goes on, and a damaged truth is computed again"
         COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/interrupted_compare $<TARGET_FILE:airlight>)
