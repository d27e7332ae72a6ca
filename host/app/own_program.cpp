// See own_program.hpp.
#include "app/own_program.hpp"

#include "io/checksum.hpp"
#include "io/file_bytes.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace pelage::app {

std::string own_checksum() {
    static const std::string known = [] {
        Checksum program;
        const std::string bytes = read_file(std::filesystem::canonical("/proc/self/exe"));
        program.add(bytes.data(), bytes.size());
        return fmt::format("{:016x}", program.value());
    }();
    return known;
}

}  // namespace pelage::app
