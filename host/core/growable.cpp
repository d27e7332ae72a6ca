// See growable.hpp.
#include "core/growable.hpp"

#include "core/error.hpp"
#include "core/space.hpp"

#include <fmt/format.h>

#include <variant>

namespace pelage {

void Growable::expand(const Insertion& insertion) {
    const std::size_t lines = insertion.column ? rows() : columns();
    const std::size_t places = insertion.column ? columns() : rows();
    if (insertion.picks.size() != lines) {
        throw Error(fmt::format("an expansion of a {} x {} matrix needs {} picks; found {}", columns(), rows(), lines,
                                insertion.picks.size()));
    }
    for (const std::uint32_t pick : insertion.picks) {
        if (pick >= places) throw Error(fmt::format("a pick of {} lies outside 0..{}", pick, places - 1));
    }
    check_whole();
    insert(insertion);
}

void Growable::take_place(const Expansion& expansion) {
    const Expand& growth = *expansion.growth;
    if (growth.interpolation) return stretch(growth);
    for (std::size_t nth = 0; nth < growth.columns + growth.rows; ++nth) {
        const bool column = growth.rows_first ? nth >= growth.rows : nth < growth.columns;
        insert(draw_insertion(growth, column, columns(), rows(), experiment().run_seed(), iteration(), expansion.rule,
                              nth));
    }
}

void Growable::insert(const Insertion& insertion) {
    reshape(columns() + (insertion.column ? 1 : 0), rows() + (insertion.column ? 0 : 1), [&] { do_expand(insertion); });
}

void Growable::stretch(const Expand& growth) {
    const std::size_t wide = columns() + growth.columns;
    const std::size_t high = rows() + growth.rows;
    const bool wrap = std::get<Lattice>(space_of(experiment())).boundary == Boundary::wrap;
    reshape(wide, high, [&] {
        do_resample({sampling(*growth.interpolation, wrap, columns(), wide),
                     sampling(*growth.interpolation, wrap, rows(), high)});
    });
}

Growable& growable(Tissue& tissue) {
    auto* found = dynamic_cast<Growable*>(&tissue);
    if (found != nullptr && tissue.layers() == 0) return *found;
    throw Error(fmt::format("only a lattice can be expanded; this tissue {}",
                            tissue.layers() != 0 ? "is a volume" : "has free cells"));
}

}  // namespace pelage
