// See drawn.hpp.
#include "io/drawn.hpp"

#include "core/fields.hpp"
#include "core/philox.hpp"
#include "core/scene.hpp"
#include "core/space.hpp"
#include "core/surface.hpp"

#include <algorithm>
#include <utility>

namespace pelage {

namespace {

// The scene of a state, with all that it points at.
class Stage {
public:
    Stage(const Experiment& experiment, const Snapshot& state) : space_(space_of(experiment)) {
        scene_.columns = state.columns;
        scene_.rows = state.rows;
        scene_.layers = state.layers;
        scene_.x = state.x;
        scene_.y = state.y;
        scene_.conc = &state.conc;
        scene_.diff = &state.diff;
        scene_.state = &state;
        scene_.time = experiment.time_at(state.iteration);
        scene_.lattice = std::get_if<Lattice>(&space_);
        scene_.volume = std::get_if<Volume>(&space_);
        if (const auto* mesh = std::get_if<MeshCells>(&space_)) {
            scene_.adjacency = &mesh->surface->adjacency;
            scene_.z = coordinates(*mesh->surface, 2);
        }
        scene_.stencils = &experiment.stencils;
        scene_.seed = experiment.run_seed();
        scene_.purpose = purpose::output;
        scene_.fields = &fields_;
    }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;
    ~Stage() = default;

    void set_fields(const Experiment& experiment, const Snapshot& state) {
        if (state.on_grid()) {
            fields_ = field_values(experiment, extent_of(state), Precision::double_);
            return;
        }
        const auto* mesh = std::get_if<MeshCells>(&space_);
        const auto blobs = mesh == nullptr ? std::vector<std::vector<double>>{}
                                           : mesh_blobs(experiment, *mesh->surface, Precision::double_);
        for (std::size_t i = 0; i < experiment.fields.size(); ++i) {
            const auto* computed = std::get_if<ComputedField>(&experiment.fields[i].source);
            fields_.push_back(computed != nullptr ? evaluate(computed->expression, scene_) : blobs.at(i));
        }
    }
    std::vector<double> values(const Expression& expression, std::size_t place) {
        scene_.place = static_cast<std::uint32_t>(place);
        return evaluate(expression, scene_);
    }

private:
    Space space_;
    Scene scene_;
    std::vector<std::vector<double>> fields_;
};

bool reads_fields(const Output& output) {
    return std::ranges::any_of(output.expressions, [](const Expression& expression) {
        return std::ranges::any_of(expression.nodes,
                                   [](const ExpressionNode& node) { return node.operand.quantity == Quantity::field; });
    });
}

}  // namespace

std::size_t first_of_colours(const std::vector<Output>& outputs) {
    const auto found = std::ranges::find(outputs, Drawing::colours, &Output::drawing);
    return static_cast<std::size_t>(found - outputs.begin());
}

Drawn::Drawn(const Experiment& experiment, const Output& output, std::size_t place, const Snapshot& state) {
    if (output.expressions.empty()) {
        of_state_ = state.conc.at(output.chemical);
        return;
    }
    Stage stage(experiment, state);
    if (reads_fields(output)) stage.set_fields(experiment, state);
    for (std::size_t i = 0; i < output.expressions.size(); ++i)
        computed_.push_back(stage.values(output.expressions[i], 3 * place + i));
}

Drawn::Drawn(std::vector<double> values) { computed_.push_back(std::move(values)); }

std::vector<std::span<const double>> Drawn::columns() const {
    if (computed_.empty()) return {of_state_};
    return {computed_.begin(), computed_.end()};
}

}  // namespace pelage
