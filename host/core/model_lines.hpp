// What the kernel files of the reaction models say of themselves; the build writes it down (cmake/WriteModels.cmake).
#pragma once

#include <string>
#include <vector>

namespace pelage {

struct ModelLine {
    std::string file;  // "gray_scott", of kernels/models/gray_scott.cl
    std::string text;  // "model gray-scott | u 0.5 to 1, v 0.05 to 0.45 | f 0 to 0.125, k 0 to 0.125"
};

const std::vector<ModelLine>& model_lines();

}  // namespace pelage
