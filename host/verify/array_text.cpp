// See array_text.hpp: chemicals, cells and phases.
#include "verify/array_text.hpp"

#include "core/models.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage::verify {

namespace {

constexpr std::size_t twenty = 20;

bool has_action(const GeneratedCase& one, const std::string& beginning) {
    return std::ranges::any_of(
        one.made->rules, [&](const ArrayRow& row) { return Values(one.realm, row)["action"].starts_with(beginning); });
}

bool has_rates_changed(const GeneratedCase& one) {
    return has_action(one, "change diff") || has_action(one, "set diff");
}

std::size_t reacting_chemicals() {
    std::size_t most = 3;
    for (const ModelFacts& model : model_table()) most = std::max(most, model.species.size());
    return most;
}

class TextWriter {
public:
    explicit TextWriter(const GeneratedCase& one)
        : case_(one), world_(one.world()), start_(std::stoull(world_["start"])) {}

    std::string text() {
        settings();
        for (const std::string& name : generated_chemicals(case_)) define(name);
        for (const std::string& name : generated_chemicals(case_)) use(name);
        line(fmt::format("use seed {}", case_.run_seed()));
        if (plane()) line("use polarity 30 dev 170");
        create();
        rules();
        return std::move(text_);
    }

private:
    bool lattice() const { return case_.realm == Realm::lattice; }
    bool plane() const { return lattice() || case_.realm == Realm::cells; }
    bool rates(const char* kind) const { return world_["rates"] == kind; }
    bool uneven() const { return !rates("uniform"); }
    // Directions are felt between cells that are side by side.
    bool directed() const { return plane() && !world_.has("stencil", "5x5") && !rates("uniform") && !rates("uneven"); }

    void line(const std::string& statement) { text_ += statement + "\n"; }

    void settings() {
        line("define time_step 0.05");
        fields();
        if (case_.realm == Realm::volume) line("define stencil " + world_["stencil"]);
        if (lattice()) {
            const std::string& stencil = world_["stencil"];
            // No two weights are alike, so that none can stand for another.
            const char* const weights = " 0.125 0.5 -0.0625 0.75 -2.75 0.375 0.1875 0.625 0.25";
            const char* const wide =
                " 0.0625 0.125 -0.03125 0.1875 0.09375 0.15625 0.25 0.3125 0.21875 0.28125 0.34375 0.375 -5.15625"
                " 0.40625 0.4375 0.046875 0.46875 0.5 0.078125 0.109375 0.140625 -0.015625 0.171875 0.203125 0.234375";
            const std::string own = stencil == "3x3" ? weights : stencil == "5x5" ? wide : "";
            if (stencil != "published") line("define stencil " + stencil + own);
        }
        if (case_.realm != Realm::cells) return;
        if (world_["limit"] != "none") line("define division_limit " + world_["limit"]);
        if (world_["domain"] == "narrow") line("define domain 15 11");
        if (world_["domain"] == "packed") line("define domain packed area 2.9");
    }

    void fields() {
        const bool grid = lattice() || case_.realm == Realm::volume;
        line(grid ? "define field ramp (0.5 + 0.25 * sin(0.7 * COLUMN) + 0.125 * RANDOM)"
                  : "define field ramp (0.5 + 0.01 * X)");
        const char* const slopes[] = {"0.9 * Y", "0.9 * Y", "0.9 * Y + 0.7 * Z + LAYER / LAYERS", "0.9 * Y + Z"};
        line(fmt::format("define field slope (0.5 + 0.25 * cos({}))", slopes[static_cast<std::size_t>(case_.realm)]));
    }

    void define(const std::string& name) {
        const char kind = name[0];
        std::string bounds = "floor none";
        if (kind == 'G') bounds = "limit 2.5 floor 0.5";
        if (kind == 'P') bounds = "limit 4.5 floor 0.25";
        if (kind == 'Q') bounds = "limit 4.25 floor none";
        if (kind == 'R' || kind == 'S') bounds = "limit 5 floor -0.5";
        if (kind == 'F') bounds = "limit 3.5 floor 1.5";
        if (kind == 'D' || kind == 'E') bounds = "limit 5 floor 1";
        const bool turned = directed() && (kind == 'Q' || kind == 'E');
        line(fmt::format("define chemical {} {}{}", name, bounds, turned ? " anisotropic" : ""));
    }

    // G and F reach past their bounds, which the first iteration cuts; B and most F stay where they are.
    void use(const std::string& name) {
        const char kind = name[0];
        const char* conc = kind == 'G' ? "conc 1.5 dev 1.5" : kind == 'B' ? "conc 2 dev 1" : "conc 2.75 dev 1.5";
        std::string diff;
        const bool still = kind == 'G' || kind == 'B' || (kind == 'F' && name != "F9");
        if (!still) diff = fmt::format(" diff {}", kind == 'A' ? 0.3 : kind == 'W' ? 0.125 : 0.2);
        const bool spread = uneven() && (kind == 'W' || kind == 'Q' || kind == 'E');
        line(fmt::format("use chemical {} {}{}{}", name, conc, diff, spread ? " dev 0.1" : ""));
    }

    void create() {
        const Size& size = case_.size;
        if (case_.realm == Realm::volume)
            return line(
                fmt::format("create volume {} {} {} {}", size.columns, size.rows, size.layers, world_["boundary"]));
        if (case_.realm == Realm::mesh) return create_mesh();
        if (lattice()) {
            const bool grid = world_["stencil"] == "published";
            const std::string boundary = grid ? (world_["boundary"] == "wrap" ? "wrap" : "") : world_["boundary"];
            line(fmt::format("create {} {} {} {} at 0.5 -3.25", grid ? "sqr_grid" : "matrix", size.columns, size.rows,
                             boundary));
            return;
        }
        create_cells();
    }

    void create_mesh() {
        const std::string& shape = world_["shape"];
        const std::string what = shape == "icosphere" ? fmt::format("icosphere {}", case_.size.columns)
                                                      : fmt::format("torus {} {}", case_.size.columns, case_.size.rows);
        const char* const note = shape == "odd" ? "  // another mesh of the test's own in its place" : "";
        line(fmt::format("create {} weights {} scale 1.25{}", what, world_["weights"], note));
    }

    void create_cells() {
        if (case_.size.rows == 0) {
            for (std::size_t i = 0; i < case_.size.columns; ++i) line(fmt::format("create cell {} 0.5", i / 2));
            return;
        }
        line(fmt::format("create hex_grid {} {} dev 0.3", case_.size.columns, case_.size.rows));
        if (world_["sizes"] != "tissue") return;
        line("use polarity none\ncreate hex_circle 3 at 9 5 fixed\ncreate cell 1 1\ncreate cell 1 1 fixed");
    }

    void rules() {
        // What G has beyond its bounds, and loses in the first iteration, maps to other numbers than the bounds.
        if (reads_mapping()) line("rule always map G conc 0.25 2.75 to M 0.0625 1.5");
        if (lattice()) growth();
        for (std::size_t i = 0; i < case_.made->rules.size(); ++i) {
            if (!in_phase(i)) text_ += generated_rule(case_, i);
        }
        if (world_["phases"] == "none") return line(fmt::format("stop at {}", start_ + 80));
        line(fmt::format("phase \"one\" {}\nphase \"two\" 3", start_ + 3));
        change_settings(0.03, 3.5, 0.25);
        line("phase \"three\" 80");
        change_settings(0.0625, 4.75, 0.15);
        // No bounds any more, which free cells would have another program for.
        if (case_.realm != Realm::cells) line("define chemical Q limit none floor none");
        for (std::size_t i = 0; i < case_.made->rules.size(); ++i) {
            if (in_phase(i)) text_ += generated_rule(case_, i);
        }
    }

    bool in_phase(std::size_t rule) const { return Values(case_.realm, case_.made->rules[rule])["when"] == "phase"; }

    // M is read by name, and as what other quantities are compared with.
    bool reads_mapping() const { return !case_.made->rules.empty(); }

    // Counted from the start on, or the language would take it to have grown before; in none of the first iterations of
    // a phase, whose passes it would break off.
    void growth() {
        const std::string& how = world_["growth"];
        const auto expand = [&](const char* when, const char* what) {
            line(fmt::format("rule from {} every {} always expand {}", start_, when, what));
        };
        if (how == "inserted") {
            expand("6 offset 2", "columns 1 rows 2 first rows");
            expand("7 offset 5", "columns 2 distribution triangular");
        } else if (how == "stretched") {
            expand("6 offset 2", "columns 1 rows 2 by bicubic");
            expand("7 offset 5", "columns 2 by bilinear");
            expand("8 offset 5", "rows 1 by nearest");
        }
    }

    // Of the first chemical, one in the middle, one that is idle, and the last. Where the first and the last know no
    // bounds they get some, which makes another program; elsewhere numbers change alone.
    void change_settings(double time_step, double limit, double rate) {
        const std::vector<std::string> names = generated_chemicals(case_);
        line(fmt::format("define time_step {}", time_step));
        line(fmt::format("define chemical G limit {} floor {}", limit / 2, limit / 4));
        for (const std::string& name : {names.front(), std::string("Q"), names.back()}) {
            const bool numbers_alone = name == "Q" && world_["ends"] == "bounded";
            const std::string floor = numbers_alone ? "none" : fmt::format("{}", limit / 4);
            line(fmt::format("define chemical {} limit {} floor {}", name, limit, floor));
            line(fmt::format("use chemical {} diff {}", name, rate));
        }
    }

    const GeneratedCase& case_;
    Values world_;
    std::uint64_t start_;
    std::string text_;
};

}  // namespace

std::vector<std::string> generated_chemicals(const GeneratedCase& one) {
    const Values world = one.world();
    const bool reacts = has_action(one, "react"), rates = has_rates_changed(one);
    std::vector<std::string> names{"A", "G", "B", "Q"};
    if (rates) names.insert(names.begin() + 1, "D");
    if (reacts) {
        const bool front = world["ends"] == "bounded";
        names.insert(names.begin() + (front ? 0 : 1), "P");
        for (std::size_t i = 3; i < reacting_chemicals(); ++i) names.push_back(fmt::format("S{}", i));
    }
    std::vector<std::string> last;
    if (rates) last.emplace_back("E");
    last.emplace_back("W");
    if (reacts) last.insert(last.end() - (world["ends"] == "bounded" ? 0 : 1), "R");
    const bool many = one.realm == Realm::lattice && world["chemicals"] == "twenty";
    for (std::size_t i = names.size() + last.size(); many && i < twenty; ++i) names.push_back(fmt::format("F{}", i));
    names.insert(names.end(), last.begin(), last.end());
    return names;
}

std::string generated_text(const GeneratedCase& one) {
    return has_rules(one.realm) ? TextWriter(one).text() : charges_text(one);
}

}  // namespace pelage::verify
