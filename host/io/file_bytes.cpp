// See file_bytes.hpp.
#include "io/file_bytes.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace pelage {

std::string system_reason(int error_number) { return std::generic_category().message(error_number); }

std::string read_file(const std::filesystem::path& path) {
    std::error_code code;
    const auto status = std::filesystem::status(path, code);
    if (code) throw Error(fmt::format("cannot read '{}': {}", path.string(), code.message()));
    if (!std::filesystem::is_regular_file(status)) {
        throw Error(fmt::format("cannot read '{}': it is not a plain file", path.string()));
    }
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) throw Error(fmt::format("cannot read '{}': {}", path.string(), system_reason(errno)));
    std::string bytes(std::filesystem::file_size(path, code), '\0');
    if (code) throw Error(fmt::format("cannot read '{}': {}", path.string(), code.message()));
    bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
    if (std::ferror(file.get()) != 0)
        throw Error(fmt::format("cannot read '{}': {}", path.string(), system_reason(errno)));
    return bytes;
}

}  // namespace pelage
