// Compiled programs kept on disk. An entry that is missing, damaged, stale or unreadable is simply not there.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pelage {

// All that a compiled program depends on; kept whole in its file, so that a stale entry can never pass.
struct CacheKey {
    std::string source;
    std::string options;
    std::string device;
    std::string device_version;
    std::string driver;
    std::string platform;
};

using Binary = std::vector<unsigned char>;

// $PELAGE_CACHE, else $XDG_CACHE_HOME/pelage, else ~/.cache/pelage; empty when none of these variables is set.
std::filesystem::path cache_folder();

// File of the entry: the folder and a hash of the key.
std::filesystem::path cache_file(const std::filesystem::path& folder, const CacheKey&);

std::optional<Binary> load_cached(const std::filesystem::path& folder, const CacheKey&);

// Written aside and renamed, so that several processes may store at once. False when it could not be kept.
bool store_cached(const std::filesystem::path& folder, const CacheKey&, const Binary&);

}  // namespace pelage
