// Which files one state is written to, and how: planned first, so that they can be written at the same time.
#pragma once

#include "io/drawn.hpp"
#include "io/output_file.hpp"
#include "io/results.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pelage {

class ResultPlan {
public:
    ResultPlan(const std::filesystem::path& folder, std::string stem, const Snapshot&, const Experiment&,
               const ResultOptions&);

    // Carries it out; the names of the files.
    std::vector<std::string> write();

private:
    using Layers = std::vector<std::span<const double>>;

    bool wanted(Format) const;
    template <class Write>
    void add(const std::string& file, Write write);  // notes the file and how it is written
    template <class Write>
    void add_picture(std::size_t output, const std::string& file, Write write);  // where it is one to be drawn
    std::string free_name(const std::string& stem, const std::string& name, const std::string& ending) const;
    std::string picture_name(const std::string& stem, const Output&, bool first) const;

    void plan(const FormatRow&);
    void plan_layers(const std::string& file, std::size_t columns, std::size_t rows, const Layers&);
    void plan_pictures();
    void plan_picture(std::size_t output);
    void plan_arrays();
    void plan_ply();
    void plan_texture(std::size_t columns, std::size_t rows);
    void plan_texture_pictures(const std::string& stem, std::size_t columns, std::size_t rows);

    void write_layers(const std::filesystem::path&, std::size_t columns, std::size_t rows, const Layers&) const;
    void write_picture(const std::filesystem::path&, std::size_t output) const;
    void write_projection(const std::filesystem::path&, std::size_t output) const;
    void write_stack(const std::filesystem::path&) const;
    std::optional<ValueRange> shared_range(std::size_t output) const;
    Drawn drawn(std::size_t output) const;

    const std::filesystem::path& folder_;
    std::string stem_;
    const Snapshot& snapshot_;
    const Experiment& experiment_;
    const ResultOptions& options_;
    Attributes attributes_;
    std::vector<Output> outputs_;
    std::size_t main_ = 0;            // of them: the first one of colours, STEM.png
    std::vector<Field> textures_;     // by chemical, then of outputs that draw expressions, in their order
    std::vector<std::string> names_;  // of all outputs, drawn or not
    std::vector<std::string> files_;
    std::vector<std::function<void()>> work_;
    std::mutex telling_;
};

}  // namespace pelage
