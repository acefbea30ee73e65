# With -DAIRLIGHT_GPU=OFF the project configures, and nothing in the build names an OpenGL library.
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND ${CMAKE_COMMAND} -S ${ROOT} -B ${WORK} -G Ninja -DCMAKE_CXX_COMPILER=${COMPILER}
                        -DAIRLIGHT_GPU=OFF -DAIRLIGHT_ISA=plain
                RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(failed)
  message(FATAL_ERROR "${output}")
endif()
file(STRINGS ${WORK}/build.ninja lines REGEX "epoxy|libEGL|-lEGL")
if(lines)
  message(FATAL_ERROR "the build without OpenGL names it:\n${lines}")
endif()
