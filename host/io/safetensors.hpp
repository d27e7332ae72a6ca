// Arrays in a safetensors file: 8 bytes of length, a JSON object of names, types, shapes and places, then the numbers.
#pragma once

#include "io/npy.hpp"

#include <map>
#include <string>
#include <string_view>

namespace pelage {

// Whether a file may be one: it has no magic number.
bool looks_like_safetensors(std::string_view bytes);

// All its arrays by name; their types are F32 or F64. Throws Error with the file's `name` on anything else.
std::map<std::string, NpyArray> parse_safetensors(std::string_view bytes, const std::string& name);

}  // namespace pelage
