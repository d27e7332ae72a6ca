# Installs the library, its public headers and the command, so that find_package(pelage) works.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/pelage)

install(TARGETS pelage EXPORT pelage_targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT pelage_targets NAMESPACE pelage:: DESTINATION ${package_folder})
if(PELAGE_TOOLS)
  install(TARGETS pelage_command RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  include(cmake/Pages.cmake)
endif()

# Headers are included as "core/experiment.hpp", here and by users. Of the backends and the language only the doors
# are public; what lies behind them may change.
foreach(part core io)
  install(DIRECTORY host/${part} DESTINATION include/pelage FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(FILES host/language/lint.hpp host/language/outline.hpp host/language/parse.hpp DESTINATION include/pelage/language)
install(FILES host/opencl/backend.hpp host/opencl/device.hpp DESTINATION include/pelage/opencl)
install(FILES reference/backend.hpp reference/neighbours.hpp DESTINATION include/pelage/reference)

configure_package_config_file(cmake/pelageConfig.cmake.in ${PROJECT_BINARY_DIR}/pelageConfig.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/pelageConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/pelageConfig.cmake ${PROJECT_BINARY_DIR}/pelageConfigVersion.cmake
  DESTINATION ${package_folder})
