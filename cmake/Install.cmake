# Installs the library, its public headers and the command, so that find_package(pelage) works.
include(CMakePackageConfigHelpers)
install(TARGETS pelage EXPORT pelage_targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT pelage_targets NAMESPACE pelage:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/pelage)
foreach(part core language io opencl)
  install(DIRECTORY host/${part} DESTINATION include/pelage FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(DIRECTORY reference DESTINATION include/pelage FILES_MATCHING PATTERN "*.hpp")
if(TARGET pelage_command)
  install(TARGETS pelage_command RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
configure_package_config_file(cmake/pelageConfig.cmake.in ${CMAKE_BINARY_DIR}/pelageConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/pelage)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/pelageConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/pelageConfig.cmake ${CMAKE_BINARY_DIR}/pelageConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/pelage)
