// See visualpde.hpp.
#include "import/visualpde.hpp"

#include "core/error.hpp"
#include "import/derivative.hpp"
#include "import/ready.hpp"
#include "import/visualpde_edges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pelage::imports {

namespace {

class PdeReader {
public:
    PdeReader(std::string text, const std::string& name, Problems& problems)
        : preset_(std::move(text), name), problems_(problems) {}

    Draft read() {
        check_kind();
        read_species();
        read_lattice();
        meaning_ = std::make_unique<PdeMeaning>(preset_, draft_, names_, problems_, species_, dx_);
        for (std::size_t i = 0; i < species_.size(); ++i)
            edges_.push_back(read_edges(preset_, *meaning_, i + 1, problems_));
        draft_.edge = edge_of_lattice(edges_, edge_counts(), species_, flat(), preset_, problems_);
        read_start();
        read_equations();
        read_domain();
        read_course();
        note_the_rest();
        problems_.check();
        return std::move(draft_);
    }

private:
    [[noreturn]] void fail(std::string_view key, std::string_view what) const {
        throw Error(fmt::format("{}: {}", preset_.at(key), what));
    }
    bool flat() const { return draft_.rows == 1; }
    bool cross() const { return preset_.truth("crossDiffusion"); }

    void check_kind() const {
        const std::string parent = preset_.field("parent");
        if (!parent.empty() && parent != "default" && !preset_.says("reactionStr_1") && !preset_.says("reactionStr_2"))
            fail("parent",
                 fmt::format("the equations are those of the preset '{}', which are not in the file", parent));
        for (const char* wanted : {"reactionStr_1", "numSpecies", "domainScale", "kineticParams", "dt",
                                   "diffusionStr_1_1", "initCond_1", "spatialStep"}) {
            if (preset_.says(wanted)) return;
        }
        fail(preset_.says("preset") ? "preset" : "{}",
             preset_.says("preset") ? "only names a preset of VisualPDE, whose equations are not in the file"
                                    : "holds no field of a preset of VisualPDE");
    }

    // Whether what lies beyond the edge matters to a species: it diffuses, or its slopes are read.
    std::vector<bool> edge_counts() const {
        const std::size_t count = species_.size();
        std::vector<bool> counts(count);
        for (std::size_t i = 0; i < count; ++i) {
            const auto said = [&](std::size_t j) {
                const std::string rate = preset_.field(fmt::format("diffusionStr_{}_{}", j + 1, i + 1));
                return (i == j || cross()) && rate.find_first_not_of(" 0.;") != std::string::npos;
            };
            const auto sloped = [&](std::size_t j) {
                const std::string reaction = preset_.field(fmt::format("reactionStr_{}", j + 1));
                return reaction.find(species_[i] + "_x") != std::string::npos ||
                       reaction.find(species_[i] + "_y") != std::string::npos;
            };
            for (std::size_t j = 0; j < count; ++j) counts[i] = counts[i] || said(j) || sloped(j);
        }
        return counts;
    }

    void read_species() {
        const double count = number_in(preset_.field("numSpecies"), preset_.at("numSpecies"), "the number of species");
        if (!(count >= 1.0 && count <= 4.0) || count != std::floor(count)) fail("numSpecies", "must be 1, 2, 3 or 4");
        std::string list = preset_.field("speciesNames") + " ";
        std::ranges::replace(list, ',', ' ');
        for (std::size_t at = list.find_first_not_of(' '); at != std::string::npos;
             at = list.find_first_not_of(' ', at)) {
            const std::size_t end = list.find(' ', at);
            if (species_.size() < static_cast<std::size_t>(count)) species_.push_back(list.substr(at, end - at));
            at = end;
        }
        for (const char* usual : {"u", "v", "w", "q"}) {
            if (species_.size() < static_cast<std::size_t>(count) &&
                std::ranges::find(species_, usual) == species_.end())
                species_.push_back(usual);
        }
        for (const std::string& one : species_) {
            DraftChemical chemical;
            chemical.name = names_.of(one);
            if (chemical.name != one)
                problems_.note(fmt::format("species '{}' is called '{}' here", one, chemical.name));
            draft_.chemicals.push_back(std::move(chemical));
        }
    }

    // A field of numbers alone.
    double number_of(std::string_view key) {
        class Nothing final : public Meaning {
        public:
            TermRef of_name(const FormulaToken& token) override {
                return name_term(token.text == "pi" ? "PI" : token.text);
            }
            TermRef of_call(const FormulaToken& token, std::vector<TermRef> arguments) override {
                return arguments.empty() ? number_term(1.0) : call_term(token.text, std::move(arguments));
            }
        } nothing;
        const FormulaSource source{preset_.at(key), 0};
        const TermRef term = read_formula(preset_.field(key), source, Dialect::visualpde, nothing, problems_);
        const double value = value_of(term, [](const std::string&) { return std::nan(""); });
        if (!(value > 0.0 && std::isfinite(value)))
            fail(key, fmt::format("must be a number above 0; found '{}'", preset_.field(key).substr(0, 40)));
        return value;
    }

    void read_lattice() {
        dx_ = number_of("spatialStep");
        const double side = number_of("domainScale"), steps = side / dx_;
        const double whole = std::floor(steps * (1.0 + 1e-12));
        const std::string dimension = preset_.field("dimension");
        const bool line = dimension == "1" || preset_.truth("oneDimensional");
        if (!(whole >= 1.0) || whole > (line ? 1e6 : 8192.0))
            fail("domainScale",
                 fmt::format("{:g} / {:g} gives a lattice with {:g} columns; from 1 to 8192 can be carried over", side,
                             dx_, whole));
        if (std::fabs(steps - whole) > 1e-9 * steps)
            problems_.note(
                fmt::format("{}: {:g} is no multiple of the space step {:g}; the domain is {:g} wide, as in VisualPDE",
                            preset_.at("domainScale"), side, dx_, whole * dx_));
        draft_.columns = static_cast<std::size_t>(whole);
        draft_.rows = line ? 1 : draft_.columns;
        if (!line && !preset_.truth("squareCanvas"))
            problems_.note(
                fmt::format("{}: the domain fills VisualPDE's window; a square is taken here", preset_.name()));
        draft_.stencil = "five-point";
        draft_.parameters.push_back({names_.of("dx"), number_term(dx_), {}});
        draft_.parameters.push_back({names_.of("dt"), number_term(number_of("dt")), {}});
        draft_.time_step = name_term(draft_.parameters[1].name);
    }

    void read_start() {
        for (std::size_t i = 0; i < species_.size(); ++i) {
            const std::string key = fmt::format("initCond_{}", i + 1);
            draft_.chemicals[i].start = meaning_->read(preset_.field(key), key, true);
        }
    }

    // ---- equations

    std::size_t algebraic_species() const {
        if (!cross()) return 0;
        const int said = std::atoi(preset_.field("numAlgebraicSpecies").c_str());
        const int old = preset_.truth("algebraicW")   ? (preset_.truth("algebraicV") ? 2 : 1)
                        : preset_.truth("algebraicV") ? static_cast<int>(species_.size()) - 1
                                                      : 0;
        return static_cast<std::size_t>(std::clamp(std::max(said, old), 0, static_cast<int>(species_.size())));
    }

    // A coefficient in the directions x and y: "1;2".
    TermRef coefficient(std::size_t i, std::size_t j) {
        const std::string key = fmt::format("diffusionStr_{}_{}", i + 1, j + 1);
        std::string text = preset_.field(key);
        const std::size_t end = text.find(';');
        if (end != std::string::npos && !flat() && text.find_first_not_of(" ;", end) != std::string::npos)
            problems_.refuse(
                fmt::format("{}: diffusion at different rates in x and y is not carried over", preset_.at(key)));
        return meaning_->read(text.substr(0, end), key);
    }

    // The divergence of rate * gradient(of).
    TermRef spread(const TermRef& rate, const TermRef& of, const std::string& key) {
        const TermRef square = times(meaning_->dx(), meaning_->dx());
        TermRef sum = times(rate, call_term("laplacian", {of}));
        const auto add = [&](const std::string& name, const TermRef& product) {
            const auto slope = derivative(rate, name);
            if (slope) {
                sum = plus(sum, times(*slope, product));
            } else {
                problems_.refuse(fmt::format("{}: the derivative of this rate is not known here", preset_.at(key)));
            }
        };
        const TermRef gx = call_term("gradient_x", {of}), gy = call_term("gradient_y", {of});
        for (const DraftChemical& one : draft_.chemicals) {
            const TermRef name = name_term(one.name);
            const TermRef along = times(call_term("gradient_x", {name}), gx),
                          across = times(call_term("gradient_y", {name}), gy);
            add(one.name, flat() ? along : plus(along, across));
        }
        add("COLUMN", gx);
        if (!flat()) add("ROW", gy);
        if (!meaning_->is_constant(rate))
            problems_.note(
                fmt::format("{}: diffusion at a rate that changes is written out by its derivatives, which differs "
                            "from VisualPDE's averages in second order",
                            preset_.at(key)));
        return over(sum, square);
    }

    bool of_place(const TermRef& rate) const {
        return of_names_only(rate, [this](const std::string& name) {
            return name == "COLUMN" || name == "ROW" || name == "COLUMNS" || name == "ROWS" ||
                   meaning_->is_constant(name_term(name));
        });
    }

    // What the cells' own diffusion does exactly as VisualPDE: the mean of two cells' rates times their difference.
    bool as_own_rate(std::size_t i, const TermRef& rate, const TermRef& scale) {
        const double value = value_of(rate, [this](const std::string& name) { return meaning_->value(name); });
        const bool constant = meaning_->is_constant(rate) && value >= 0.0;
        if (!(constant || (of_place(rate) && !meaning_->is_constant(rate))) || !meaning_->is_constant(scale))
            return false;
        draft_.chemicals[i].rate = over(over(rate, times(meaning_->dx(), meaning_->dx())), scale);
        return true;
    }

    TermRef scale_of(std::size_t i) {
        const std::string key = fmt::format("timescale_{}", i + 1);
        return preset_.truth("timescales") ? meaning_->read(preset_.field(key), key) : number_term(1.0);
    }

    void read_equations() {
        const std::size_t differential = species_.size() - algebraic_species();
        std::string reactions;
        std::vector<std::string> later;
        for (std::size_t i = 0; i < species_.size(); ++i) {
            const bool algebraic = i >= differential;
            const std::string key = fmt::format("reactionStr_{}", i + 1);
            const TermRef scale = scale_of(i);
            TermRef change = meaning_->read(preset_.field(key), key);
            for (std::size_t j = 0; j < species_.size(); ++j) {
                if (i != j && !cross()) continue;
                const TermRef rate = coefficient(i, j);
                if (i == j) change = plus(change, inflow(edges_[i], flat(), rate, meaning_->dx()));
                if (is_number(rate, 0.0) || (i == j && !algebraic && as_own_rate(i, rate, scale))) continue;
                change =
                    plus(change, spread(rate, meaning_->species(j), fmt::format("diffusionStr_{}_{}", i + 1, j + 1)));
            }
            change = over(change, scale);
            const std::string& name = draft_.chemicals[i].name;
            if (algebraic)
                later.push_back(fmt::format("rule always set {} conc ({})", name, text_of(change)));
            else if (!is_number(change, 0.0))
                reactions += fmt::format(" {} by ({})", name, text_of(change));
        }
        if (!reactions.empty()) draft_.rules.push_back("rule always react" + reactions);
        draft_.rules.insert(draft_.rules.end(), later.begin(), later.end());
        fix_edges();
    }

    void fix_edges() {
        for (std::size_t i = 0; i < species_.size(); ++i) {
            const std::string& name = draft_.chemicals[i].name;
            for (std::size_t side = 0; side < (flat() ? 2u : 4u); ++side) {
                if (edges_[i][side].kind != PdeSide::Kind::fixed) continue;
                const auto same = [&](std::size_t other) {
                    return edges_[i][other].kind == PdeSide::Kind::fixed &&
                           text_of(edges_[i][other].value) == text_of(edges_[i][side].value);
                };
                bool before = false;
                for (std::size_t other = 0; other < side; ++other) before = before || same(other);
                if (before) continue;
                PdeEdges alike;
                for (std::size_t other = 0; other < 4; ++other) {
                    if (same(other)) alike[other] = edges_[i][other];
                }
                fix(text_of(cells_along(alike, flat(), PdeSide::Kind::fixed)), name, edges_[i][side].value);
            }
        }
    }

    void fix(const std::string& where, const std::string& name, const TermRef& value) {
        draft_.rules.push_back(fmt::format("rule if ({}) set {} conc ({})", where, name, text_of(value)));
        const bool at_start = of_names_only(value, [](const std::string& word) { return word != "TIME"; });
        if (at_start)
            draft_.starts.push_back(
                fmt::format("set cells where ({}) chemical {} conc ({})", where, name, text_of(value)));
    }

    // A domain given by an expression: where it is not above 0, a fixed species has its value.
    void read_domain() {
        if (!preset_.truth("domainViaIndicatorFun")) return;
        const TermRef inside = meaning_->read(preset_.field("domainIndicatorFun"), "domainIndicatorFun");
        const TermRef outside =
            is_truth(inside) ? call_term("not", {inside}) : call_term("<=", {inside, number_term(0.0)});
        for (std::size_t i = 0; i < species_.size(); ++i) {
            if (edges_[i][0].kind == PdeSide::Kind::fixed)
                fix(text_of(outside), draft_.chemicals[i].name, edges_[i][0].value);
            else
                problems_.note(fmt::format(
                    "{}: '{}' fills the whole rectangle here; only fixed values can be kept outside of a domain",
                    preset_.at("domainIndicatorFun"), species_[i]));
        }
    }

    void read_course() {
        const double step = draft_.parameters[1].value->value;
        if (preset_.truth("autoPause")) {
            const double end = meaning_->value(""), said = std::atof(preset_.field("autoPauseAt").c_str());
            const double iterations = std::isnan(end) ? std::ceil(said / step) : 0.0;
            if (iterations >= 1.0 && iterations < 1e9) draft_.last_iteration = static_cast<std::size_t>(iterations);
        }
        read_output();
        draft_.heading.push_back("Carried over from a preset of VisualPDE. Lengths are in cells of size dx.");
    }

    void read_output() {
        const std::string shown = preset_.field("whatToPlot");
        const Problems before = problems_;
        TermRef term = meaning_->species(0);
        try {
            if (!shown.empty()) term = meaning_->read(shown, "whatToPlot");
            problems_.check();
        } catch (const Error&) {
            problems_ = before;
            problems_.note(
                fmt::format("{}: '{}' cannot be drawn; '{}' is", preset_.at("whatToPlot"), shown, species_[0]));
            term = meaning_->species(0);
        }
        const bool alone =
            std::ranges::find(draft_.chemicals, term->text, &DraftChemical::name) != draft_.chemicals.end();
        const std::string what = is_name(term) && alone ? text_of(term) : "(" + text_of(term) + ")";
        draft_.outputs.push_back(fmt::format("output {}{} colormap viridis", what, range_of_colours()));
    }

    std::string range_of_colours() const {
        if (!preset_.says("minColourValue") || !preset_.says("maxColourValue") || preset_.truth("autoSetColourRange"))
            return {};
        try {
            const double low = number_in(preset_.field("minColourValue"), "", ""),
                         high = number_in(preset_.field("maxColourValue"), "", "");
            return low < high ? fmt::format(" range {} {}", number_text(low), number_text(high)) : "";
        } catch (const Error&) {
            return {};  // it is an expression
        }
    }

    void note_the_rest() {
        const std::string scheme = preset_.field("timesteppingScheme");
        if (scheme != "Euler")
            problems_.note(
                fmt::format("{}: '{}' becomes explicit Euler steps", preset_.at("timesteppingScheme"), scheme));
        if (preset_.truth("automataMode"))
            problems_.refuse(fmt::format("{}: automata, which are no equations in time, are not carried over",
                                         preset_.at("automataMode")));
        const std::string parent = preset_.field("parent");
        if (!parent.empty() && parent != "default")
            problems_.note(
                fmt::format("{}: what this file leaves out is that of VisualPDE's default preset, not of '{}'",
                            preset_.at("parent"), parent));
        const std::string state = preset_.field("initialState");
        if (!state.empty() && state != "\"\"")
            problems_.note(
                fmt::format("{}: a saved state is left out; the initial conditions hold", preset_.at("initialState")));
    }

    PdePreset preset_;
    Problems& problems_;
    Draft draft_;
    NewNames names_;
    std::vector<std::string> species_;
    std::vector<PdeEdges> edges_;
    std::unique_ptr<PdeMeaning> meaning_;
    double dx_ = 1.0;
};

}  // namespace

Draft read_visualpde(std::string text, const std::string& name, Problems& problems) {
    return PdeReader(std::move(text), name, problems).read();
}

}  // namespace pelage::imports
