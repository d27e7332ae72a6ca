// See cache.hpp. A file holds: magic, length of key, length of binary, checksum of both, key, binary.
#include "opencl/device/cache.hpp"

#include "core/error.hpp"
#include "io/atomic_file.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string_view>

namespace pelage {

namespace {

constexpr std::string_view cache_magic = "pelage compiled program 1\n";

// FNV-1a, 64 bits.
std::uint64_t hash(std::string_view bytes, std::uint64_t value = 0xcbf29ce484222325u) {
    for (const char byte : bytes) {
        value = (value ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
    }
    return value;
}

// Lengths before contents: no two keys give one text.
std::string key_text(const CacheKey& key) {
    std::string text;
    for (const std::string* part :
         {&key.device, &key.device_version, &key.driver, &key.platform, &key.options, &key.source}) {
        text += fmt::format("{}\n", part->size()) + *part + "\n";
    }
    return text;
}

std::string entry_text(const CacheKey& key, const Binary& binary) {
    const std::string body = key_text(key) + std::string(binary.begin(), binary.end());
    return fmt::format("{}{:016x} {:016x} {:016x}\n", cache_magic, body.size() - binary.size(), binary.size(),
                       hash(body)) +
           body;
}

std::optional<std::string> contents(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return {};
    std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (file.bad()) return {};
    return text;
}

}  // namespace

std::filesystem::path cache_folder() {
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return std::filesystem::path(value == nullptr ? "" : value);
    };
    if (const auto own = variable("PELAGE_CACHE"); !own.empty()) return own;
    if (const auto xdg = variable("XDG_CACHE_HOME"); !xdg.empty()) return xdg / "pelage";
    if (const auto home = variable("HOME"); !home.empty()) return home / ".cache" / "pelage";
    return {};
}

std::filesystem::path cache_file(const std::filesystem::path& folder, const CacheKey& key) {
    const std::string text = key_text(key);
    return folder / fmt::format("{:016x}{:016x}.bin", hash(text), hash(text, 0x9e3779b97f4a7c15u));
}

std::optional<Binary> load_cached(const std::filesystem::path& folder, const CacheKey& key) {
    if (folder.empty()) return {};
    const auto found = contents(cache_file(folder, key));
    if (!found) return {};
    const std::string expected_key = key_text(key);
    const std::size_t head = cache_magic.size() + 3 * 17;
    if (found->size() < head + expected_key.size()) return {};
    const Binary binary(found->begin() + static_cast<std::ptrdiff_t>(head + expected_key.size()), found->end());
    if (*found != entry_text(key, binary)) return {};
    return binary;
}

bool store_cached(const std::filesystem::path& folder, const CacheKey& key, const Binary& binary) {
    if (folder.empty()) return false;
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    try {
        write_file(cache_file(folder, key), entry_text(key, binary));
        return true;
    } catch (const Error&) {
        return false;
    }
}

}  // namespace pelage
