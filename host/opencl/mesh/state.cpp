// See state.hpp.
#include "opencl/mesh/state.hpp"

#include "core/fields.hpp"
#include "core/subnormal.hpp"
#include "opencl/mesh/lists.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

namespace pelage {

namespace {

template <class V>
cl::Buffer holding(const Session& session, const std::vector<V>& values, const char* what) {
    cl::Buffer buffer = session.buffer(values.size() * sizeof(V), what);
    if (!values.empty())
        session.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, values.size() * sizeof(V), values.data());
    return buffer;
}

// A column on its own, and those of the chemical i and of the next one, if there is one: kernels/mesh/pairs.cl.
std::span<const std::vector<double>> alone(const std::vector<double>& column) { return {&column, 1}; }
template <class List>
auto pair(List& columns, std::size_t i) {
    return std::span(columns).subspan(i, std::min<std::size_t>(2, columns.size() - i));
}

std::size_t whole_blocks(std::size_t cells) { return (cells + mesh_block - 1) / mesh_block * mesh_block; }

}  // namespace

MeshState::MeshState(const Session& session, const Experiment& experiment, std::shared_ptr<const MeshSurface> surface)
    : session_(session),
      surface_(std::move(surface)),
      pitch_(whole_blocks(surface_->cells())),
      chemicals_(experiment.chemicals.size()),
      conc_(planes(chemicals_, "concentrations")),
      spare_conc_(planes(chemicals_, "concentrations")),
      rate_(planes(chemicals_, "rates")),
      spare_rate_(planes(chemicals_, "rates")),
      mapping_(planes(experiment.mappings.size(), "mappings")),
      ids_(holding(session, filled(surface_->order), "ids")) {
    upload_places(experiment);
    upload_lists();
}

void MeshState::upload_places(const Experiment& experiment) {
    std::vector<std::vector<double>> columns;
    for (std::size_t axis = 0; axis < 3; ++axis) columns.push_back(coordinates(*surface_, axis));
    for (std::vector<double>& values : mesh_blobs(experiment, *surface_, session_.options().precision)) {
        if (!values.empty()) columns.push_back(std::move(values));
    }
    places_ = planes(columns.size(), "places");
    for (std::size_t i = 0; i < columns.size(); ++i) upload(places_, i, alone(columns[i]));
}

cl::Buffer MeshState::planes(std::size_t count, const char* what) const {
    return session_.buffer(count * pitch_ * session_.scalar_bytes(), what);
}

void MeshState::upload_lists() {
    const MeshLists lists = mesh_lists(*surface_);
    rows_ = holding(session_, lists.rows, "begins of lists");
    lengths_ = holding(session_, lists.lengths, "lengths of lists");
    indices_ = holding(session_, lists.indices, "neighbours");
    if (session_.is_double()) {
        weights_ = holding(session_, lists.weights, "weights of neighbours");
        return;
    }
    std::vector<float> weights(lists.weights.size());
    std::ranges::transform(lists.weights, weights.begin(), in_precision<float>);
    weights_ = holding(session_, weights, "weights of neighbours");
}

template <class V>
std::vector<V> MeshState::filled(std::vector<V> values) const {
    values.resize(pitch_);
    return values;
}

template <class V>
std::vector<V> MeshState::in_order(const std::vector<V>& by_id) const {
    std::vector<V> result(by_id.size());
    std::ranges::transform(surface_->order, result.begin(), [&](std::uint32_t id) { return by_id[id]; });
    return filled(std::move(result));
}

template <class T>
void MeshState::upload(const cl::Buffer& buffer, std::size_t plane, Columns together) {
    std::vector<T> values(together.size() * pitch_);
    for (std::size_t i = 0; i < cells(); ++i) {
        for (std::size_t k = 0; k < together.size(); ++k)
            values[together.size() * i + k] = in_precision<T>(together[k][surface_->order[i]]);
    }
    session_.queue().enqueueWriteBuffer(buffer, CL_TRUE, plane * pitch_ * sizeof(T), values.size() * sizeof(T),
                                        values.data());
}

void MeshState::upload(const cl::Buffer& buffer, std::size_t plane, Columns together) {
    if (session_.is_double()) return upload<double>(buffer, plane, together);
    upload<float>(buffer, plane, together);
}

template <class T>
void MeshState::download(const cl::Buffer& buffer, std::size_t plane, WritableColumns together) const {
    std::vector<T> values(together.size() * pitch_);
    session_.queue().enqueueReadBuffer(buffer, CL_TRUE, plane * pitch_ * sizeof(T), values.size() * sizeof(T),
                                       values.data());
    for (std::size_t k = 0; k < together.size(); ++k) {
        together[k].resize(cells());
        for (std::size_t i = 0; i < cells(); ++i)
            together[k][surface_->order[i]] = static_cast<double>(values[together.size() * i + k]);
    }
}

void MeshState::download(const cl::Buffer& buffer, std::size_t plane, WritableColumns together) const {
    if (session_.is_double()) return download<double>(buffer, plane, together);
    download<float>(buffer, plane, together);
}

void MeshState::write(const Snapshot& snapshot) {
    kept_ = snapshot;
    for (std::size_t i = 0; i < chemicals_; i += 2) upload(conc_, i, pair(snapshot.conc, i));
    for (std::size_t i = 0; i < chemicals_; ++i) upload(rate_, i, alone(snapshot.diff[i]));
    for (std::size_t i = 0; i < snapshot.mappings.size(); ++i) upload(mapping_, i, alone(snapshot.mappings[i]));
    neighbours_ = holding(session_, in_order(snapshot.neighbours), "neighbour counts");
    birth_ = holding(session_, in_order(snapshot.birth), "births");
    for (auto* columns : {&kept_.x, &kept_.y, &kept_.polarity_x, &kept_.polarity_y}) {
        if (session_.is_double()) break;
        for (double& value : *columns) value = double{in_precision<float>(value)};
    }
}

Snapshot MeshState::read() const {
    Snapshot snapshot = kept_;
    for (std::size_t i = 0; i < chemicals_; i += 2) download(conc_, i, pair(snapshot.conc, i));
    for (std::size_t i = 0; i < chemicals_; ++i) download(rate_, i, {&snapshot.diff[i], 1});
    for (std::size_t i = 0; i < snapshot.mappings.size(); ++i) download(mapping_, i, {&snapshot.mappings[i], 1});
    std::vector<std::int32_t> counts(cells());
    session_.queue().enqueueReadBuffer(neighbours_, CL_TRUE, 0, counts.size() * sizeof counts[0], counts.data());
    for (std::size_t i = 0; i < counts.size(); ++i) snapshot.neighbours[surface_->order[i]] = counts[i];
    return snapshot;
}

void MeshState::fill_rate(std::size_t chemical, double rate) {
    upload(rate_, chemical, alone(std::vector<double>(cells(), rate)));
}

void MeshState::add_to(Arguments& arguments, bool writes_rates) {
    const std::size_t bytes = chemicals_ * pitch_ * session_.scalar_bytes();
    session_.poison_buffer(spare_conc_, bytes);
    if (writes_rates) session_.poison_buffer(spare_rate_, bytes);
    arguments.add(conc_, spare_conc_, rate_, spare_rate_, mapping_, neighbours_, birth_, ids_, places_, rows_, lengths_,
                  indices_, weights_);
}

void MeshState::swap(bool rates) {
    std::swap(conc_, spare_conc_);
    if (rates) std::swap(rate_, spare_rate_);
    neighbours_ = lengths_;
}

}  // namespace pelage
