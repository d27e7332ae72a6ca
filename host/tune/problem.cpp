// See problem.hpp.
#include "tune/problem.hpp"

#include "core/error.hpp"
#include "core/philox.hpp"
#include "core/prepattern.hpp"
#include "core/space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <variant>

namespace pelage::tune {

namespace {

// More than two bands of the widest, and more than two strips of the deepest; both odd.
constexpr LatticeSize verified_size{1201, 199};
constexpr std::uint64_t fewest_iterations = 1000;  // before what is timed goes back to its start

std::shared_ptr<const Field> cropped(const Field& field, LatticeSize size) {
    auto piece = std::make_shared<Field>();
    piece->columns = size.columns;
    piece->rows = size.rows;
    piece->values.reserve(size.cells());
    for (std::size_t row = 0; row < size.rows; ++row) {
        const auto begin = field.values.begin() + static_cast<std::ptrdiff_t>(row * field.columns);
        piece->values.insert(piece->values.end(), begin, begin + static_cast<std::ptrdiff_t>(size.columns));
    }
    return piece;
}

LatticeSize halved_to(LatticeSize size, std::size_t most_cells) {
    while (size.cells() > most_cells) (size.columns > size.rows ? size.columns : size.rows) /= 2;
    return size;
}

// Changes half of all concentrations a little: where a lattice is flat, a wrong kernel would not show.
void stir(Stage& stage) {
    for (std::size_t chemical = 0; chemical < stage.start.conc.size(); ++chemical) {
        const Bounds& bounds = stage.experiment.phase_at(stage.start.iteration).bounds.at(chemical);
        std::vector<double>& values = stage.start.conc[chemical];
        for (std::size_t cell = 0; cell < values.size(); ++cell) {
            const auto draws = philox4x32_10(
                {static_cast<std::uint32_t>(cell), static_cast<std::uint32_t>(chemical), 0, 0}, {0x7e57u, 0x7e57u});
            if (draws[0] % 2 == 0) continue;
            const double share = static_cast<double>(draws[1]) / 0x1p32;
            const double stirred =
                std::clamp(values[cell] * (0.94 + 0.04 * share) + 0.02 * share, bounds.floor, bounds.limit);
            values[cell] = static_cast<double>(static_cast<float>(stirred));
        }
    }
}

Stage make_stage(const Experiment& experiment, LatticeSize size, std::uint64_t first) {
    Stage stage{cut_down(experiment, size), {}};
    stage.start = initial_state(stage.experiment);
    stage.start.iteration = first;
    return stage;
}

bool tells_of_results(const std::string& word) { return word == "output" || word == "snap" || word == "stop"; }

bool number(const std::string& word) {
    std::istringstream stream(word);
    double value = 0;
    return stream >> value && stream.peek() == std::istringstream::traits_type::eof();
}

}  // namespace

LatticeSize lattice_size(const Experiment& experiment) {
    const Space space = space_of(experiment);
    const auto* lattice = std::get_if<Lattice>(&space);
    if (std::holds_alternative<Volume>(space))
        throw Error(experiment.source + ": a volume has one kernel, there is nothing to tune; lattices have several");
    if (std::holds_alternative<MeshCells>(space))
        throw Error(experiment.source + ": a mesh has one kernel, there is nothing to tune; lattices have several");
    if (lattice == nullptr) {
        throw Error(experiment.source +
                    ": free cells have one kernel, there is nothing to tune; lattices have several");
    }
    if (lattice->charges) throw Error(experiment.source + ": charges have one way to grow, there is nothing to tune");
    return {lattice->columns, lattice->rows};
}

Experiment cut_down(Experiment experiment, LatticeSize most) {
    const LatticeSize whole = lattice_size(experiment);
    const LatticeSize size{std::min(whole.columns, most.columns), std::min(whole.rows, most.rows)};
    resize_lattice(experiment, size.columns, size.rows);
    std::erase_if(experiment.prepattern, [&](const Statement& statement) {
        const auto* set = std::get_if<SetCells>(&statement);
        return set != nullptr && set->last >= size.cells();
    });
    for (Chemical& chemical : experiment.chemicals) {
        if (chemical.initial) chemical.initial = cropped(*chemical.initial, size);
    }
    return experiment;
}

Problem make_problem(const Experiment& experiment, std::uint64_t first, std::uint64_t last, std::size_t most_cells) {
    Problem problem;
    problem.verified = make_stage(experiment, verified_size, first);
    stir(problem.verified);
    problem.timed = make_stage(experiment, halved_to(lattice_size(experiment), most_cells), first);
    // As in the middle of a long run, whose end is not yet to be reckoned with.
    problem.timed.experiment.exit_after_snaps = false;
    problem.timed.experiment.stop_at = largest_iteration;
    problem.end = std::max(last, first + fewest_iterations);
    return problem;
}

std::size_t telling_cells(const std::string& device_type) {
    return device_type == "cpu" ? std::size_t{1} << 21 : std::size_t{1} << 23;
}

std::string size_class(LatticeSize size) {
    const auto rounded = [](std::size_t side) {
        return std::llround(std::exp2(std::round(std::log2(static_cast<double>(std::max<std::size_t>(1, side))))));
    };
    return fmt::format("{} x {}", rounded(size.columns), rounded(size.rows));
}

std::string rules_class(const std::string& text) {
    std::istringstream lines(text);
    std::string kept;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line.substr(0, line.find("//")));
        std::string statement;
        for (std::string word; words >> word;) {
            if (statement.empty() && tells_of_results(word)) break;
            if (!statement.empty()) statement += ' ';
            statement += number(word) ? "#" : word;
        }
        if (!statement.empty()) kept += statement + "\n";
    }
    return kept;
}

}  // namespace pelage::tune
