// The state of a mesh's cells on a device: planes of one value a cell, in the surface's own order; amounts of chemicals
// in pairs, see kernels/mesh/pairs.cl.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "core/surface.hpp"
#include "opencl/device/launch.hpp"
#include "opencl/device/session.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace pelage {

class MeshState {
public:
    MeshState(const Session&, const Experiment&, std::shared_ptr<const MeshSurface>);

    std::size_t cells() const { return surface_->cells(); }
    std::size_t pitch() const { return pitch_; }  // cells, and what fills the last block of lists

    void write(const Snapshot&);
    Snapshot read() const;
    void fill_rate(std::size_t chemical, double rate);

    // The arrays of kernels/mesh/step.cl, from the first to the weights.
    void add_to(Arguments&, bool writes_rates);
    // What has been written is the state; each cell now knows how many neighbours it has.
    void swap(bool rates);

private:
    template <class V>
    std::vector<V> filled(std::vector<V>) const;  // up to the pitch, with 0
    template <class V>
    std::vector<V> in_order(const std::vector<V>& by_id) const;
    // Columns by id, the values of a cell side by side, from that plane on.
    using Columns = std::span<const std::vector<double>>;
    using WritableColumns = std::span<std::vector<double>>;
    template <class T>
    void upload(const cl::Buffer&, std::size_t plane, Columns);
    void upload(const cl::Buffer&, std::size_t plane, Columns);
    template <class T>
    void download(const cl::Buffer&, std::size_t plane, WritableColumns) const;
    void download(const cl::Buffer&, std::size_t plane, WritableColumns) const;
    cl::Buffer planes(std::size_t count, const char* what) const;
    void upload_places(const Experiment&);  // coordinates, then fields of blobs
    void upload_lists();

    const Session& session_;
    std::shared_ptr<const MeshSurface> surface_;
    std::size_t pitch_;
    std::size_t chemicals_;
    Snapshot kept_;  // what no kernel changes
    cl::Buffer conc_, spare_conc_, rate_, spare_rate_, mapping_, neighbours_, birth_, ids_, places_;
    cl::Buffer rows_, lengths_, indices_, weights_;
};

}  // namespace pelage
