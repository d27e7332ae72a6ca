// Whole files in memory, and numbers in them: every reader of the house starts here.
#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <string>

namespace pelage {

static_assert(std::endian::native == std::endian::little,
              "our binary files are little-endian and written as memory holds them");

// All bytes of a regular file. Throws Error naming the file and the system's reason.
std::string read_file(const std::filesystem::path&);

// A number from unaligned memory.
template <class T>
T load(const char* from) {
    T value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

// What errno says of the last call, in words.
std::string system_reason(int error_number);

}  // namespace pelage
