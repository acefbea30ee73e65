airlight_cli_help(fit)
set(small_fit --wavelengths 550 --albedos 0.2 --sizes 8x4x8x8 --orders 2 --cache tables -o fit.csv)
airlight_cli_test("fit: a model that cannot be fitted is refused" EXIT 1 ERR "^\"moonshine\" is no model that can be fitted$" "^  Models are: perez dobashi1997 preetham oneil2005 hipiny2006 hosek\\.$"
  COMMAND fit moonshine --atmosphere earth-clear ${small_fit})
airlight_cli_test("fit: a truth that is none is refused" EXIT 1 ERR "^--against: \"opinion\" is neither tables nor reference$"
  COMMAND fit hosek --atmosphere earth-clear --against opinion ${small_fit})
airlight_cli_test("fit: turbidities that do not rise are refused" EXIT 1 ERR "^--turbidities: 2 does not lie above the number before it$"
  COMMAND fit hosek --atmosphere earth-clear --turbidities 4,2 ${small_fit})
airlight_cli_test("fit: a turbidity of air without aerosol is refused" EXIT 1 ERR "^earth-rayleigh: has no aerosol, so its turbidity cannot be 2$"
  COMMAND fit hosek --atmosphere earth-rayleigh --turbidities 1,2 ${small_fit})
airlight_cli_test("fit: a file in a folder that is not there is refused before the fit" EXIT 1 ERR "^absent/fit\\.csv: cannot be written: No such file"
  COMMAND fit hosek --atmosphere earth-clear -o absent/fit.csv)
airlight_cli_test("fit: no output is wrong usage" EXIT 2 ERR "^airlight fit: --output is required$" COMMAND fit hosek --atmosphere earth-clear)
airlight_cli_test("fit: what a model does not take is refused" EXIT 1 ERR "^--albedos: is nothing that a fit of perez1993 takes$"
  COMMAND fit perez --atmosphere earth-clear ${small_fit})
airlight_cli_test("fit: several altitudes of a model of one are refused" EXIT 1 ERR "^--altitude-m: has several altitudes"
  COMMAND fit hosek --atmosphere earth-clear --altitude-m 0,2000 ${small_fit})
airlight_cli_test("fit: an altitude above the air is refused" EXIT 1 ERR "^--altitude-m: 200000 is out of range: it must be 0 to"
  COMMAND fit hosek --atmosphere earth-clear --altitude-m 200000 ${small_fit})
airlight_cli_test("fit: a basis that is none is refused" EXIT 1 ERR "^--variant: \"waves\" is no basis: they are cosines, samples, harmonics$"
  COMMAND fit dobashi1997 --atmosphere earth-clear --variant waves -o fit.csv)
airlight_cli_test("fit: an error of one is refused" EXIT 1 ERR "^--error: 1 is out of range: it must be above 0 and below 1$"
  COMMAND fit dobashi1997 --atmosphere earth-clear --error 1 -o fit.csv)
airlight_cli_test("fit: the residual is printed" OUT "^condition,relative_rms$" "^\"suns between\",0\\.[0-9]+$"
  COMMAND fit perez --atmosphere mars --altitude-m 20000 --wavelengths 550 --sizes 8x4x8x8 --orders 2 --cache tables -o fit.csv)
airlight_cli_test("fit: a fit of the air alone needs no sky" OUT "^\"optical length, aerosol\",0\\.0" COMMAND fit oneil2005 --atmosphere mars -o fit.csv)
add_test(NAME "cli: fit: a fit that is stopped or killed goes on, and ends in the same file"
         COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/interrupted_fit $<TARGET_FILE:airlight>)
set(ranks "cli: fit: three ranks, one of them killed, go on as two and end in the same file as one process")
if(AIRLIGHT_MPI)
  add_test(NAME "${ranks}" COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/interrupted_fit $<TARGET_FILE:airlight> ${MPIEXEC_EXECUTABLE})
else()
  add_test(NAME "${ranks}" COMMAND ${CMAKE_COMMAND} -E echo "[skipped] built without MPI (-D AIRLIGHT_MPI=ON)")
  set_tests_properties("${ranks}" PROPERTIES SKIP_REGULAR_EXPRESSION "\\[skipped\\]")
endif()
