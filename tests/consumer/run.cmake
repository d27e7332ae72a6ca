# Installs BUILD into a fresh folder, then builds and runs the project in SOURCE against that alone.
set(work ${BUILD}/consumer)
file(REMOVE_RECURSE ${work})
function(must)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
must(${CMAKE_COMMAND} --install ${BUILD} --prefix ${work}/installed)
must(${CMAKE_COMMAND} -S ${SOURCE} -B ${work}/build -G ${GENERATOR} -DCMAKE_BUILD_TYPE=Release
  -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}" -DCMAKE_PREFIX_PATH=${work}/installed)
must(${CMAKE_COMMAND} --build ${work}/build)
must(${work}/build/consumer)
