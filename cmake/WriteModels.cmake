# Writes the table of reactions, run by EmbedKernels.cmake:
#   LINES       the declarations at the heads of KERNELS/*.cl
#   REFERENCES  the reference's models, REFERENCE/*.hpp; a file x_y.hpp there defines a struct XY
#   WORDS       their words and their parameters' names, a line each, quoted as libFuzzer's dictionaries are
# FILES are those of both folders: named in the command, so that it runs again when one is gone.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/Tables.cmake)
pelage_pair_files(model)

set(lines "// Made by cmake/WriteModels.cmake from kernels/models.\n#include \"core/model_lines.hpp\"\n\nnamespace pelage {\n\n")
string(APPEND lines "const std::vector<ModelLine>& model_lines() {\n")
string(APPEND lines "    static const auto& lines = *new const std::vector<ModelLine>{\n")
foreach(kernel IN LISTS kernels)
  get_filename_component(name ${kernel} NAME_WE)
  file(STRINGS ${kernel} line LIMIT_COUNT 1)
  if(NOT line MATCHES "^//@ (model ([^|]*[^| ]) *\\|([^|]*)\\|([^|]*))$")
    message(FATAL_ERROR "${kernel}:1: a model's kernel file begins with '//@ model WORD | SPECIES LOW to HIGH, ... | "
      "PARAMETER LOW to HIGH, ...' (see kernels/rules/reaction.cl); found '${line}'")
  endif()
  set(declaration "${CMAKE_MATCH_1}")
  set(word "${CMAKE_MATCH_2}")
  string(STRIP "${CMAKE_MATCH_4}" parameters)
  string(REPLACE "," ";" species "${CMAKE_MATCH_3}")
  string(REPLACE "," ";" parameters "${parameters}")
  list(LENGTH species species_count)
  list(LENGTH parameters parameter_count)
  string(APPEND lines "        {\"${name}\", R\"__line__(${declaration})__line__\"},\n")

  string(APPEND words "\"${word}\"\n")
  foreach(parameter IN LISTS parameters)
    string(REGEX MATCH "[^ ]+" parameter "${parameter}")
    string(APPEND words "\"${parameter}\"\n")
  endforeach()

  pelage_type_name(${name} type)
  list(APPEND types ${type})
  string(APPEND includes "#include \"reference/models/${name}.hpp\"\n")
  string(APPEND checks "static_assert(${type}::word == \"${word}\" && ${type}::species == ${species_count} && "
    "${type}::parameters == ${parameter_count},\n"
    "              \"word, species and parameters of reference/models/${name}.hpp are those of the first line of \"\n"
    "              \"kernels/models/${name}.cl\");\n")
endforeach()
string(APPEND lines "    };\n    return lines;\n}\n\n}  // namespace pelage\n")

list(JOIN types ", " types)
set(models "// Made by cmake/WriteModels.cmake from reference/models and the first lines of kernels/models.\n#pragma once\n\n")
string(APPEND models "${includes}\n#include <tuple>\n\nnamespace pelage::reference {\n\n${checks}\n")
string(APPEND models "using Models = std::tuple<${types}>;\n\n}  // namespace pelage::reference\n")

pelage_write(${LINES} "${lines}")
pelage_write(${REFERENCES} "${models}")
pelage_write(${WORDS} "${words}")
