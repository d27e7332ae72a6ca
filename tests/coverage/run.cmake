# Builds the command with counters, in a folder of its own, and asks whether `pelage verify --full` runs all of it. Minutes long.
foreach(name SOURCE BUILD PYTHON)
  if(NOT DEFINED ${name})
    message(FATAL_ERROR "${name} is missing")
  endif()
endforeach()

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${SOURCE} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "exit code ${result}: ${ARGN}")
  endif()
endfunction()

run(${CMAKE_COMMAND} --preset coverage -B ${BUILD})
run(${CMAKE_COMMAND} --build ${BUILD} --target pelage_command)
run(${PYTHON} tests/coverage/run.py --build ${BUILD})
