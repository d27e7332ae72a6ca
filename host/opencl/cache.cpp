// See cache.hpp. A file holds: magic, length of key, length of binary, checksum of both, key, binary.
#include "opencl/cache.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string_view>

namespace pelage {

namespace {

constexpr std::string_view magic = "pelage compiled program 1\n";

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
    return fmt::format("{}{:016x} {:016x} {:016x}\n", magic, body.size() - binary.size(), binary.size(), hash(body)) +
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
    const std::size_t head = magic.size() + 3 * 17;
    if (found->size() < head + expected_key.size()) return {};
    const Binary binary(found->begin() + static_cast<std::ptrdiff_t>(head + expected_key.size()), found->end());
    if (*found != entry_text(key, binary)) return {};
    return binary;
}

bool store_cached(const std::filesystem::path& folder, const CacheKey& key, const Binary& binary) {
    if (folder.empty()) return false;
    static std::atomic<unsigned> count{0};
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    const std::filesystem::path place = cache_file(folder, key);
    std::filesystem::path aside = place;
    aside += fmt::format(".{}.{}", ::getpid(), count++);
    {
        std::ofstream file(aside, std::ios::binary);
        const std::string text = entry_text(key, binary);
        file.write(text.data(), static_cast<std::streamsize>(text.size()));
        if (!file.flush()) {
            file.close();
            std::filesystem::remove(aside, failure);
            return false;
        }
    }
    std::filesystem::rename(aside, place, failure);
    if (!failure) return true;
    std::error_code ignored;
    std::filesystem::remove(aside, ignored);
    return false;
}

}  // namespace pelage
