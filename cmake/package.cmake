# For other CMake projects: find_package(Lumbricus) with Lumbricus_DIR this
# build folder, or after installation (cmake --install) wherever that is.
include(CMakePackageConfigHelpers)

set(_package ${CMAKE_INSTALL_LIBDIR}/cmake/Lumbricus)
set_target_properties(lumbricus_library PROPERTIES EXPORT_NAME lumbricus)
install(TARGETS lumbricus_library EXPORT LumbricusTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
set_target_properties(lumbricus PROPERTIES
  INSTALL_RPATH "\$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
install(TARGETS lumbricus RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY include/lumbricus DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

configure_package_config_file(cmake/LumbricusConfig.cmake.in LumbricusConfig.cmake
  INSTALL_DESTINATION ${_package})
write_basic_package_version_file(LumbricusConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
foreach(file setup_target.cmake check_linker.cmake add_plugin.cmake plugin_version.cc)
  configure_file(cmake/${file} ${file} COPYONLY)
  install(FILES cmake/${file} DESTINATION ${_package})
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/LumbricusConfig.cmake
  ${PROJECT_BINARY_DIR}/LumbricusConfigVersion.cmake
  DESTINATION ${_package})
install(EXPORT LumbricusTargets NAMESPACE Lumbricus:: DESTINATION ${_package})
export(EXPORT LumbricusTargets NAMESPACE Lumbricus::)
