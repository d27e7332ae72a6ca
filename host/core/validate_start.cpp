// validate()'s part about the tissue's start: places, amounts, sizes, and what start_faults() refuses.
#include "core/checks.hpp"
#include "core/prepattern.hpp"
#include "core/scene.hpp"
#include "core/starts.hpp"
#include "core/visit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace pelage {

namespace {

class StartChecks : public Checks {
public:
    using Checks::Checks;

    void check() const {
        for (const Statement& statement : experiment_.prepattern) {
            std::visit([&](const auto& one) { check_statement(one); }, statement);
        }
        check_domain(experiment_.domain);
        check_alone();
        const std::size_t cells = count_cells(experiment_);
        if (cells == 0) fail("no cells are created; `create` some");
        check_size(cells, 1);
        for (const StartFault& fault : start_faults(experiment_)) {
            // A state built by hand may bring what the experiment does not tell.
            if (fault.refused && !fault.untold) fail(fault.text);
        }
    }

private:
    // A volume holds all cells, and so does a mesh.
    void check_alone() const {
        std::size_t volumes = 0, meshes = 0, others = 0;
        for (const Statement& statement : experiment_.prepattern) {
            std::visit(Overloaded{[&](const CreateVolume&) { ++volumes; }, [&](const CreateMesh&) { ++meshes; },
                                  [&](const CreateMatrix&) { ++others; }, [&](const CreateGrid&) { ++others; },
                                  [&](const CreateCell&) { ++others; }, [&](const CreateShape&) { ++others; },
                                  [](const auto&) {}},
                       statement);
        }
        if (volumes > 1 || (volumes == 1 && meshes + others > 0))
            fail("a volume holds all cells; create nothing beside it");
        if (meshes > 1 || (meshes == 1 && others > 0)) fail("a mesh holds all cells; create nothing beside it");
    }
    void check_start(std::size_t expression) const {
        each_operand(checked_expression(expression, "a start"), [&](const Operand& part) {
            if (!seen_at_start(part.quantity)) fail("a start reads what there is in rules alone");
        });
    }
    void check_spread(const Spread& spread, const char* what) const {
        if (spread.expression) check_start(*spread.expression);
        if (spread.expression && spread.deviation != 0.0) fail("an expression takes no deviation");
        check_number(spread.value, what);
        check_deviation(spread.deviation);
    }
    void check_place(double x, double y) const {
        check_number(x, "a place");
        check_number(y, "a place");
    }

    void check_statement(const UseChemical& use) const {
        check_chemical(use.chemical, "a `use`");
        if (use.conc) check_spread(*use.conc, "a concentration");
        if (use.diff) check_spread(*use.diff, "a diffusion rate");
    }
    void check_statement(const UsePolarity& use) const {
        if (use.degrees) check_spread(*use.degrees, "a polarity");
    }
    void check_statement(const UseSeed&) const {}
    void check_statement(const CreateCell& cell) const { check_place(cell.x, cell.y); }
    void check_statement(const CreateGrid& grid) const {
        check_size(grid.columns, std::max<std::size_t>(grid.rows, 1));
        check_place(grid.x, grid.y);
        check_deviation(grid.deviation);
    }
    void check_statement(const CreateMatrix& matrix) const {
        check_size(matrix.columns, matrix.rows);
        check_place(matrix.x, matrix.y);
    }
    void check_statement(const CreateVolume& volume) const {
        if (volume.columns == 0 || volume.rows == 0 || volume.layers == 0) fail("a volume has a side without cells");
        check_size(volume.columns, volume.rows);
        check_size(volume.columns * volume.rows, volume.layers);
    }
    void check_statement(const CreateMesh& mesh) const {
        if (mesh.surface == nullptr) fail("a mesh has no surface");
    }
    void check_statement(const CreateShape& shape) const { check_place(shape.x, shape.y); }
    void check_statement(const SetCells& set) const {
        if (set.where) check_start(*set.where);
        std::visit(Overloaded{[&](const SetConcentration& conc) {
                                  check_chemical(conc.chemical, "a `set`");
                                  check_spread(conc.value, "a concentration");
                              },
                              [&](const SetRate& rate) {
                                  check_chemical(rate.chemical, "a `set`");
                                  check_spread(rate.value, "a diffusion rate");
                              },
                              [&](const SetPolarity& polarity) {
                                  if (polarity.degrees) check_spread(*polarity.degrees, "a polarity");
                              },
                              [](const SetFixed&) {}},
                   set.what);
    }

    void check_domain(const Domain& domain) const {
        for (const double length : {domain.width, domain.height, domain.area}) {
            const auto single = static_cast<float>(length);
            if (!(single > 0.0f) || !std::isfinite(single))
                fail(fmt::format("the domain's width, height and area must be positive; found {}", length));
        }
    }
};

}  // namespace

void validate_start(const Experiment& experiment) { StartChecks(experiment).check(); }

}  // namespace pelage
