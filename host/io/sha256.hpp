// SHA-256: names the bytes of an input file, so that `sha256sum FILE` tells whether it is still the same.
#pragma once

#include <string>
#include <string_view>

namespace pelage {

// 64 hexadecimal digits (FIPS 180-4).
std::string sha256(std::string_view bytes);

}  // namespace pelage
