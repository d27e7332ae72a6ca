# Makes the sources in PELAGE a part of the project in SOURCE. FORM plan: looks at what ninja would build; FORM build:
# builds all of it and runs it.
set(work ${BUILD}/consumer-part-${FORM})
file(REMOVE_RECURSE ${work})
function(must)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
# As on a machine without what the command and the tests want beside the library; it goes unused where all is well.
must(${CMAKE_COMMAND} -S ${SOURCE} -B ${work} -G Ninja --no-warn-unused-cli -DCMAKE_BUILD_TYPE=Release -DPELAGE_SOURCES=${PELAGE}
  -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}" -DCAIRO_LIBRARY=CAIRO_LIBRARY-NOTFOUND
  -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON -DCMAKE_DISABLE_FIND_PACKAGE_Catch2=ON -DCMAKE_DISABLE_FIND_PACKAGE_OpenMP=ON
  -DCMAKE_IGNORE_PATH=/usr/include/cairo)
if(FORM STREQUAL "build")
  must(${CMAKE_COMMAND} --build ${work})
  must(${work}/consumer)
  return()
endif()

execute_process(COMMAND ${CMAKE_COMMAND} --build ${work} -- -t commands consumer OUTPUT_VARIABLE plan COMMAND_ERROR_IS_FATAL ANY)
foreach(wanted main.cpp host/language/parse.cpp -std=c++20)
  string(FIND "${plan}" "${wanted}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "${wanted} is missing from what is built:\n${plan}")
  endif()
endforeach()
foreach(unwanted host/app host/bench host/verify host/tune ${PELAGE}/tests/app catch2 cairo)
  string(FIND "${plan}" "${unwanted}" at)
  if(NOT at EQUAL -1)
    message(FATAL_ERROR "${unwanted} has no place in a library that is part of another project:\n${plan}")
  endif()
endforeach()
execute_process(COMMAND ${CMAKE_COMMAND} --install ${work} --prefix ${work}/installed OUTPUT_VARIABLE installed
  COMMAND_ERROR_IS_FATAL ANY)
if(EXISTS ${work}/installed)
  message(FATAL_ERROR "a part of another project installs files of its own:\n${installed}")
endif()
