// See format.hpp.
#include "io/format.hpp"

#include "core/error.hpp"
#include "io/csv.hpp"
#include "io/mesh_results.hpp"
#include "io/vtk.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pelage {

namespace {

std::string trimmed(const std::string& text) {
    const std::size_t first = std::min(text.find_first_not_of(" \t"), text.size());
    return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

const FormatRow& row_of(const std::string& word) {
    for (const FormatRow& row : format_table()) {
        if (std::ranges::find(row.words, word) != row.words.end()) return row;
    }
    std::vector<std::string> words = format_words();
    const std::string last = words.back();
    words.pop_back();
    throw Error(fmt::format("unknown format '{}'; allowed are {} and {}", word, fmt::join(words, ", "), last));
}

}  // namespace

const std::vector<FormatRow>& format_table() {
    static const auto& table = *new const std::vector<FormatRow>{
        {Format::exr, {"exr"}, {".exr", nullptr}, {}, {}},
        {Format::png, {"png"}, {".png", nullptr}, {".png", nullptr}, {".png", nullptr}},
        {Format::npy, {"npy"}, {".npy", nullptr}, {".npy", nullptr}, {".npy", nullptr}},
        {Format::csv, {"csv"}, {".csv", write_csv}, {".csv", write_csv}, {".csv", write_csv}},
        {Format::vtk, {"vti", "vtp", "vtk"}, {".vti", write_vti}, {".vtp", write_vtp}, {".vtp", write_surface_vtp}},
        {Format::ply, {"ply"}, {}, {}, {".ply", nullptr}},
    };
    return table;
}

std::vector<std::string> format_words() {
    std::vector<std::string> words;
    for (const FormatRow& row : format_table()) words.push_back(row.words.front());
    return words;
}

std::vector<std::string> format_endings() {
    std::vector<std::string> endings;
    for (const FormatRow& row : format_table()) {
        for (const StateFile& file : {row.lattice, row.cells, row.mesh}) {
            if (file.ending != nullptr && std::ranges::find(endings, file.ending) == endings.end())
                endings.emplace_back(file.ending);
        }
    }
    return endings;
}

std::vector<Format> parse_formats(const std::string& list) {
    std::vector<Format> formats;
    for (std::size_t at = 0; at <= list.size();) {
        const auto end = std::min(list.find(',', at), list.size());
        const Format format = row_of(trimmed(list.substr(at, end - at))).format;
        if (std::ranges::find(formats, format) == formats.end()) formats.push_back(format);
        at = end + 1;
    }
    return formats;
}

}  // namespace pelage
