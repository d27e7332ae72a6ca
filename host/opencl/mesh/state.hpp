// The state of a mesh's cells on a device: planes of one value a cell, in the surface's own order.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "core/surface.hpp"
#include "opencl/device/launch.hpp"
#include "opencl/device/session.hpp"

#include <cstddef>
#include <memory>

namespace pelage {

class MeshState {
public:
    MeshState(const Session&, std::shared_ptr<const MeshSurface>, std::size_t chemicals, std::size_t mappings);

    std::size_t cells() const { return surface_->cells(); }

    void write(const Snapshot&);
    Snapshot read() const;
    void fill_rate(std::size_t chemical, double rate);

    // The arrays of kernels/mesh/step.cl, from the first to the weights.
    void add_to(Arguments&, bool writes_rates);
    void swap(bool rates);  // what has been written is the state

private:
    template <class V>
    std::vector<V> in_order(const std::vector<V>& by_id) const;
    template <class T>
    void upload(const cl::Buffer&, std::size_t plane, const std::vector<double>& by_id);
    void upload(const cl::Buffer&, std::size_t plane, const std::vector<double>& by_id);
    template <class T>
    void download(const cl::Buffer&, std::size_t plane, std::vector<double>& by_id) const;
    void download(const cl::Buffer&, std::size_t plane, std::vector<double>& by_id) const;
    cl::Buffer planes(std::size_t count, const char* what) const;
    void upload_adjacency();

    const Session& session_;
    std::shared_ptr<const MeshSurface> surface_;
    std::size_t chemicals_;
    Snapshot kept_;  // what no kernel changes
    cl::Buffer conc_, spare_conc_, rate_, spare_rate_, mapping_, neighbours_, birth_, ids_, places_;
    cl::Buffer offsets_, indices_, weights_;
};

}  // namespace pelage
