# Has clang-tidy-14 look at the library, its tools and the reference, a folder in one go, with the
# checks of clang's analyzer. Called with SOURCE, WORK and GENERATOR.
find_program(TIDY clang-tidy-14)
find_program(COMPILER clang++-14)
if(NOT TIDY OR NOT COMPILER)
  message("SKIPPED: clang-tidy-14 (or clang++-14) is not there")
  return()
endif()

# A build of its own: precompiled headers of g++ are nothing to clang.
execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK} -G ${GENERATOR} -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER=${COMPILER}
          -DCMAKE_UNITY_BUILD=ON -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DPELAGE_TESTS=OFF -DPELAGE_INSTALL=OFF
  OUTPUT_VARIABLE log ERROR_VARIABLE log RESULT_VARIABLE code)
if(code)
  message(FATAL_ERROR "no build could be configured in ${WORK}:\n${log}")
endif()
execute_process(
  COMMAND ${CMAKE_COMMAND} --build ${WORK} --target pelage_models pelage_functions pelage_public_headers
  OUTPUT_VARIABLE log ERROR_VARIABLE log RESULT_VARIABLE code)
if(code)
  message(FATAL_ERROR "what is generated could not be:\n${log}")
endif()

file(GLOB_RECURSE units ${WORK}/CMakeFiles/*.dir/Unity/unity_*.cxx)
list(FILTER units INCLUDE REGEX "unity_(host|reference)_")
list(LENGTH units count)
if(count LESS 20)
  message(FATAL_ERROR "only ${count} folders were found in ${WORK}")
endif()
list(SORT units)
set(wrong 0)
foreach(unit IN LISTS units)
  execute_process(
    COMMAND ${TIDY} --quiet -p ${WORK} "--config={}" "--checks=-*,clang-analyzer-*,-clang-analyzer-security.FloatLoopCounter" "--warnings-as-errors=*" "--header-filter=^${SOURCE}/(host|reference)/" ${unit}
    OUTPUT_VARIABLE said ERROR_VARIABLE log RESULT_VARIABLE code)
  if(code)
    math(EXPR wrong "${wrong} + 1")
    message("${said}${log}")
  endif()
endforeach()
if(wrong)
  message(FATAL_ERROR "clang-tidy finds something in ${wrong} of ${count} folders")
endif()
message("clang-tidy finds nothing in ${count} folders")
