// An experiment as a plain value: chemicals, how the tissue starts, rules, phases and what to record.
// The language parses text into it; a C++ user may also fill one by hand and call validate().
#pragma once

#include "core/expression.hpp"
#include "core/models.hpp"
#include "core/neural.hpp"
#include "core/operand.hpp"
#include "core/parameter.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace pelage {

inline constexpr std::uint64_t forever = std::numeric_limits<std::uint64_t>::max();
inline constexpr std::uint64_t largest_iteration = 0xffffffffu;  // the random counter has 32 bits for it
inline constexpr std::size_t largest_cell_count = 0x7fffffffu;   // device kernels index cells with int
inline constexpr std::size_t largest_chemical_count = 64;
inline constexpr double smallest_time_step = std::numeric_limits<float>::min();  // smaller ones are 0 in float

// Weights of a lattice Laplacian; the cell's own weight is minus the sum of the others.
enum class Stencil {
    moore,       // eight neighbours, weight 1 each (Malheiros & Walter 2017)
    nine_point,  // [1 4 1; 4 -20 4; 1 4 1] / 6, isotropic (Malheiros, Fensterseifer & Walter 2020)
    five_point,  // four edge neighbours, weight 1 each
    sims,        // 0.2 along edges, 0.05 along diagonals (Sims; McConnell 2024)
    own,         // Experiment::weights
    // of volumes
    seven_point,        // six faces, weight 1 each
    twenty_seven_point  // faces 14, edges 3, corners 1, each / 30: isotropic up to the fourth order
};
constexpr bool of_volumes(Stencil stencil) {
    return stencil == Stencil::seven_point || stencil == Stencil::twenty_seven_point;
}

// Of a stencil of the user's own: three or five rows from the upper to the lower one, each of as many numbers from left
// to right. The middle is minus the sum of the others. They need not be symmetric, and may be negative.
using StencilWeights = std::vector<double>;

// How far the neighbours are that square weights reach: 1 of 9, 2 of 25, 3 of 49.
constexpr int reach_of(std::size_t weights) { return weights > 25 ? 3 : weights > 9 ? 2 : 1; }

// Weights with a name, which expressions take the sum of cells with: NAME(U). They lie as StencilWeights do, 9, 25 or
// 49 of them, and may add up to anything.
struct NamedStencil {
    std::string name;
    std::size_t line = 0;
    StencilWeights weights;

    int reach() const { return reach_of(weights.size()); }
    double weight(int right, int up) const {
        const int side = 2 * reach() + 1;
        return weights[static_cast<std::size_t>(side * (reach() - up) + reach() + right)];
    }
};
inline constexpr std::size_t largest_stencil_count = 32;

enum class Boundary {
    no_flux,   // the edge element repeats itself outward
    wrap,      // torus
    absorbing  // concentrations outside the lattice read as 0
};

struct Bounds {
    double floor = 0.0;  // -infinity: unbounded below
    double limit = std::numeric_limits<double>::infinity();
};

// Values of one chemical for every element of a lattice, row-major, bottom row first.
struct Field {
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<double> values;
};

struct Chemical {
    std::string name;
    Bounds bounds;
    bool anisotropic = false;
    std::shared_ptr<const Field> initial;  // from a picture or array; overrides `use` and `set` when present
};

// ---- conditions

struct Always {};
struct Compare {
    Operand left;
    Comparison comparison = Comparison::equal;
    Operand right;
};
struct Within {  // low <= value <= high
    Operand value;
    Operand low;
    Operand high;
};
struct Probability {  // true where a uniform draw in [0, 1) is less than chance
    Operand chance;
};
using Condition = std::variant<Always, Compare, Within, Probability>;

// ---- actions

// Adds scale * f(species) * dt to each species that the model changes.
struct React {
    Model model;
    std::vector<std::size_t> species;  // chemicals, in the order of ModelFacts::species; all different
    Operand scale = Operand::number(1.0);
    std::vector<Operand> parameters;  // in the order of ModelFacts::parameters
};

// A reaction written out: adds rate * dt to each chemical, all rates being computed from the old state.
struct Formula {
    struct Part {
        std::size_t chemical = 0;
        Operand rate;
    };
    std::vector<Part> parts;  // chemicals all different
};

// A reaction that a network computes, and its diffusion: adds (diffusion * c * laplacian + rate * f(species)) * dt to
// each species, with c of group_rate(). All read the old state.
struct Neural {
    std::vector<std::size_t> species;        // chemicals, as many as the network has; all different
    std::shared_ptr<const Network> network;  // never null
    Operand rate = Operand::number(1.0);
    Operand diffusion = Operand::number(1.0);

    // Whether there is no diffusion, whatever the state.
    bool still() const { return diffusion == Operand::number(0.0); }
};

enum class Target { concentration, rate };

struct Change {  // adds amount, or a uniform draw from [amount - deviation, amount + deviation)
    Target target = Target::concentration;
    std::size_t chemical = 0;
    Operand amount;
    double deviation = 0.0;
};

struct Set {  // replaces what the iteration would have made of it, diffusion included; bounds still hold
    Target target = Target::concentration;
    std::size_t chemical = 0;
    Operand value;
};

struct Map {  // mapping = value carried linearly from [from_low, from_high] to [to_low, to_high], clamped
    Operand value;
    double from_low = 0.0;
    double from_high = 1.0;
    std::size_t mapping = 0;
    double to_low = 0.0;
    double to_high = 1.0;
};

struct Polarize {  // polarity becomes the unit gradient of the chemical where that is steep enough
    std::size_t chemical = 0;
};

struct Divide {  // degrees, relative to polarity
    Operand direction = Operand::number(0.0);
    double deviation = 0.0;
};

struct Move {  // along polarity, in units of cell radius
    Operand distance;
    double deviation = 0.0;
};

struct And {};  // the next rule acts only where this condition holds too

enum class Distribution { shuffled, uniform, normal, triangular };  // 2020 paper, figure 3
enum class Interpolation { nearest, bilinear, bicubic };

// Matrix expansion: inserts `columns` columns, then `rows` rows (or rows first), each by duplicating one
// element of every row (column) in place and shifting its successors by one. The duplicate is born then. With
// `interpolation` the matrix is stretched to that size instead, and nothing is drawn or born.
struct Expand {
    std::size_t columns = 0;
    std::size_t rows = 0;
    bool rows_first = false;
    Distribution distribution = Distribution::uniform;
    // Elements whose relative place lies in [band_low, band_high] are picked `band_weight` times as often.
    double band_weight = 1.0;
    double band_low = 0.0;
    double band_high = 0.0;
    bool band_rows = true;  // the band is one of rows (weighs row insertion), else of columns
    std::optional<Interpolation> interpolation = std::nullopt;  // 2020 paper, figure 22
};

// One more charge on a free site beside a taken one, drawn by the potentials of those sites: see core/aggregate.hpp.
struct Aggregate {
    std::size_t order = 0;      // chemical that holds a charge's place in the order of arrival, from 1; 0: a free site
    std::size_t potential = 0;  // chemical that holds the potential of a free site beside a taken one
    Operand eta = Operand::number(1.0);     // these read numbers, ITERATION and TIME alone
    Operand radius = Operand::number(1.0);  // of a charge
    Operand x = Operand::number(0.0);       // of the place that draws the growth
    Operand y = Operand::number(0.0);
    Operand strength = Operand::number(0.0);
    // Chemical that holds which seed a charge descends from; empty: nobody asks.
    std::optional<std::size_t> seed = std::nullopt;
    // Chemical that holds how large a charge is, in units of the radius; empty: all are 1. `grown` is the new charge's,
    // and reads RANDOM, too.
    std::optional<std::size_t> size = std::nullopt;
    Operand grown = Operand::number(1.0);
    bool far_field = false;  // what charges far away add is interpolated: see core/far_grid.hpp
};

using Action = std::variant<React, Formula, Neural, Change, Set, Map, Polarize, Divide, Move, And, Expand, Aggregate>;

struct Rule {
    std::size_t line = 0;           // in the experiment file; 0 when built by hand
    std::uint64_t from = 0;         // first iteration, absolute
    std::uint64_t until = forever;  // last iteration, absolute, inclusive
    std::uint64_t every = 1;        // acts where (iteration - origin - offset) is a multiple of `every`
    std::uint64_t offset = 0;       // and iteration >= origin + offset
    std::uint64_t origin = 0;       // start of the rule's phase
    Condition condition = Always{};
    Action action = And{};

    bool active(std::uint64_t iteration) const;
};

// ---- what belongs to places

inline constexpr std::size_t largest_field_count = 128;

struct ComputedField {
    Expression expression;  // of the place, of numbers, of fields before it, of RANDOM
};

enum class Fit {
    stretch,  // over the whole lattice, interpolated between the centres of pixels
    tile,     // a pixel a cell from the lower left corner on, repeated
    centre    // a pixel a cell, the middles of picture and lattice in one place
};

struct PictureField {
    std::shared_ptr<const Field> picture;  // never null
    Fit fit = Fit::stretch;
    double beside = 0.0;  // where a centred picture does not reach
};

// Round spots at places drawn by the run's seed, all alike: the sum of exp(-d^2 / (2 sigma^2)) over them, d being the
// distance in cells, on a torus the shortest way.
struct BlobField {
    std::size_t count = 0;
    double sigma = 1.0;
};
inline constexpr std::size_t largest_blob_count = 100'000;

// A number for each place of a lattice, computed when the run begins and when the lattice has grown; see fields.hpp.
struct PlaceField {
    std::string name;  // empty: a part of an expression
    std::size_t line = 0;
    std::variant<ComputedField, PictureField, BlobField> source;
};

// ---- how the tissue starts: statements carried out in order (see prepattern.hpp)

struct Spread {  // uniform in [value - deviation, value + deviation]
    double value = 0.0;
    double deviation = 0.0;
    std::optional<std::size_t> expression = std::nullopt;  // place in Experiment::expressions: gives the value instead
};

struct UseChemical {
    std::size_t chemical = 0;
    std::optional<Spread> conc;
    std::optional<Spread> diff;
};
struct UsePolarity {
    std::optional<Spread> degrees;  // empty: none
};
struct UseSeed {
    std::int64_t seed = 1;  // all 64 bits count; 0: from the clock
};
struct CreateCell {
    double x = 0.0, y = 0.0;
    bool fixed = false;
};
enum class Arrangement { sqr_grid, sqr_circle, hex_grid, hex_circle };
struct CreateGrid {
    Arrangement arrangement = Arrangement::sqr_grid;
    std::size_t columns = 0;  // diameter of a sqr_circle, radius of a hex_circle
    std::size_t rows = 0;     // 0 for circles
    double x = 0.0, y = 0.0;
    double deviation = 0.0;
    bool fixed = false;
    bool wrap = false;  // sqr_grid only
};
struct CreateMatrix {
    std::size_t columns = 0;
    std::size_t rows = 0;
    Boundary boundary = Boundary::no_flux;
    double x = 0.0, y = 0.0;
    bool charges = false;  // its cells are the sites of an aggregate
    // Of charges: place in Experiment::fields; a charge lies where that is not 0 alone.
    std::optional<std::size_t> where = std::nullopt;
};
struct CreateVolume {
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::size_t layers = 0;
    Boundary boundary = Boundary::no_flux;
};
struct MeshSurface;  // core/surface.hpp
struct CreateMesh {
    std::shared_ptr<const MeshSurface> surface;  // never null
};
struct CreateShape {
    std::vector<std::string> lines;  // top line first; letters are cells
    double x = 0.0, y = 0.0;
    bool fixed = false;
};
struct SetConcentration {
    std::size_t chemical = 0;
    Spread value;
};
struct SetRate {
    std::size_t chemical = 0;
    Spread value;
};
struct SetPolarity {
    std::optional<Spread> degrees;
};
struct SetFixed {};
struct SetCells {
    std::size_t first = 0;
    std::size_t last = 0;  // inclusive
    std::variant<SetConcentration, SetRate, SetPolarity, SetFixed> what;
    std::optional<std::size_t> where = std::nullopt;  // place in Experiment::expressions: only cells where it is true
};
using Statement = std::variant<UseChemical, UsePolarity, UseSeed, CreateCell, CreateGrid, CreateMatrix, CreateVolume,
                               CreateMesh, CreateShape, SetCells>;

// ---- phases

// A stretch of iterations with its own settings. An experiment has at least one; the last one has no end.
struct Phase {
    std::string name;
    std::uint64_t begin = 0;
    double time_step = 1.0;
    std::vector<Bounds> bounds;                // one a chemical
    std::vector<std::optional<double>> rates;  // one a chemical: every cell's diffusion rate from `begin` on
};

// ---- free cells

struct Domain {
    double width = 1000.0;  // centres stay inside, centred on (0, 0)
    double height = 1000.0;
    bool packed = false;  // a square of side sqrt(cells * area) - 2 instead
    double area = 3.2;
};

// ---- what to draw

struct ColourStop {
    double at = 0.0;  // 0..1
    std::array<std::uint8_t, 3> rgb{};
};

struct Colormap {
    // heat, striped, gradient as published; otherwise a named map ("inferno") or "stops".
    std::string name = "heat";
    std::vector<ColourStop> stops;  // for striped and gradient at slot / 99; for "stops" as written
};

enum class Drawing {
    colours,  // through the colormap
    height,   // shades of grey, 16 bits: black at the low end of the range, white at the high one
    normal    // directions of a surface whose height is the chemical's amount times Output::strength, in cells
};

enum class Axis { x, y, z };

// How a volume becomes a picture of columns and rows: the first axis that is left goes right, the second one up.
struct Projection {
    enum class Kind {
        slice,       // one layer, row or column
        maximum,     // the largest value along z
        transparent  // along z, front (layer 0) to back: what has more is more opaque
    };
    Kind kind = Kind::slice;
    Axis axis = Axis::z;                           // of a slice: the one that it is at right angles to
    std::optional<std::size_t> at = std::nullopt;  // its place there; empty: the middle
};

inline constexpr std::array<double, 3> default_view{1.0, -1.6, 1.2};  // of a mesh, to its middle

struct Output {  // one picture
    std::size_t chemical = 0;
    Colormap colormap;
    std::optional<std::array<double, 2>> range;  // drawn from low to high colour; empty: minimum to maximum
    bool own_range = false;                      // of each picture; else all snapshots of a run share theirs
    Drawing drawing = Drawing::colours;
    double strength = 1.0;  // of a normal map
    // Drawn instead of the chemical: one, or three that are red, green and blue of 0 to 1, without colormap and range.
    std::vector<Expression> expressions = {};
    std::string name = {};                                     // of the file, where the experiment gives one
    std::optional<Projection> projection = std::nullopt;       // of a volume; empty: its middle layer
    std::optional<std::array<double, 3>> view = std::nullopt;  // of a mesh: from where; empty: see default_view

    bool rgb() const { return expressions.size() == 3; }
};

struct InputFile {            // a picture, an array or a shape that the experiment starts from, or a network
    std::string name;         // as the experiment says it
    std::string sha256;       // of its bytes; empty: it was not read, as a resumed run does not need it
    bool throughout = false;  // rules ask it in every iteration, so a resumed run needs the same
};

struct IncludedLines {      // of Experiment::text, from another file; in order, those of a file before those within it
    std::size_t first = 0;  // line of the text
    std::size_t last = 0;   // inclusive; 0: not known yet
    std::size_t by = 0;     // line of the text that includes them
    std::string file;       // as that line says it
};

struct Experiment {
    std::string source = "(built by hand)";  // file name, for messages
    std::string text;  // the file's whole text and all it includes, kept with results, with the parameters as set
    std::vector<Parameter> parameters;  // for who wants to know: their values stand where they were named

    std::vector<Chemical> chemicals;
    std::vector<std::string> mappings;
    std::vector<Expression> expressions;  // that operands and starts name
    std::vector<PlaceField> fields;
    std::vector<Statement> prepattern;
    std::vector<Rule> rules;
    std::vector<Phase> phases;

    Stencil stencil = Stencil::nine_point;  // of a matrix or a volume; see space_of()
    StencilWeights weights;                 // of Stencil::own
    std::vector<NamedStencil> stencils;     // that expressions name
    Domain domain;
    std::size_t division_limit = 0;  // a cell with more neighbours does not divide; 0: no limit

    std::uint64_t stop_at = 10000;
    std::vector<std::uint64_t> snap_at;  // ascending, without doubles
    bool exit_after_snaps = false;       // end at the last snapshot even if stop_at is later

    std::vector<Output> outputs;  // at least one of colours: the first of those is final.png
    std::vector<InputFile> inputs;
    std::vector<IncludedLines> included;
    std::optional<std::array<std::size_t, 2>> texture;
    double zoom = 1.0;

    std::optional<std::int64_t> seed;  // overrides every `use seed`

    std::size_t chemical(const std::string& name) const;  // throws Error naming those defined
    // For messages: "cow.pex:3", or of an included line "cow.pex:3: in disc.pex:5".
    std::string where(std::size_t line) const;
    const Phase& phase_at(std::uint64_t iteration) const;
    std::uint64_t last_iteration() const;           // where a whole run ends
    double time_at(std::uint64_t iteration) const;  // the time steps of all iterations before it, added up
    // Key of the draws made during the run: seed, else the last `use seed`, else 1. Still 0 where the seed is left to
    // the clock and settle_seed() of core/seed.hpp has not been called.
    std::int64_t run_seed() const;
};

// The word for it in names of files: the name that the experiment gives, the chemical's, "rgb" or "formula".
std::string output_name(const Experiment&, const Output&);

// Throws Error when an experiment cannot mean anything: no cells, an index out of range, a duplicate name,
// unsorted phases, more cells than largest_cell_count, a number that is not finite, a time step that is 0 in float, a
// start that start_faults() of core/starts.hpp refuses.
void validate(const Experiment&);

}  // namespace pelage
