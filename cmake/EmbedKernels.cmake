# Turns every kernels/**/*.cl into a string in one generated source: the program needs no files at run time.
file(GLOB_RECURSE kernel_files CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/kernels ${PROJECT_SOURCE_DIR}/kernels/*.cl)
set(PELAGE_EMBEDDED_KERNELS ${PROJECT_BINARY_DIR}/generated/embedded_kernels.cpp)
list(TRANSFORM kernel_files PREPEND ${PROJECT_SOURCE_DIR}/kernels/ OUTPUT_VARIABLE kernel_paths)
add_custom_command(
  OUTPUT ${PELAGE_EMBEDDED_KERNELS}
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${PELAGE_EMBEDDED_KERNELS} -DROOT=${PROJECT_SOURCE_DIR}/kernels
          "-DFILES=${kernel_files}" -P ${PROJECT_SOURCE_DIR}/cmake/WriteKernels.cmake
  DEPENDS ${kernel_paths} ${PROJECT_SOURCE_DIR}/cmake/WriteKernels.cmake
  COMMENT "Embedding kernels"
  VERBATIM)
