// The text at the head of an .npy file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pelage {

struct NpyHeader {
    std::string descr;  // "<f4"
    bool fortran_order = false;
    std::vector<std::size_t> shape;
};

// Reads the Python dictionary {'descr': '<f4', 'fortran_order': False, 'shape': (3, 4), }. Throws Error with `name`,
// the file's, when it is anything else.
NpyHeader parse_npy_header(std::string_view text, std::string_view name);

}  // namespace pelage
