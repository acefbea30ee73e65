# The program of `make figures`.
set(figure_folder ${CMAKE_CURRENT_BINARY_DIR}/figures)
file(MAKE_DIRECTORY ${figure_folder})
add_test(NAME "cli: figures: one is computed, and its table named" WORKING_DIRECTORY ${figure_folder}
         COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/run_case --out "^made/mean_density.csv$" -- $<TARGET_FILE:airlight_draw_figure> mean_density --small -o made)
add_test(NAME "cli: figures: an unknown one is refused with the names of all" WORKING_DIRECTORY ${figure_folder}
         COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/run_case --exit 1 --err "\"moonshine\" is no figure" --err "^  mie_scale_height " -- $<TARGET_FILE:airlight_draw_figure> moonshine -o made)
add_test(NAME "cli: figures: no name is wrong usage" WORKING_DIRECTORY ${figure_folder}
         COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/run_case --exit 2 --err "name is required" -- $<TARGET_FILE:airlight_draw_figure> -o made)
