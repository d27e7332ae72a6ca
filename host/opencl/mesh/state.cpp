// See state.hpp.
#include "opencl/mesh/state.hpp"

#include "core/error.hpp"
#include "core/subnormal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
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

// The adjacency with cells renumbered by their place in the order; the neighbours of a cell keep theirs.
Adjacency renumbered(const MeshSurface& surface) {
    const Adjacency& from = surface.adjacency;
    std::vector<std::uint32_t> place(surface.order.size());
    for (std::size_t i = 0; i < place.size(); ++i) place[surface.order[i]] = static_cast<std::uint32_t>(i);
    Adjacency to;
    for (const std::uint32_t cell : surface.order) {
        for (std::size_t entry = from.offsets[cell]; entry < from.offsets[cell + 1]; ++entry) {
            to.indices.push_back(place[from.indices[entry]]);
            to.weights.push_back(from.weights[entry]);
        }
        to.offsets.push_back(to.indices.size());
    }
    return to;
}

}  // namespace

MeshState::MeshState(const Session& session, std::shared_ptr<const MeshSurface> surface, std::size_t chemicals,
                     std::size_t mappings)
    : session_(session),
      surface_(std::move(surface)),
      chemicals_(chemicals),
      conc_(planes(chemicals, "concentrations")),
      spare_conc_(planes(chemicals, "concentrations")),
      rate_(planes(chemicals, "rates")),
      spare_rate_(planes(chemicals, "rates")),
      mapping_(planes(mappings, "mappings")),
      ids_(holding(session, surface_->order, "ids")),
      places_(planes(3, "places")) {
    for (std::size_t axis = 0; axis < 3; ++axis) upload(places_, axis, coordinates(*surface_, axis));
    upload_adjacency();
}

cl::Buffer MeshState::planes(std::size_t count, const char* what) const {
    return session_.buffer(count * cells() * session_.scalar_bytes(), what);
}

void MeshState::upload_adjacency() {
    const Adjacency adjacency = renumbered(*surface_);
    if (adjacency.indices.size() > std::numeric_limits<std::uint32_t>::max())
        throw Error(fmt::format("{} neighbours are more than a device can count", adjacency.indices.size()));
    offsets_ = holding(session_, std::vector<std::uint32_t>(adjacency.offsets.begin(), adjacency.offsets.end()),
                       "offsets of neighbours");
    indices_ = holding(session_, adjacency.indices, "neighbours");
    if (session_.is_double()) {
        weights_ = holding(session_, adjacency.weights, "weights of neighbours");
        return;
    }
    std::vector<float> weights;
    for (const double weight : adjacency.weights) weights.push_back(in_precision<float>(weight));
    weights_ = holding(session_, weights, "weights of neighbours");
}

template <class V>
std::vector<V> MeshState::in_order(const std::vector<V>& by_id) const {
    std::vector<V> result(by_id.size());
    std::ranges::transform(surface_->order, result.begin(), [&](std::uint32_t id) { return by_id[id]; });
    return result;
}

template <class T>
void MeshState::upload(const cl::Buffer& buffer, std::size_t plane, const std::vector<double>& by_id) {
    std::vector<T> values(by_id.size());
    std::ranges::transform(surface_->order, values.begin(),
                           [&](std::uint32_t id) { return in_precision<T>(by_id[id]); });
    const std::size_t bytes = values.size() * sizeof(T);
    session_.queue().enqueueWriteBuffer(buffer, CL_TRUE, plane * bytes, bytes, values.data());
}

void MeshState::upload(const cl::Buffer& buffer, std::size_t plane, const std::vector<double>& by_id) {
    if (session_.is_double()) return upload<double>(buffer, plane, by_id);
    upload<float>(buffer, plane, by_id);
}

template <class T>
void MeshState::download(const cl::Buffer& buffer, std::size_t plane, std::vector<double>& by_id) const {
    std::vector<T> values(cells());
    const std::size_t bytes = values.size() * sizeof(T);
    session_.queue().enqueueReadBuffer(buffer, CL_TRUE, plane * bytes, bytes, values.data());
    by_id.resize(cells());
    for (std::size_t i = 0; i < values.size(); ++i) by_id[surface_->order[i]] = static_cast<double>(values[i]);
}

void MeshState::download(const cl::Buffer& buffer, std::size_t plane, std::vector<double>& by_id) const {
    if (session_.is_double()) return download<double>(buffer, plane, by_id);
    download<float>(buffer, plane, by_id);
}

void MeshState::write(const Snapshot& snapshot) {
    kept_ = snapshot;
    for (std::size_t i = 0; i < chemicals_; ++i) {
        upload(conc_, i, snapshot.conc[i]);
        upload(rate_, i, snapshot.diff[i]);
    }
    for (std::size_t i = 0; i < snapshot.mappings.size(); ++i) upload(mapping_, i, snapshot.mappings[i]);
    neighbours_ = holding(session_, in_order(snapshot.neighbours), "neighbour counts");
    birth_ = holding(session_, in_order(snapshot.birth), "births");
    for (auto* columns : {&kept_.x, &kept_.y, &kept_.polarity_x, &kept_.polarity_y}) {
        if (session_.is_double()) break;
        for (double& value : *columns) value = double{in_precision<float>(value)};
    }
}

Snapshot MeshState::read() const {
    Snapshot snapshot = kept_;
    for (std::size_t i = 0; i < chemicals_; ++i) {
        download(conc_, i, snapshot.conc[i]);
        download(rate_, i, snapshot.diff[i]);
    }
    for (std::size_t i = 0; i < snapshot.mappings.size(); ++i) download(mapping_, i, snapshot.mappings[i]);
    std::vector<std::int32_t> counts(cells());
    session_.queue().enqueueReadBuffer(neighbours_, CL_TRUE, 0, counts.size() * sizeof counts[0], counts.data());
    for (std::size_t i = 0; i < counts.size(); ++i) snapshot.neighbours[surface_->order[i]] = counts[i];
    return snapshot;
}

void MeshState::fill_rate(std::size_t chemical, double rate) {
    upload(rate_, chemical, std::vector<double>(cells(), rate));
}

void MeshState::add_to(Arguments& arguments, bool writes_rates) {
    const std::size_t bytes = chemicals_ * cells() * session_.scalar_bytes();
    session_.poison_buffer(spare_conc_, bytes);
    if (writes_rates) session_.poison_buffer(spare_rate_, bytes);
    arguments.add(conc_, spare_conc_, rate_, spare_rate_, mapping_, neighbours_, birth_, ids_, places_, offsets_,
                  indices_, weights_);
}

void MeshState::swap(bool rates) {
    std::swap(conc_, spare_conc_);
    if (rates) std::swap(rate_, spare_rate_);
}

}  // namespace pelage
