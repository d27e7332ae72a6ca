// NumPy arrays of floats in a Python pickle, as np.save() writes a list of arrays. A pickle is a program that may call
// anything; this reader carries out what makes arrays and refuses the rest.
#pragma once

#include "io/npy.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace pelage {

// What the pickle holds: an array of arrays, or a list or tuple of them; numbers are little-endian float16, float32 and
// float64. Protocols 2 to 5, nothing outside of the file. Throws Error with the file's `name` where it asks for
// anything else, saying for what, or is damaged.
std::vector<NpyArray> parse_pickled_arrays(std::string_view bytes, const std::string& name);

}  // namespace pelage
