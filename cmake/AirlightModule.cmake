# airlight_module(): a library that sees its own headers and those of the modules it USES, and nothing else.
#
#   airlight_module(optics USES spectrum PACKAGES TBB::tbb SOURCES mie.cpp HEADERS mie.h)
#
#   USES      modules declared above this one; any other is refused, so no circle can be written
#   PACKAGES  library targets that its headers or sources include
#   SOURCES, HEADERS   files of this folder, relative to it
#
# Refused at configure time: a module not declared above; an #include of a module that is not in USES.
# Every header is compiled alone by the target all_verify_interface_header_sets.

set(CMAKE_VERIFY_INTERFACE_HEADER_SETS ON)
set_property(GLOBAL PROPERTY AIRLIGHT_MODULES "")

function(airlight_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES;PACKAGES;SOURCES;HEADERS")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "module ${name}: unknown words: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  get_property(declared GLOBAL PROPERTY AIRLIGHT_MODULES)
  foreach(used IN LISTS arg_USES)
    if(NOT used IN_LIST declared)
      message(FATAL_ERROR "module ${name} uses ${used}, which is not declared above it.\n"
                          "  A module may use only what stands above it in src/CMakeLists.txt, so that no circle can be written.")
    endif()
  endforeach()
  airlight_check_includes(${name} "${arg_USES}" ${arg_SOURCES} ${arg_HEADERS})

  if(arg_SOURCES)
    add_library(airlight_${name} STATIC ${arg_SOURCES})
    set(scope PUBLIC)
    target_link_libraries(airlight_${name} PRIVATE $<BUILD_INTERFACE:airlight_flags>)
  else()
    add_library(airlight_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(airlight::${name} ALIAS airlight_${name})
  set_target_properties(airlight_${name} PROPERTIES EXPORT_NAME ${name})
  get_filename_component(root ${CMAKE_CURRENT_SOURCE_DIR}/.. ABSOLUTE)
  target_sources(airlight_${name} ${scope} FILE_SET HEADERS BASE_DIRS ${root} FILES ${arg_HEADERS})
  list(TRANSFORM arg_USES PREPEND airlight::)
  target_link_libraries(airlight_${name} ${scope} ${arg_USES} ${arg_PACKAGES})
  target_compile_features(airlight_${name} ${scope} cxx_std_20)
  set_property(GLOBAL APPEND PROPERTY AIRLIGHT_MODULES ${name})
endfunction()

# Refuses an #include "other/..." of a project module that `name` does not say it uses.
function(airlight_check_includes name uses)
  foreach(file IN LISTS ARGN)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(STRINGS ${file} lines REGEX "^ *# *include *[\"<]")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^ *# *include *[\"<]([^\">]*)[\">].*" "\\1" included "${line}")
      string(REGEX REPLACE "/.*" "" module "${included}")
      if(NOT IS_DIRECTORY ${PROJECT_SOURCE_DIR}/src/${module} AND NOT module STREQUAL "physics")
        continue()
      endif()
      if(NOT module STREQUAL name AND NOT module IN_LIST uses)
        message(FATAL_ERROR "${CMAKE_CURRENT_SOURCE_DIR}/${file} includes \"${included}\", "
                            "but module ${name} does not say that it uses ${module}.\n"
                            "  Add ${module} to USES in its CMakeLists.txt, or do not include it.")
      endif()
    endforeach()
  endforeach()
endfunction()
