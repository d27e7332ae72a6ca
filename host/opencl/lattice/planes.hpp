// Values of a lattice's cells on the device: planes as kernels/lattice/rows.cl describes them.
#pragma once

#include "core/growth.hpp"
#include "opencl/device/launch.hpp"
#include "opencl/device/session.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pelage {

struct Grid {
    std::size_t columns = 0;
    std::size_t rows = 0;

    std::size_t cells() const { return columns * rows; }
    std::size_t pitch() const { return (columns + 15) / 16 * 16 + 16; }  // elements from row to row
    std::size_t plane() const { return pitch() * (rows + 1); }           // elements from plane to plane
    Grid grown(bool by_column) const { return {columns + (by_column ? 1 : 0), rows + (by_column ? 0 : 1)}; }
    bool operator==(const Grid&) const = default;
};

// One work-item a column and a row of `grid`, its pitch and the row of zeros below it included; on a CPU fewer, which
// go through several.
void launch_over_rows(const Session&, const cl::Kernel&, const Grid&);

// `planes` planes of one element type, with a second set to write the next state to, made when first needed.
class Planes {
public:
    Planes(const Session&, std::string what, std::size_t planes, bool integers);

    std::size_t planes() const { return planes_; }
    const cl::Buffer& now() const { return now_; }
    const cl::Buffer& next();  // with zeros where a plane has no cells
    void swap() { std::swap(now_, next_); }
    // now() and, where the kernel writes the next state, next(); else now() twice.
    void add_to(Arguments&, bool written);

    bool integers() const { return integers_; }

    void resize(const Grid&);  // contents are lost
    // Makes planes of another size out of the present ones: move(from, to) fills the second buffer from the first.
    void regrow(const Grid& after, const std::function<void(const cl::Buffer&, const cl::Buffer&)>& move);

    // values[plane][cell], of planes from `first` on; double for scalars whatever the precision.
    template <class V>
    void upload(const Grid&, const std::vector<std::vector<V>>& values, std::size_t first = 0);
    template <class V>
    std::vector<std::vector<V>> download(const Grid& grid) const {
        return download<V>(grid, 0, planes_);
    }
    template <class V>
    std::vector<std::vector<V>> download(const Grid&, std::size_t first, std::size_t count) const;
    void download(const Grid&, std::size_t plane, std::vector<float>& to) const;  // one of them, of scalars
    void fill(const Grid&, std::size_t plane, double value);                      // every cell of it

private:
    std::size_t element_bytes() const { return integers_ ? 4 : session_.scalar_bytes(); }
    std::size_t elements(const Grid& grid) const { return 16 + planes_ * grid.plane() + 32; }
    void reserve(std::size_t elements);
    cl::Buffer zeroed() const;
    cl::Buffer roomy(std::size_t needed);
    void clear(const cl::Buffer&) const;
    void poison_cells(const cl::Buffer&) const;   // what lies between them stays
    void poison_planes(const cl::Buffer&) const;  // what lies before and behind them stays

    const Session& session_;
    std::string what_;
    std::size_t planes_;
    bool integers_;
    Grid grid_;
    std::size_t capacity_ = 0;  // elements that both sets have room for
    bool next_stale_ = false;   // next_ is laid out for another grid
    cl::Buffer now_;
    cl::Buffer next_;
};

}  // namespace pelage
