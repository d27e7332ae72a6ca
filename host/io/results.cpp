// See results.hpp.
#include "io/results.hpp"

#include "core/error.hpp"
#include "io/colour.hpp"
#include "io/csv.hpp"
#include "io/exr.hpp"
#include "io/npy.hpp"
#include "io/shape.hpp"
#include "io/texture.hpp"
#include "io/vtk.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <system_error>

namespace pelage {
namespace {

// A chemical's name as part of a file's.
std::string file_word(const std::string& name) {
    std::string word = name;
    for (char& c : word) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_') c = '_';
    }
    return word;
}

class Results {
public:
    Results(const std::filesystem::path& folder, std::string stem, const Snapshot& snapshot,
            const Experiment& experiment, const ResultOptions& options)
        : folder_(folder), stem_(std::move(stem)), snapshot_(snapshot), experiment_(experiment), options_(options) {
        attributes_ = options.attributes;
        attributes_["iteration"] = std::to_string(snapshot.iteration);
    }

    std::vector<std::string> write() {
        for (const auto format : {Format::exr, Format::png, Format::npy, Format::csv, Format::vtk}) {
            if (wanted(format)) write(format);
        }
        if (experiment_.texture && (wanted(Format::exr) || wanted(Format::png))) write_texture(*experiment_.texture);
        return files_;
    }

private:
    bool wanted(Format format) const {
        return std::find(options_.formats.begin(), options_.formats.end(), format) != options_.formats.end();
    }

    void write(Format format) {
        switch (format) {
            case Format::exr:
                return write_fields();
            case Format::png:
                return write_pictures();
            case Format::npy:
                return write_arrays();
            case Format::csv:
                return write_csv(place(stem_ + ".csv"), snapshot_, experiment_);
            case Format::vtk:
                if (snapshot_.lattice())
                    return write_vti(place(stem_ + ".vti"), snapshot_, experiment_, options_.precision);
                return write_vtp(place(stem_ + ".vtp"), snapshot_, experiment_, options_.precision);
        }
    }

    // Notes the file; its place.
    std::filesystem::path place(const std::string& file) {
        files_.push_back(file);
        return folder_ / file;
    }

    // STEM.NAME.png, or STEM.NAME-2.png when that is taken.
    std::filesystem::path free_place(const std::string& stem, const std::string& name, const std::string& ending) {
        auto file = stem + "." + file_word(name) + ending;
        for (int n = 2; std::find(files_.begin(), files_.end(), file) != files_.end(); ++n) {
            file = fmt::format("{}.{}-{}{}", stem, file_word(name), n, ending);
        }
        return place(file);
    }

    void write_layers(const std::filesystem::path& path, std::size_t columns, std::size_t rows,
                      const std::vector<std::span<const double>>& layers) {
        std::vector<ExrChannel> channels;
        for (std::size_t i = 0; i < layers.size(); ++i) channels.push_back({experiment_.chemicals[i].name, layers[i]});
        write_exr(path, columns, rows, channels, attributes_);
    }

    void write_fields() {
        if (!snapshot_.lattice()) return;
        write_layers(place(stem_ + ".exr"), snapshot_.columns, snapshot_.rows,
                     {snapshot_.conc.begin(), snapshot_.conc.end()});
    }

    std::vector<Output> outputs() const {
        return experiment_.outputs.empty() ? std::vector<Output>(1) : experiment_.outputs;
    }

    Picture picture(const Output& output) const {
        if (!snapshot_.lattice()) return draw_cells(snapshot_, output, options_.drawing);
        const auto exact = render(snapshot_.conc[output.chemical], snapshot_.columns, snapshot_.rows, output);
        return enlarged(exact, enlargement(exact.columns, exact.rows));
    }

    void write_pictures() {
        const auto all = outputs();
        write_png(place(stem_ + ".png"), picture(all[0]));
        for (std::size_t i = 1; i < all.size(); ++i) {
            write_png(free_place(stem_, experiment_.chemicals[all[i].chemical].name, ".png"), picture(all[i]));
        }
    }

    void write_arrays() {
        const auto shape =
            snapshot_.lattice() ? std::vector{snapshot_.rows, snapshot_.columns} : std::vector{snapshot_.cells()};
        const auto type = options_.precision == Precision::double_ ? NpyType::float64 : NpyType::float32;
        for (std::size_t i = 0; i < experiment_.chemicals.size(); ++i) {
            write_npy(free_place(stem_, experiment_.chemicals[i].name, ".npy"), shape, snapshot_.conc[i], type);
        }
    }

    void write_texture(const std::array<std::size_t, 2>& size) {
        const auto fields = interpolate(snapshot_, snapshot_.conc, size[0], size[1], wraps(experiment_));
        const std::string name = stem_ == "final" ? "texture" : stem_ + ".texture";
        if (wanted(Format::exr)) {
            std::vector<std::span<const double>> layers;
            layers.reserve(fields.size());
            for (const auto& field : fields) layers.emplace_back(field.values);
            write_layers(place(name + ".exr"), size[0], size[1], layers);
        }
        if (!wanted(Format::png)) return;
        const auto output = outputs()[0];
        write_png(place(name + ".png"), render(fields[output.chemical].values, size[0], size[1], output));
    }

    const std::filesystem::path& folder_;
    std::string stem_;
    const Snapshot& snapshot_;
    const Experiment& experiment_;
    const ResultOptions& options_;
    Attributes attributes_;
    std::vector<std::string> files_;
};

void check_outputs(const Experiment& experiment) {
    if (experiment.chemicals.empty()) throw Error("an experiment without chemicals has no results");
    for (const auto& output : experiment.outputs) {
        if (output.chemical >= experiment.chemicals.size()) {
            throw Error(
                fmt::format("an output names chemical {}; there are {}", output.chemical, experiment.chemicals.size()));
        }
    }
}

}  // namespace

namespace {

std::string without_blanks(const std::string& text) {
    const std::size_t first = std::min(text.find_first_not_of(" \t"), text.size());
    return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

}  // namespace

std::vector<Format> parse_formats(const std::string& list) {
    static const std::map<std::string, Format> words{{"exr", Format::exr}, {"png", Format::png}, {"npy", Format::npy},
                                                     {"csv", Format::csv}, {"vti", Format::vtk}, {"vtp", Format::vtk},
                                                     {"vtk", Format::vtk}};
    std::vector<Format> formats;
    for (std::size_t at = 0; at <= list.size();) {
        const auto end = std::min(list.find(',', at), list.size());
        const auto word = without_blanks(list.substr(at, end - at));
        const auto found = words.find(word);
        if (found == words.end())
            throw Error(fmt::format("unknown format '{}'; allowed are exr, png, npy, csv and vti", word));
        if (std::find(formats.begin(), formats.end(), found->second) == formats.end()) formats.push_back(found->second);
        at = end + 1;
    }
    return formats;
}

std::vector<std::string> write_results(const std::filesystem::path& folder, const std::string& stem,
                                       const Snapshot& snapshot, const Experiment& experiment,
                                       const ResultOptions& options) {
    check_shape(snapshot, experiment);
    check_outputs(experiment);
    std::error_code code;
    std::filesystem::create_directories(folder, code);
    if (code) throw Error(fmt::format("cannot make the folder '{}': {}", folder.string(), code.message()));
    return Results(folder, stem, snapshot, experiment, options).write();
}

std::string snapshot_stem(std::uint64_t iteration, std::uint64_t last_iteration) {
    return fmt::format("{:0{}}", iteration, std::to_string(last_iteration).size());
}

}  // namespace pelage
