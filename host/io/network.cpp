// See network.hpp.
#include "io/network.hpp"

#include "core/error.hpp"
#include "io/archive.hpp"
#include "io/atomic_file.hpp"
#include "io/file_bytes.hpp"
#include "io/npy.hpp"
#include "io/npy_header.hpp"
#include "io/pickle.hpp"
#include "io/safetensors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <map>
#include <system_error>
#include <utility>

namespace pelage {

namespace {

constexpr std::array<const char*, 3> array_names{"W0", "b0", "W1"};
using Arrays = std::map<std::string, NpyArray>;

// Without lengths of 1 in front, but for as many as `least`.
std::vector<std::size_t> core_shape(std::vector<std::size_t> shape, std::size_t least) {
    while (shape.size() > least && shape.front() == 1) shape.erase(shape.begin());
    return shape;
}

Network network_of(const Arrays& arrays, const std::string& name) {
    for (const char* wanted : array_names) {
        if (arrays.contains(wanted)) continue;
        std::vector<std::string> found;
        for (const auto& [key, array] : arrays) found.push_back(key);
        found.resize(std::min<std::size_t>(found.size(), 10));
        throw Error(fmt::format("'{}' has no array '{}'; it needs W0, b0 and W1 and has {}", name, wanted,
                                found.empty() ? "none" : fmt::format("{}", fmt::join(found, ", "))));
    }
    const NpyArray &first = arrays.at("W0"), &bias = arrays.at("b0"), &second = arrays.at("W1");
    const auto from = core_shape(first.shape, 2), between = core_shape(bias.shape, 1), to = core_shape(second.shape, 2);
    const bool fits = from.size() == 2 && between.size() == 1 && to.size() == 2 && between[0] == from[1] &&
                      to[0] == from[1] && to[1] == from[0];
    if (!fits)
        throw Error(fmt::format(
            "'{}' has W0 ({}), b0 ({}) and W1 ({}); needed are (chemicals, hidden), (hidden) and "
            "(hidden, chemicals)",
            name, fmt::join(first.shape, ", "), fmt::join(bias.shape, ", "), fmt::join(second.shape, ", ")));
    return make_network(from[0], from[1], first.values, bias.values, second.values, name);
}

Arrays of_archive(std::string_view bytes, const std::string& name) {
    constexpr std::string_view ending = ".npy";
    Arrays arrays;
    for (const auto& [file, content] : parse_zip(bytes, name, largest_network_file)) {
        if (!file.ends_with(ending)) continue;
        std::string key = file.substr(0, file.size() - ending.size());
        for (std::size_t i = 0; i < array_names.size(); ++i) {
            if (key == fmt::format("arr_{}", i)) key = array_names[i];
        }
        arrays.insert_or_assign(key, parse_npy(content, name + "/" + file));
    }
    return arrays;
}

// The pickle behind the header of an .npy file of objects.
Arrays of_pickle(std::string_view bytes, const std::string& name) {
    std::vector<NpyArray> list = parse_pickled_arrays(npy_content(bytes, name), name);
    if (list.size() != array_names.size())
        throw Error(fmt::format("'{}' holds {} arrays; a network has three, W0, b0 and W1", name, list.size()));
    Arrays arrays;
    for (std::size_t i = 0; i < list.size(); ++i) arrays.emplace(array_names[i], std::move(list[i]));
    return arrays;
}

void check_size(std::size_t size, const std::string& name) {
    if (size > largest_network_file)
        throw Error(fmt::format("'{}' has {} bytes; at most {} are allowed", name, size, largest_network_file));
}

std::string read_limited(const std::filesystem::path& path) {
    std::error_code unknown;
    const auto size = std::filesystem::file_size(path, unknown);
    if (!unknown) check_size(size, path.string());
    return read_file(path);
}

}  // namespace

Network parse_network(std::string_view bytes, const std::string& name) {
    check_size(bytes.size(), name);
    if (bytes.starts_with(zip_magic)) return network_of(of_archive(bytes, name), name);
    if (bytes.starts_with(npy_magic)) {
        if (holds_objects(bytes, name)) return network_of(of_pickle(bytes, name), name);
        throw Error(
            fmt::format("'{}' holds a single array; a network has three: name the folder that holds W0.npy, "
                        "b0.npy and W1.npy",
                        name));
    }
    if (looks_like_safetensors(bytes)) return network_of(parse_safetensors(bytes, name), name);
    throw Error(fmt::format("'{}' is neither an .npz archive nor a pickled .npy list nor a safetensors file", name));
}

FoundNetwork read_network(const std::filesystem::path& path) {
    FoundNetwork found;
    if (!std::filesystem::is_directory(path)) {
        found.files.push_back({"", read_limited(path)});
        found.network = parse_network(found.files[0].bytes, path.string());
        return found;
    }
    Arrays arrays;
    for (const char* array : array_names) {
        const std::string file = fmt::format("{}.npy", array);
        found.files.push_back({file, read_limited(path / file)});
        arrays.emplace(array, parse_npy(found.files.back().bytes, (path / file).string()));
    }
    found.network = network_of(arrays, path.string());
    return found;
}

void write_network(const std::filesystem::path& path, const Network& network) {
    const auto array = [&](const std::vector<std::size_t>& shape, const std::vector<double>& values) {
        return npy_bytes(shape, values, NpyType::float32, path.string());
    };
    write_file(path, zip_of({{"W0.npy", array({network.chemicals, network.hidden}, network.first)},
                             {"b0.npy", array({network.hidden}, network.bias)},
                             {"W1.npy", array({network.hidden, network.chemicals}, network.second)}}));
}

}  // namespace pelage
