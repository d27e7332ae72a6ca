// See planes.hpp.
#include "opencl/lattice/planes.hpp"

#include "core/subnormal.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/device/program.hpp"

#include <algorithm>
#include <type_traits>

namespace pelage {

namespace {

std::size_t cell_place(const Grid& grid, std::size_t plane, std::size_t row) {
    return 16 + plane * grid.plane() + (row + 1) * grid.pitch();
}

}  // namespace

void launch_over_rows(const Session& session, const cl::Kernel& kernel, const Grid& grid) {
    const bool strips = session.info().processor();
    const std::size_t width = strips ? 1 : std::clamp<std::size_t>(session.info().max_work_group, 1, 64);
    const std::size_t across = strips ? 1 : (grid.pitch() + width - 1) / width * width;
    const std::size_t up =
        strips ? std::min<std::size_t>(grid.rows + 1, 4 * session.info().compute_units) : grid.rows + 1;
    session.launch(kernel, cl::NDRange(across, up), cl::NDRange(width, 1));
}

Planes::Planes(const Session& session, std::string what, std::size_t planes, bool integers)
    : session_(session), what_(std::move(what)), planes_(planes), integers_(integers) {
    reserve(64);  // never without a buffer: kernels take all of them
}

cl::Buffer Planes::zeroed() const {
    cl::Buffer buffer = session_.buffer(capacity_ * element_bytes(), what_);
    clear(buffer);
    return buffer;
}

void Planes::clear(const cl::Buffer& buffer) const {
    session_.queue().enqueueFillBuffer(buffer, cl_uint{0}, 0, capacity_ * element_bytes());
}

void Planes::reserve(std::size_t elements) {
    if (elements <= capacity_) return;
    const std::size_t generous = capacity_ == 0 ? elements : std::max(elements, capacity_ + capacity_ / 2);
    capacity_ = std::max(elements, std::min(generous, session_.info().max_allocation / element_bytes()));
    now_ = cl::Buffer();
    next_ = cl::Buffer();
    now_ = roomy(elements);
}

// With room to grow into only where there is memory for it.
cl::Buffer Planes::roomy(std::size_t needed) {
    try {
        return with_device(session_.info().name, [&] { return zeroed(); });
    } catch (const Error&) {
        if (capacity_ <= needed) throw;
        capacity_ = needed;  // now_ may be larger
        return zeroed();
    }
}

void Planes::add_to(Arguments& arguments, bool written) { arguments.add(now(), written ? next() : now()); }

const cl::Buffer& Planes::next() {
    if (next_() == nullptr) {
        next_ = roomy(elements(grid_));
    } else if (next_stale_) {
        clear(next_);
    }
    next_stale_ = false;
    if (session_.guarded()) poison_cells(next_);
    return next_;
}

void Planes::poison_cells(const cl::Buffer& buffer) const {
    const std::size_t words = element_bytes() / sizeof poison;
    std::vector<cl_uint> image(words * elements(grid_));
    session_.queue().enqueueReadBuffer(buffer, CL_TRUE, 0, image.size() * sizeof poison, image.data());
    for (std::size_t plane = 0; plane < planes_; ++plane) {
        for (std::size_t row = 0; row < grid_.rows; ++row) {
            std::fill_n(image.begin() + static_cast<std::ptrdiff_t>(words * cell_place(grid_, plane, row)),
                        words * grid_.columns, poison);
        }
    }
    session_.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, image.size() * sizeof poison, image.data());
}

void Planes::poison_planes(const cl::Buffer& buffer) const {
    if (!session_.guarded()) return;
    session_.queue().enqueueFillBuffer(buffer, poison, 16 * element_bytes(), planes_ * grid_.plane() * element_bytes());
}

void Planes::resize(const Grid& grid) {
    reserve(elements(grid));
    grid_ = grid;
    next_stale_ = true;
}

void Planes::regrow(const Grid& after, const std::function<void(const cl::Buffer&, const cl::Buffer&)>& move) {
    grid_ = after;
    if (elements(after) > capacity_) {
        const cl::Buffer old = now_;
        reserve(elements(after));
        poison_planes(now_);
        move(old, now_);
    } else {
        if (next_() == nullptr) next_ = roomy(elements(after));
        poison_planes(next_);
        move(now_, next_);
        swap();
        next_stale_ = true;
    }
}

namespace {

template <class Element, class V>
Element element_of(V value) {
    if constexpr (std::is_floating_point_v<Element>) return in_precision<Element>(static_cast<double>(value));
    return static_cast<Element>(value);
}

template <class V, class Element>
std::vector<Element> padded(const Grid& grid, const std::vector<std::vector<V>>& values) {
    std::vector<Element> elements(16 + values.size() * grid.plane(), Element{0});
    for (std::size_t plane = 0; plane < values.size(); ++plane) {
        for (std::size_t row = 0; row < grid.rows; ++row) {
            const V* from = values[plane].data() + row * grid.columns;
            std::transform(from, from + grid.columns, elements.data() + cell_place(grid, plane, row),
                           element_of<Element, V>);
        }
    }
    return elements;
}

template <class V, class Element>
std::vector<std::vector<V>> stripped(const Grid& grid, std::size_t planes, const std::vector<Element>& elements) {
    std::vector<std::vector<V>> values(planes, std::vector<V>(grid.cells()));
    for (std::size_t plane = 0; plane < planes; ++plane) {
        for (std::size_t row = 0; row < grid.rows; ++row) {
            const Element* from = elements.data() + cell_place(grid, plane, row);
            std::transform(from, from + grid.columns, values[plane].data() + row * grid.columns,
                           [](Element element) { return static_cast<V>(element); });
        }
    }
    return values;
}

template <class V, class Element>
void write_elements(const Session& session, const cl::Buffer& buffer, const Grid& grid,
                    const std::vector<std::vector<V>>& values, std::size_t first) {
    const std::vector<Element> elements = padded<V, Element>(grid, values);  // 16 zeros before: so they are there
    session.queue().enqueueWriteBuffer(buffer, CL_TRUE, first * grid.plane() * sizeof(Element),
                                       elements.size() * sizeof(Element), elements.data());
}

template <class V, class Element>
std::vector<std::vector<V>> read_elements(const Session& session, const cl::Buffer& buffer, const Grid& grid,
                                          std::size_t first, std::size_t planes) {
    std::vector<Element> elements(16 + planes * grid.plane());
    session.queue().enqueueReadBuffer(buffer, CL_TRUE, first * grid.plane() * sizeof(Element),
                                      elements.size() * sizeof(Element), elements.data());
    return stripped<V, Element>(grid, planes, elements);
}

}  // namespace

template <class V>
void Planes::upload(const Grid& grid, const std::vector<std::vector<V>>& values, std::size_t first) {
    resize(grid);
    if (values.empty()) return;
    if (integers_) {
        write_elements<V, std::int32_t>(session_, now_, grid, values, first);
    } else if (session_.is_double()) {
        write_elements<V, double>(session_, now_, grid, values, first);
    } else {
        write_elements<V, float>(session_, now_, grid, values, first);
    }
}

template <class V>
std::vector<std::vector<V>> Planes::download(const Grid& grid, std::size_t first, std::size_t count) const {
    if (count == 0) return {};
    if (integers_) return read_elements<V, std::int32_t>(session_, now_, grid, first, count);
    if (session_.is_double()) return read_elements<V, double>(session_, now_, grid, first, count);
    return read_elements<V, float>(session_, now_, grid, first, count);
}

namespace {

// Moves the cells out of rows that are `pitch` apart, to the front of the same array or to another one.
template <class Element>
void take_cells(const Grid& grid, const Element* from, float* to) {
    for (std::size_t row = 0; row < grid.rows; ++row) {
        const Element* cells = from + row * grid.pitch();
        if constexpr (std::is_same_v<Element, float>) {
            std::copy(cells, cells + grid.columns, to + row * grid.columns);  // the same place or one before
        } else {
            std::transform(cells, cells + grid.columns, to + row * grid.columns,
                           [](Element value) { return static_cast<float>(value); });
        }
    }
}

}  // namespace

void Planes::download(const Grid& grid, std::size_t plane, std::vector<float>& to) const {
    const std::size_t begin = cell_place(grid, plane, 0) * element_bytes();
    const std::size_t count = (grid.rows - 1) * grid.pitch() + grid.columns;
    if (session_.is_double()) {
        std::vector<double> values(count);
        session_.queue().enqueueReadBuffer(now_, CL_TRUE, begin, count * sizeof values[0], values.data());
        to.resize(grid.cells());
        return take_cells(grid, values.data(), to.data());
    }
    if (session_.info().processor()) {  // row by row is no slower there, and spares a copy
        to.resize(grid.cells());
        const std::size_t pitch = grid.pitch() * sizeof to[0], row = grid.columns * sizeof to[0];
        session_.queue().enqueueReadBufferRect(now_, CL_TRUE, {begin % pitch, begin / pitch, 0}, {0, 0, 0},
                                               {row, grid.rows, 1}, pitch, 0, row, 0, to.data());
        return;
    }
    to.resize(count);
    session_.queue().enqueueReadBuffer(now_, CL_TRUE, begin, count * sizeof to[0], to.data());
    take_cells(grid, to.data(), to.data());
    to.resize(grid.cells());
}

void Planes::fill(const Grid& grid, std::size_t plane, double value) {
    upload(grid, std::vector<std::vector<double>>{std::vector<double>(grid.cells(), value)}, plane);
}

template void Planes::upload(const Grid&, const std::vector<std::vector<double>>&, std::size_t);
template void Planes::upload(const Grid&, const std::vector<std::vector<std::int32_t>>&, std::size_t);
template void Planes::upload(const Grid&, const std::vector<std::vector<std::uint32_t>>&, std::size_t);
template std::vector<std::vector<double>> Planes::download(const Grid&, std::size_t, std::size_t) const;
template std::vector<std::vector<std::int32_t>> Planes::download(const Grid&, std::size_t, std::size_t) const;
template std::vector<std::vector<std::uint32_t>> Planes::download(const Grid&, std::size_t, std::size_t) const;

}  // namespace pelage
