// What the parts of a random experiment know of each other while its text is being written.
#pragma once

#include "verify/dice.hpp"
#include "verify/random_experiment.hpp"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

namespace pelage::verify {

struct ChemicalDraft {
    std::string name;
    double conc = 1.0;    // about which its cells start
    double spread = 0.5;  // and how far from there
    double rate = 0.0;    // largest that cells start with
    double floor = 0.0;
    double limit = std::numeric_limits<double>::infinity();
    bool pinned = false;  // its bounds stay: cells start far from conc
};

struct MappingDraft {
    std::string name;
    double low = 0.0, high = 1.0;
};

enum class TissueKind { matrix, sqr_grid, free_cells, volume, mesh, charges };

struct Draft {
    Draft(std::uint64_t seed, const RandomLimits& l) : dice(seed), limits(l) {}

    Dice dice;
    const RandomLimits& limits;
    TissueKind kind = TissueKind::matrix;
    std::size_t columns = 0, rows = 0;  // of a lattice or a volume
    std::size_t layers = 1;             // of a volume
    double radius = 1.0;                // of a mesh: how far its vertices lie from the middle
    bool far_field = false;             // of charges: one way for all rules
    std::size_t cells = 0;
    double stiffness = 9.0;  // see core/stability.hpp
    double time_step = 1.0;
    std::uint64_t iterations = 0;  // of the run
    std::uint64_t span = 0;        // of the stretch whose rules are being written
    std::vector<ChemicalDraft> chemicals;
    std::vector<MappingDraft> mappings;
    std::vector<std::string> fields;
    std::vector<std::string> stencils;
    bool wide = false;             // neighbours are those of 25 weights: no chemical is anisotropic
    std::size_t growth_rules = 0;  // `divide` and `expand` so far
    std::string text;

    bool lattice() const { return kind == TissueKind::matrix || kind == TissueKind::sqr_grid; }
    bool grid() const { return lattice() || kind == TissueKind::volume; }
    bool plane() const { return lattice() || kind == TissueKind::free_cells; }  // where cells have polarity
    double largest_rate() const;  // that diffusion holds at this time step, and no more than 20

    ChemicalDraft& any_chemical() { return chemicals[dice.below(chemicals.size())]; }
    std::string value(double low, double high);              // a number, or seldom one at the end of what a float holds
    std::string deviated(double value, double deviation);    // VALUE [dev DEVIATION]
    std::string shuffled(std::vector<std::string> options);  // in any order, blanks between
    void line(const std::string&);                           // with the odd comment, blank and empty line
};

// The words that are not empty, blanks between. Braces have their parts evaluated from left to right, which calls and
// sums do not: wherever two parts are drawn this keeps their order the same for all compilers.
std::string words(std::initializer_list<std::string>);

// The parts, in the order in which they are written.
void draw_world(Draft&);     // chemicals, cells, `use` and `set`
void draw_course(Draft&);    // rules and phases, and where the run ends
void draw_pictures(Draft&);  // what is drawn of it
void name_numbers(Draft&);   // some of what was drawn: random_parameters.cpp

void draw_rule(Draft&);  // random_rules.cpp

// random_spaces.cpp: chooses a volume or a mesh, and returns the statement that creates it.
std::string draw_volume(Draft&);
std::string draw_mesh(Draft&);
void draw_charges(Draft&);          // all of their world
std::string draw_particle(Draft&);  // the action that adds one

// A condition, "always" included, and an action other than growth.
std::string draw_condition(Draft&);  // random_operands.cpp
std::string draw_operand(Draft&);    // any value that a rule can read
// A number between the two, or some other value in its place.
std::string draw_parameter(Draft&, double low, double high);

// An expression in parentheses, of values between the two; in rules it may read more than in fields and starts.
enum class ExpressionScope { rule, field, start };
std::string draw_expression(Draft&, ExpressionScope, double low, double high);  // random_expressions.cpp
std::string draw_truth(Draft&);                                                 // of rules

}  // namespace pelage::verify
