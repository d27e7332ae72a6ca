// See pocl_programs.hpp. An entry of the cache holds, for each file: length of its name, its length, name, bytes.
#include "opencl/device/pocl_programs.hpp"

#include "core/error.hpp"
#include "io/file_bytes.hpp"
#include "opencl/device/pocl.hpp"

#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace pelage {

namespace {

namespace fs = std::filesystem;

using Files = std::map<std::string, std::string>;  // name within PoCL's folder, bytes

struct Program {
    CacheKey key;
    fs::path folder;       // of this program, within PoCL's
    std::size_t kept = 0;  // files that the cache has
};

struct Store {
    std::mutex guard;
    std::map<std::string, Program> programs;  // by the name of their cache file
    std::multimap<const Session*, std::string> built;
};

// Never destroyed: a session that lives until the process ends comes to it late.
Store& store() {
    static Store& one = *new Store;
    return one;
}

// Beside a plain binary of the same program.
CacheKey folder_key(CacheKey key) {
    key.platform += ", its folder";
    return key;
}

// PoCL's folder holds folders of two letters, and those a folder for each program.
std::set<fs::path> program_folders() {
    std::set<fs::path> found;
    std::error_code failure;
    for (const auto& letters : fs::directory_iterator(pocl_folder(), failure)) {
        if (letters.path().filename().string().size() != 2 || !letters.is_directory(failure)) continue;
        for (const auto& program : fs::directory_iterator(letters, failure)) {
            found.insert(program.path().lexically_relative(pocl_folder()));
        }
    }
    return found;
}

// What PoCL writes aside and renames when it is whole.
bool worth_keeping(const fs::path& file) { return file.filename() == "program.bc" || file.extension() == ".so"; }

std::vector<fs::path> files_of(const fs::path& program) {
    std::vector<fs::path> found;
    std::error_code failure;
    fs::recursive_directory_iterator at(pocl_folder() / program, failure);
    for (; !failure && at != fs::recursive_directory_iterator(); at.increment(failure)) {
        if (worth_keeping(at->path()) && at->is_regular_file(failure)) found.push_back(at->path());
    }
    return found;
}

void add_number(Binary& packed, std::uint64_t number) {
    for (int i = 0; i < 8; ++i) packed.push_back(static_cast<unsigned char>(number >> (8 * i)));
}

Binary packed(const Files& files) {
    Binary bytes;
    for (const auto& [name, content] : files) {
        add_number(bytes, name.size());
        add_number(bytes, content.size());
        bytes.insert(bytes.end(), name.begin(), name.end());
        bytes.insert(bytes.end(), content.begin(), content.end());
    }
    return bytes;
}

// Nothing when they are not what packed() makes.
Files unpacked(const Binary& bytes) {
    Files files;
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    for (std::size_t at = 0; at < text.size();) {
        if (text.size() - at < 16) return {};
        const auto name = load<std::uint64_t>(text.data() + at);
        const auto content = load<std::uint64_t>(text.data() + at + 8);
        at += 16;
        if (name > text.size() - at || content > text.size() - at - name) return {};
        files.emplace(text.substr(at, name), text.substr(at + name, content));
        at += name + content;
    }
    return files;
}

// Of the program that has a file of this name.
fs::path folder_of(const fs::path& name) { return name.empty() ? name : *name.begin() / *std::next(name.begin()); }

bool write_whole(const fs::path& place, const std::string& content) {
    std::error_code ignored;
    fs::create_directories(place.parent_path(), ignored);
    std::ofstream file(place, std::ios::binary);
    return static_cast<bool>(file.write(content.data(), static_cast<std::streamsize>(content.size())).flush());
}

void put_back(const CacheKey& key) {
    const auto binary = load_cached(cache_folder(), key);
    if (!binary) return;
    Program program{key, {}, 0};
    for (const auto& [name, content] : unpacked(*binary)) {
        program.folder = folder_of(name);
        ++program.kept;
        if (write_whole(pocl_folder() / name, content)) continue;
        std::error_code ignored;
        fs::remove_all(pocl_folder() / program.folder, ignored);
        return;
    }
    if (program.kept > 0) store().programs[cache_file("", key).string()] = program;
}

// Beside what another process has compiled of the same program.
void keep(Program& program) {
    const std::vector<fs::path> paths = files_of(program.folder);
    if (paths.size() <= program.kept) return;
    try {
        Files files;
        if (const auto binary = load_cached(cache_folder(), program.key)) files = unpacked(*binary);
        std::erase_if(files, [&](const auto& file) { return folder_of(file.first) != program.folder; });
        for (const fs::path& path : paths) {
            files[path.lexically_relative(pocl_folder()).string()] = read_file(path);
        }
        if (store_cached(cache_folder(), program.key, packed(files))) program.kept = paths.size();
    } catch (const Error&) {
        return;  // it will be compiled again
    }
}

using Built = decltype(Store::built)::iterator;

void keep_those(Store& kept, Built first, Built last) {
    for (Built at = first; at != last; ++at) {
        const auto found = kept.programs.find(at->second);
        if (found != kept.programs.end()) keep(found->second);
    }
    kept.built.erase(first, last);
}

}  // namespace

bool build_with_kept(const Session& session, const CacheKey& plain, const std::function<void()>& build) {
    if (pocl_folder().empty()) {
        build();
        return true;
    }
    Store& kept = store();
    const std::lock_guard lock(kept.guard);
    const CacheKey key = folder_key(plain);
    const std::string name = cache_file("", key).string();
    if (!kept.programs.contains(name)) put_back(key);
    const std::set<fs::path> before = program_folders();
    build();
    bool compiled = false;
    for (const fs::path& folder : program_folders()) {
        if (before.contains(folder)) continue;
        kept.programs[name] = {key, folder, 0};
        compiled = true;
    }
    kept.built.emplace(&session, name);
    return compiled;
}

void keep_compiled(const Session& session) {
    Store& kept = store();
    const std::lock_guard lock(kept.guard);
    const auto [first, last] = kept.built.equal_range(&session);
    keep_those(kept, first, last);
}

void keep_compiled() {
    Store& kept = store();
    const std::lock_guard lock(kept.guard);
    keep_those(kept, kept.built.begin(), kept.built.end());
}

}  // namespace pelage
