# Writes the table of elementary functions, run by EmbedKernels.cmake:
#   TABLE       host/core/functions.hpp's table, from the declarations at the heads of KERNELS/*.cl
#   REFERENCES  the reference's functions, REFERENCE/*.hpp; a file xy.hpp there defines a template xy<T>
# FILES are those of both folders: named in the command, so that it runs again when one is gone.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/Tables.cmake)
pelage_pair_files(function)

# "a, b" becomes "\"a\", \"b\"" in OUT; what is no list of names stops the build.
function(quote_names kernel names out)
  string(STRIP "${names}" names)
  if(NOT names MATCHES "^([a-z][a-z0-9_]*(, *[a-z][a-z0-9_]*)*)?$")
    message(FATAL_ERROR "${kernel}:1: names with commas between them are wanted; found '${names}'")
  endif()
  string(REGEX REPLACE "([a-z][a-z0-9_]*)" "\"\\1\"" names "${names}")
  set(${out} "${names}" PARENT_SCOPE)
endfunction()

foreach(kernel IN LISTS kernels)
  get_filename_component(name ${kernel} NAME_WE)
  file(STRINGS ${kernel} line LIMIT_COUNT 1)
  if(line MATCHES "^//@ function ${name} ([^|]+)(\\| needs ([^|]+))?$")
    set(parameters "${CMAKE_MATCH_1}")
    set(needs "${CMAKE_MATCH_3}")
    set(kind functions)
  elseif(line MATCHES "^//@ part *(\\| needs ([^|]+))?$")
    set(parameters "")
    set(needs "${CMAKE_MATCH_2}")
    set(kind parts)
  else()
    message(FATAL_ERROR "${kernel}:1: a function's kernel file begins with '//@ function ${name} PARAMETER, ...' or "
      "'//@ part', each with '| needs OTHER, ...' where other files must come before it; found '${line}'")
  endif()
  string(REPLACE "," ";" needed "${needs}")
  foreach(other IN LISTS needed)
    string(STRIP "${other}" other)
    if(NOT EXISTS ${KERNELS}/${other}.cl)
      message(FATAL_ERROR "${kernel}:1: it needs '${other}', and there is no ${KERNELS}/${other}.cl")
    endif()
  endforeach()
  quote_names(${kernel} "${parameters}" quoted_parameters)
  quote_names(${kernel} "${needs}" quoted_needs)
  string(APPEND ${kind} "        {\"${name}\", {${quoted_parameters}}, {${quoted_needs}}},\n")
  if(kind STREQUAL "functions")
    string(REPLACE "," ";" parameters "${parameters}")
    list(LENGTH parameters count)
    set(arguments)
    math(EXPR last "${count} - 1")
    foreach(place RANGE ${last})
      list(APPEND arguments "a[${place}]")
    endforeach()
    list(JOIN arguments ", " arguments)
    pelage_type_name(${name} type)
    list(APPEND types ${type})
    string(APPEND includes "#include \"reference/functions/${name}.hpp\"\n")
    string(APPEND structs "struct ${type} {\n    static constexpr std::size_t parameters = ${count};\n"
      "    template <class T>\n    static T of(const T* a) {\n        return functions::${name}<T>(${arguments});\n    }\n};\n\n")
  endif()
endforeach()

set(table "// Made by cmake/WriteFunctions.cmake from kernels/functions.\n#include \"core/functions.hpp\"\n\nnamespace pelage {\n\n")
foreach(kind functions parts)
  string(REGEX REPLACE "s$" "" one ${kind})
  string(APPEND table "const std::vector<FunctionFacts>& ${one}_table() {\n"
    "    static const auto& table = *new const std::vector<FunctionFacts>{\n${${kind}}    };\n    return table;\n}\n\n")
endforeach()
string(APPEND table "}  // namespace pelage\n")

list(JOIN types ", " types)
string(CONCAT code "// Made by cmake/WriteFunctions.cmake from reference/functions and the first lines of kernels/functions.\n#pragma once\n\n"
  "${includes}\n#include <cstddef>\n#include <tuple>\n\nnamespace pelage::reference {\n\n"
  "${structs}using Functions = std::tuple<${types}>;\n\n}  // namespace pelage::reference\n")

pelage_write(${TABLE} "${table}")
pelage_write(${REFERENCES} "${code}")
