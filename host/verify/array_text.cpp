// See array_text.hpp: chemicals, cells, phases, and the state that a case starts from.
#include "verify/array_text.hpp"

#include "core/models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
        line("use seed -987654321987654321\nuse polarity 30 dev 170");
        create();
        rules();
        return std::move(text_);
    }

private:
    bool lattice() const { return case_.realm == Realm::lattice; }
    bool rates(const char* kind) const { return world_["rates"] == kind; }
    bool uneven() const { return !rates("uniform"); }
    bool directed() const { return rates("directed") || rates("changing"); }

    void line(const std::string& statement) { text_ += statement + "\n"; }

    void settings() {
        line("define time_step 0.05");
        line(lattice() ? "define field ramp (0.5 + 0.25 * sin(0.7 * COLUMN) + 0.125 * RANDOM)"
                       : "define field ramp (0.5 + 0.01 * X)");
        line("define field slope (0.5 + 0.25 * cos(0.9 * Y))");
        if (lattice()) {
            const std::string& stencil = world_["stencil"];
            // No two weights are alike, so that none can stand for another.
            const char* const weights = " 0.125 0.5 -0.0625 0.75 -2.75 0.375 0.1875 0.625 0.25";
            if (stencil != "published") line("define stencil " + stencil + (stencil == "3x3" ? weights : ""));
            return;
        }
        if (world_["limit"] != "none") line("define division_limit " + world_["limit"]);
        if (world_["domain"] == "narrow") line("define domain 15 11");
        if (world_["domain"] == "packed") line("define domain packed area 3");
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
        if (!still) diff = fmt::format(" diff {}", kind == 'A' ? 0.3 : kind == 'Z' ? 0.125 : 0.2);
        const bool spread = uneven() && (kind == 'Z' || kind == 'Q' || kind == 'E');
        line(fmt::format("use chemical {} {}{}{}", name, conc, diff, spread ? " dev 0.1" : ""));
    }

    void create() {
        if (lattice()) {
            const bool grid = world_["stencil"] == "published";
            const std::string boundary = grid ? (world_["boundary"] == "wrap" ? "wrap" : "") : world_["boundary"];
            line(fmt::format("create {} {} {} {} at 0.5 -3.25", grid ? "sqr_grid" : "matrix", case_.size.columns,
                             case_.size.rows, boundary));
            return;
        }
        if (case_.size.rows == 0) {
            for (std::size_t i = 0; i < case_.size.columns; ++i) line(fmt::format("create cell {} 0.5", i / 2));
            return;
        }
        line(fmt::format("create hex_grid {} {} dev 0.3", case_.size.columns, case_.size.rows));
        if (world_["sizes"] != "tissue") return;
        line("use polarity none\ncreate hex_circle 3 at 9 5 fixed\ncreate cell 1 1\ncreate cell 1 1 fixed");
    }

    void rules() {
        if (reads_mapping()) line("rule always map G conc 0.5 2.5 to M 0.0625 1.5");
        if (lattice()) growth();
        for (std::size_t i = 0; i < case_.made->rules.size(); ++i) {
            if (!in_phase(i)) text_ += generated_rule(case_, i);
        }
        if (world_["phases"] == "none") return line(fmt::format("stop at {}", start_ + 80));
        line(fmt::format("phase \"one\" {}\nphase \"two\" 3", start_ + 3));
        change_settings(0.03, 3.5, 0.25);
        line("phase \"three\" 80");
        change_settings(0.0625, 4.75, 0.15);
        for (std::size_t i = 0; i < case_.made->rules.size(); ++i) {
            if (in_phase(i)) text_ += generated_rule(case_, i);
        }
    }

    bool in_phase(std::size_t rule) const { return Values(case_.realm, case_.made->rules[rule])["when"] == "phase"; }

    // M is read by name, and as what other quantities are compared with.
    bool reads_mapping() const { return !case_.made->rules.empty(); }

    // Counted from the start on, or the language would take it to have grown before.
    void growth() {
        const std::string& how = world_["growth"];
        const auto expand = [&](const char* when, const char* what) {
            line(fmt::format("rule from {} every {} always expand {}", start_, when, what));
        };
        if (how == "inserted") {
            expand("4 offset 2", "columns 1 rows 2 first rows");
            expand("5 offset 4", "columns 2 distribution triangular");
        } else if (how == "stretched") {
            expand("4 offset 2", "columns 1 rows 2 by bicubic");
            expand("5 offset 4", "columns 2 by bilinear");
            expand("7 offset 1", "rows 1 by nearest");
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
    last.emplace_back("Z");
    if (reacts) last.insert(last.end() - (world["ends"] == "bounded" ? 0 : 1), "R");
    const bool many = one.realm == Realm::lattice && world["chemicals"] == "twenty";
    for (std::size_t i = names.size() + last.size(); many && i < twenty; ++i) names.push_back(fmt::format("F{}", i));
    names.insert(names.end(), last.begin(), last.end());
    return names;
}

std::string generated_text(const GeneratedCase& one) { return TextWriter(one).text(); }

std::vector<Size> generated_sizes(const GeneratedWorld& made, Realm realm) {
    const Values world(realm, made.world);
    const auto turn = [&](std::initializer_list<Size> sizes) { return sizes.begin()[made.number % sizes.size()]; };
    if (realm == Realm::cells) {
        if (world["sizes"] == "tissue") return {{13, 11}};
        // One cell or two have no mirrors and no uneven rates: a program of their own.
        const bool plain = world["mirrors"] == "none" && world["rates"] == "uniform";
        const Size smallest = plain ? turn({{7, 0}, {1, 0}, {2, 0}}) : Size{7, 0};
        return {smallest, turn({{5, 3}, {4, 4}, {17, 1}, {11, 3}})};
    }
    // More cells than 16 bits count, or columns, or rows; where rows and columns go to and fro, in each of these ways.
    if (world["sizes"] == "many") {
        const bool fro = world["path"] == "streamed" || world["path"] == "tiled";
        if (fro) return {{9, 4}, {65'541, 1}, {1, 65'541}, turn({{311, 223}, {520, 131}})};
        return {{9, 4}, turn({{65'541, 1}, {311, 223}, {1, 65'541}, {520, 131}})};
    }
    return {turn({{1, 37}, {1, 1}, {41, 1}, {2, 3}}), turn({{15, 6}, {16, 7}, {17, 15}, {33, 2}, {7, 5}}),
            turn({{31, 9}, {65, 11}, {130, 3}}), turn({{24, 33}, {67, 71}})};
}

std::vector<std::uint64_t> generated_strides(Size size) {
    const std::size_t cells = size.columns * size.rows;
    if (cells > 5000) return {1, 1, 3, 2};
    if (cells > 1000) return {1, 1, 3, 1, 8, 26};
    return {1, 1, 3, 1, 2, 11};
}

void set_stage(const GeneratedCase& one, Snapshot& state) {
    const auto start = std::stoull(one.world()["start"]);
    const auto names = generated_chemicals(one);
    const auto idle = static_cast<std::size_t>(std::ranges::find(names, "G") - names.begin());
    state.iteration = start;
    for (double& value : state.conc[idle]) value = std::round(4 * value) / 4;
    for (std::size_t cell = 0; cell < state.cells(); ++cell) {
        const std::uint64_t ages[] = {0, 3, 7, 12, 65'530, 2'147'483'640, 4'294'967'200};
        state.birth[cell] = static_cast<std::uint32_t>(start - std::min<std::uint64_t>(ages[cell % 7], start));
        state.neighbours[cell] = static_cast<std::int32_t>(cell % 6);
        if (one.realm == Realm::lattice) state.fixed[cell] = cell % 3 == 0 ? 1 : 0;
        for (auto& plane : state.mappings) plane[cell] = static_cast<double>(cell % 11) * 0.125;
    }
    const auto last = static_cast<std::uint32_t>(state.cells() - 1);
    if (one.realm != Realm::cells || one.world()["mirrors"] == "none" || last < 3) return;
    state.mirrors = {{0, last}, {1, last / 2}, {last / 2, last - 1}, {last - 1, 0}};
}

}  // namespace pelage::verify
