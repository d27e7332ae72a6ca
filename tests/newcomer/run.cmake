# Adds a reaction to a copy of the sources with two files, as CONTRIBUTING.md tells, and sees every part take it up; then with
# a wrong sign in its kernel, which `pelage verify` must name. Minutes long: the copy is built, and its tests of lists.
foreach(name SOURCE WORK GENERATOR COMPILER FLAGS)
  if(NOT DEFINED ${name})
    message(FATAL_ERROR "${name} is missing")
  endif()
endforeach()

function(run expected)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL expected)
    message(FATAL_ERROR "exit code ${result} instead of ${expected}: ${ARGN}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
foreach(part CMakeLists.txt CONTRIBUTING.md cmake host kernels reference docs tests)
  file(COPY ${SOURCE}/${part} DESTINATION ${WORK})
endforeach()

# Three species that compete: twelve parameters, more than any reaction here has.
file(WRITE ${WORK}/reference/models/three_rivals.hpp [[
// Competition of three species after Lotka and Volterra.
#pragma once

#include "reference/rules/flow.hpp"

#include <cstddef>
#include <string_view>

namespace pelage::reference {

struct ThreeRivals {
    static constexpr std::string_view word = "three-rivals";
    static constexpr std::size_t species = 3;
    static constexpr std::size_t parameters = 12;

    template <class T, class P>
    static Flow<T, 3> flow(T a, T b, T c, const P& p) {
        return {a * (((p[0] - p[3] * a) - p[4] * b) - p[5] * c), b * (((p[1] - p[6] * a) - p[7] * b) - p[8] * c),
                c * (((p[2] - p[9] * a) - p[10] * b) - p[11] * c)};
    }
};

}  // namespace pelage::reference
]])
set(kernel "//@ model three-rivals | a 0.1 to 0.9, b 0.1 to 0.9, c 0.1 to 0.9 | ")
string(APPEND kernel "ra 0.5 to 1.5, rb 0.5 to 1.5, rc 0.5 to 1.5")
set(arguments "real n, real s, real dt, real a, real b, real c, real ra, real rb, real rc")
foreach(pair aa ab ac ba bb bc ca cb cc)
  string(APPEND kernel ", ${pair} 0.5 to 2")
  string(APPEND arguments ", real ${pair}")
endforeach()
string(APPEND kernel "\n// Competition of three species after Lotka and Volterra.\n")
foreach(own a b c)
  string(APPEND kernel "\nstatic inline real three_rivals_${own}(${arguments}) {\n"
    "    return ADD_REACTION(n, s, ${own} * (((r${own} - ${own}a * a) - ${own}b * b) - ${own}c * c), dt);\n}\n")
endforeach()
file(WRITE ${WORK}/kernels/models/three_rivals.cl "${kernel}")

set(words "ra 1 rb 0.9 rc 1.1 aa 1 ab 1.5 ac 0.6 ba 0.6 bb 1 bc 1.5 ca 1.5 cb 0.6 cc 1")
file(WRITE ${WORK}/rivals.pex "
define chemical A
define chemical B
define chemical C
define time_step 0.1
use chemical A conc 0.5 dev 0.4 diff 0.1
use chemical B conc 0.5 dev 0.4 diff 0.1
use chemical C conc 0.5 dev 0.4 diff 0.1
create matrix 40 30 wrap
rule always react A B C three-rivals ${words}
stop at 50
")

# The language and both backends.
run(0 ${CMAKE_COMMAND} -S . -B build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}"
  -DCMAKE_BUILD_TYPE=Release)
run(0 ${CMAKE_COMMAND} --build build --target pelage_command test_language test_random_experiments test_house)
run(0 build/pelage check rivals.pex)
run(0 build/pelage run rivals.pex --backend reference --format npy --out reference-results)
run(0 build/pelage run rivals.pex --backend opencl --format npy --out opencl-results)
foreach(chemical A B C)
  run(0 ${CMAKE_COMMAND} -E compare_files reference-results/final.${chemical}.npy opencl-results/final.${chemical}.npy)
endforeach()
run(0 build/pelage verify --quick --filter reaction)
run(0 build/pelage verify --full --filter cells/three-rivals)
if(NOT output MATCHES "1 of 1 case")
  message(FATAL_ERROR "verify has no case of free cells for the new reaction:\n${output}")
endif()

# Lists: random experiments draw it, messages name it, and the page on the language asks for its row.
run(0 build/tests/test_random_experiments "Drawn texts*")
run(0 build/tests/test_house "*reaction*")
run(0 build/tests/test_language "*rules*")
run(1 build/tests/test_language "the page on the language*")
if(NOT output MATCHES "three-rivals")
  message(FATAL_ERROR "the test of docs/language.md does not name the new reaction:\n${output}")
endif()
file(READ ${WORK}/docs/language.md page)
string(REGEX REPLACE "( [0-9.]+)" " PAR" row "${words}")
string(REPLACE "| MODEL | f |\n|---|---|\n" "| MODEL | f |\n|---|---|\n| `three-rivals ${row}` | competition |\n" page "${page}")
file(WRITE ${WORK}/docs/language.md "${page}")
run(0 build/tests/test_language "the page on the language*")

# A wrong sign in the kernel.
string(REPLACE "((rb - ba * a) - bb * b)" "((rb - ba * a) + bb * b)" wrong "${kernel}")
file(WRITE ${WORK}/kernels/models/three_rivals.cl "${wrong}")
run(0 ${CMAKE_COMMAND} --build build --target pelage_command)
run(1 build/pelage verify --quick --filter reaction)
run(1 build/pelage verify --full --filter cells/three-rivals)
if(NOT output MATCHES "cells/three-rivals: failed")
  message(FATAL_ERROR "verify does not name the reaction with a wrong sign:\n${output}")
endif()
run(1 build/pelage run rivals.pex --backend opencl --out refused)

# A head that does not fit the reference's struct ends the build in a sentence.
string(REPLACE ", rc 0.5 to 1.5" "" wrong "${kernel}")
file(WRITE ${WORK}/kernels/models/three_rivals.cl "${wrong}")
execute_process(COMMAND ${CMAKE_COMMAND} --build build --target pelage WORKING_DIRECTORY ${WORK}
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(result EQUAL 0 OR NOT output MATCHES "those of the first line")
  message(FATAL_ERROR "a parameter that is left out is not told:\n${output}")
endif()

# Taken away again, it is gone from the table.
file(REMOVE ${WORK}/kernels/models/three_rivals.cl ${WORK}/reference/models/three_rivals.hpp)
run(0 ${CMAKE_COMMAND} --build build --target pelage_command)
run(2 build/pelage check rivals.pex)
file(REMOVE_RECURSE ${WORK})
