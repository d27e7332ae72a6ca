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

# The table of reactions, from what stands in kernels/models and reference/models and from nothing else.
set(generated ${PROJECT_BINARY_DIR}/generated)
set(PELAGE_MODEL_TABLE ${generated}/model_lines.cpp)
set(PELAGE_MODEL_TYPES ${generated}/reference_models.hpp)
set(PELAGE_MODEL_WORDS ${generated}/models.dict)
file(GLOB model_files CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/kernels/models/*.cl ${PROJECT_SOURCE_DIR}/reference/models/*.hpp)
add_custom_command(
  OUTPUT ${generated}/models.stamp
  BYPRODUCTS ${PELAGE_MODEL_TABLE} ${PELAGE_MODEL_TYPES} ${PELAGE_MODEL_WORDS}
  COMMAND ${CMAKE_COMMAND} -DLINES=${PELAGE_MODEL_TABLE} -DREFERENCES=${PELAGE_MODEL_TYPES} -DWORDS=${PELAGE_MODEL_WORDS}
          -DKERNELS=${PROJECT_SOURCE_DIR}/kernels/models -DREFERENCE=${PROJECT_SOURCE_DIR}/reference/models
          "-DFILES=${model_files}"
          -P ${PROJECT_SOURCE_DIR}/cmake/WriteModels.cmake
  COMMAND ${CMAKE_COMMAND} -E touch ${generated}/models.stamp
  DEPENDS ${model_files} ${PROJECT_SOURCE_DIR}/cmake/WriteModels.cmake ${PROJECT_SOURCE_DIR}/cmake/Tables.cmake
  COMMENT "Listing reaction models"
  VERBATIM)
add_custom_target(pelage_models DEPENDS ${generated}/models.stamp)

# The table of elementary functions, likewise from kernels/functions and reference/functions.
set(PELAGE_FUNCTION_TABLE ${generated}/function_table.cpp)
set(PELAGE_FUNCTION_CODE ${generated}/reference_functions.hpp)
file(GLOB function_files CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/kernels/functions/*.cl ${PROJECT_SOURCE_DIR}/reference/functions/*.hpp)
add_custom_command(
  OUTPUT ${generated}/functions.stamp
  BYPRODUCTS ${PELAGE_FUNCTION_TABLE} ${PELAGE_FUNCTION_CODE}
  COMMAND ${CMAKE_COMMAND} -DTABLE=${PELAGE_FUNCTION_TABLE} -DREFERENCES=${PELAGE_FUNCTION_CODE}
          -DKERNELS=${PROJECT_SOURCE_DIR}/kernels/functions -DREFERENCE=${PROJECT_SOURCE_DIR}/reference/functions
          "-DFILES=${function_files}"
          -P ${PROJECT_SOURCE_DIR}/cmake/WriteFunctions.cmake
  COMMAND ${CMAKE_COMMAND} -E touch ${generated}/functions.stamp
  DEPENDS ${function_files} ${PROJECT_SOURCE_DIR}/cmake/WriteFunctions.cmake ${PROJECT_SOURCE_DIR}/cmake/Tables.cmake
  COMMENT "Listing elementary functions"
  VERBATIM)
add_custom_target(pelage_functions DEPENDS ${generated}/functions.stamp)
