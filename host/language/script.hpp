// What the statements of an experiment share while it is being read.
#pragma once

#include "core/experiment.hpp"
#include "core/starts.hpp"
#include "language/cursor.hpp"
#include "language/parse.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pelage::language {

using Colour = std::array<std::uint8_t, 3>;

// A colour map as written; slots are filled in at the end of the file.
struct ColormapChoice {
    std::string name = "heat";
    std::vector<ColourStop> stops;  // of "stops" alone
};

struct PendingOutput {
    Output output;
    std::optional<ColormapChoice> colormap;  // empty: the selected one
};

struct Demand {  // what a statement needs that only the whole file can show
    Place place;
    std::string statement;
};

struct Picture {  // the initial state of a chemical
    std::size_t chemical = 0;
    Place place;
};

struct StartPlace {  // of the values a statement gives
    StartPlace(Place both) : conc(both), diff(both) {}
    StartPlace(Place of_conc, Place of_diff) : conc(of_conc), diff(of_diff) {}
    Place conc;
    Place diff;
};

struct Replaced {  // a part of the text by another
    std::size_t line = 0;
    std::size_t offset = 0;  // in the line, in bytes
    std::size_t length = 0;
    std::string by;
};

class Script {
public:
    Script(const std::string& text, const std::string& source, std::filesystem::path folder, StartPictures,
           const std::vector<Setting>& settings);

    Experiment experiment;

    // ---- names
    std::size_t chemical(Cursor&) const;  // throws Error for one that is not defined
    std::optional<std::size_t> find_chemical(std::string_view) const;
    std::optional<std::size_t> find_mapping(std::string_view) const;
    std::optional<std::size_t> find_field(std::string_view) const;
    std::optional<std::size_t> find_stencil(std::string_view) const;
    std::string chemicals_defined() const;  // "defined here: U, V"
    std::vector<std::string_view> chemical_names() const;
    std::vector<std::string_view> field_names() const;

    // The chemical that holds what this one was an iteration ago; made when first asked for. `at`: where it is.
    std::size_t previous_of(std::size_t chemical, const Cursor&, const Token& at);

    std::filesystem::path resolve(std::string_view file_name) const;
    StartPictures pictures() const { return start_pictures_; }

    // ---- parameters
    const Setting* setting(std::string_view name);            // from outside; null: none
    void replaces(const Token&, const std::string& written);  // a number of the line at hand, in Experiment::text

    // ---- cells
    std::size_t cells() const { return cells_; }
    // Takes note of a `create`; `at` is its kind. Throws Error for too many cells or a mixture with a matrix.
    void create(const Cursor&, const Token& at, const Statement&, std::size_t cells);

    // ---- how the tissue starts
    void start(Statement, const StartPlace&);  // takes it into the prepattern
    std::size_t line_of_start(std::size_t nth) const { return starts_[nth].conc.line; }

    // ---- phases
    bool in_phase() const { return !experiment.phases.empty(); }
    Phase& phase() { return in_phase() ? experiment.phases.back() : before_; }  // being described
    std::uint64_t phase_begin() const { return in_phase() ? experiment.phases.back().begin : 0; }
    std::uint64_t phase_end() const { return phase_end_; }  // first iteration after it; forever before the first phase
    void begin_phase(std::string name, std::uint64_t steps);
    // Throws Error inside a phase: `statement` describes the whole run.
    void outside_phases(const Cursor&, const Token& at, std::string_view statement) const;

    // ---- pictures
    ColormapChoice selected;
    std::array<std::optional<Colour>, 100> slots;
    std::vector<PendingOutput> outputs;
    std::optional<std::uint64_t> stop;

    // ---- what can only be checked at the end of the file
    void needs_matrix(const Cursor&, const Token& at);
    void refuses_matrix(const Cursor&, const Token& at);
    void needs_lattice(const Cursor&, const Token& at);
    void needs_plane(const Cursor&, const Token& at);   // anything but a volume
    void needs_volume(const Cursor&, const Token& at);  // and nothing else
    void needs_depth(const Cursor&, const Token& at);   // a volume or a mesh
    void needs_mesh(const Cursor&, const Token& at);
    void needs_places(const Cursor&, const Token& at);     // anything but free cells
    void expands(const Cursor&, const Token& at);          // once for each `expand`, in order
    void shows_picture(const Cursor&, const Token& file);  // of the chemical defined next
    void draws_map(const Cursor&, const Token& at);        // a height or normal map
    void at_line(std::size_t line) { line_ = line; }

    // Defaults, what only the whole file can show, and validate().
    Experiment finish();

private:
    Colormap colormap(const ColormapChoice&) const;
    void check_contents() const;
    void check_arrangement() const;
    void check_pictures() const;
    void check_starts() const;
    Place place_of(const StartFault&) const;
    void check_maps() const;
    void check_growth() const;
    void finish_outputs();
    void check_settings() const;
    void set_in_text();

    struct Kept {
        std::size_t chemical = 0;
        std::size_t keeper = 0;  // of what it was
        Place place;             // where it is asked for first
    };
    void finish_previous();
    const std::string& keeper_name(const Kept&) const;

    std::filesystem::path folder_;
    StartPictures start_pictures_;
    std::size_t cells_ = 0;
    Phase before_;
    std::uint64_t phase_end_ = forever;
    bool matrix_ = false;  // or charges
    bool volume_ = false;
    bool mesh_ = false;
    std::optional<Demand> needs_matrix_;
    std::optional<Demand> refuses_matrix_;
    std::optional<Demand> needs_lattice_;
    std::optional<Demand> needs_plane_;
    std::optional<Demand> needs_volume_;
    std::optional<Demand> needs_depth_;
    std::optional<Demand> needs_mesh_;
    std::optional<Demand> needs_places_;
    std::vector<Place> expansions_;
    std::vector<Picture> pictures_;
    std::vector<StartPlace> starts_;  // of each statement of the prepattern
    std::optional<Demand> draws_map_;
    std::size_t line_ = 0;  // the last one
    std::vector<Setting> settings_;
    std::vector<bool> settings_used_;
    std::vector<Replaced> replaced_;
    std::vector<Kept> kept_;
};

}  // namespace pelage::language
