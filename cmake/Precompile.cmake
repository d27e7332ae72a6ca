# A build from scratch in half the time: headers that most files read are parsed once, and tests are optimised little.
# Not under a launcher: ccache would no longer find anything.
if(CMAKE_CXX_COMPILER_LAUNCHER)
  set(PELAGE_QUICK_BUILD OFF)
else()
  set(PELAGE_QUICK_BUILD ON)
endif()

# g++ 12 forgets in precompiled headers that the standard library is not ours, and shows its false alarms.
function(pelage_silence target)
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread>)
endfunction()

function(pelage_precompile target)
  if(PELAGE_QUICK_BUILD)
    target_precompile_headers(${target} PRIVATE ${ARGN})
    pelage_silence(${target})
  endif()
endfunction()

# With the headers of another target that has the same flags.
function(pelage_precompile_as target other)
  if(PELAGE_QUICK_BUILD)
    target_precompile_headers(${target} REUSE_FROM ${other})
    pelage_silence(${target})
  endif()
endfunction()
