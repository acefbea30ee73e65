# cmake --install gives a package that find_package(airlight) finds: airlight::<module> for each module,
# and airlight::airlight for all of them. Headers go to include/airlight/<module>/.

include(CMakePackageConfigHelpers)

get_property(modules GLOBAL PROPERTY AIRLIGHT_MODULES)
add_library(airlight_airlight INTERFACE)
set_target_properties(airlight_airlight PROPERTIES EXPORT_NAME airlight)
set(targets airlight_airlight)
foreach(module IN LISTS modules)
  target_link_libraries(airlight_airlight INTERFACE airlight::${module})
  list(APPEND targets airlight_${module})
endforeach()

install(TARGETS ${targets} EXPORT airlight
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/airlight
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${CMAKE_INSTALL_INCLUDEDIR}/airlight)
install(TARGETS airlight RUNTIME)
install(DIRECTORY data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/airlight)
install(EXPORT airlight NAMESPACE airlight:: FILE airlight-targets.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/airlight)
configure_package_config_file(cmake/airlight-config.cmake.in ${PROJECT_BINARY_DIR}/airlight-config.cmake
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/airlight)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/airlight-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/airlight-config.cmake ${PROJECT_BINARY_DIR}/airlight-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/airlight)
