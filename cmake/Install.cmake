# Installs the library, its public headers and the command, so that find_package(pelage) works.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/pelage)

install(TARGETS pelage EXPORT pelage_targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT pelage_targets NAMESPACE pelage:: DESTINATION ${package_folder})
if(PELAGE_TOOLS)
  install(TARGETS pelage_command RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  if(TARGET pelage_plot)
    install(TARGETS pelage_plot RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  endif()
  if(TARGET pelage_mpi)
    install(TARGETS pelage_mpi LIBRARY DESTINATION ${CMAKE_INSTALL_BINDIR})
  endif()
  include(cmake/Pages.cmake)
endif()

install(DIRECTORY ${PELAGE_PUBLIC_INCLUDE}/pelage DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

configure_package_config_file(cmake/pelageConfig.cmake.in ${PROJECT_BINARY_DIR}/pelageConfig.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/pelageConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/pelageConfig.cmake ${PROJECT_BINARY_DIR}/pelageConfigVersion.cmake
  DESTINATION ${package_folder})
