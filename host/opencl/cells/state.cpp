// See state.hpp.
#include "opencl/cells/state.hpp"

#include "core/error.hpp"
#include "core/experiment.hpp"
#include "core/subnormal.hpp"
#include "opencl/device/cl_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace pelage {

namespace {

constexpr std::array<const char*, cell_array_count> array_names{"positions",  "concentrations", "rates",
                                                                "polarities", "mappings",       "neighbour counts",
                                                                "ids",        "births",         "fixed marks"};

bool integers(std::size_t array) { return array >= static_cast<std::size_t>(CellArray::neighbours); }

// An odd multiple of 32 elements: planes of a power of two would share the same few cache sets.
std::size_t pitch_for(std::size_t places) { return ((places + 31) / 32 | 1) * 32; }

template <class V>
void write(const Session& session, const cl::Buffer& buffer, std::size_t offset, const std::vector<V>& values) {
    if (values.empty()) return;
    session.queue().enqueueWriteBuffer(buffer, CL_TRUE, offset * sizeof(V), values.size() * sizeof(V), values.data());
}

template <class V>
std::vector<V> fetch(const Session& session, const cl::Buffer& buffer, std::size_t offset, std::size_t count) {
    std::vector<V> values(count);
    session.queue().enqueueReadBuffer(buffer, CL_TRUE, offset * sizeof(V), count * sizeof(V), values.data());
    return values;
}

template <class To, class From>
std::vector<To> converted(const std::vector<From>& values) {
    std::vector<To> result(values.size());
    std::ranges::transform(values, result.begin(), [](From value) { return static_cast<To>(value); });
    return result;
}

// values[place], in order of id.
template <class To, class From>
std::vector<To> by_id(const std::vector<From>& values, const std::vector<std::size_t>& place) {
    std::vector<To> result(place.size());
    for (std::size_t id = 0; id < place.size(); ++id) result[id] = static_cast<To>(values[place[id]]);
    return result;
}

}  // namespace

CellsState::CellsState(const Session& session, std::size_t chemicals, std::size_t mappings, std::size_t divides)
    : session_(session), planes_{2, chemicals, chemicals, 2, mappings, 1, 1, 1, 1}, divide_rules_(divides) {}

std::size_t CellsState::element_bytes(std::size_t array) const {
    return integers(array) ? sizeof(cl_int) : session_.scalar_bytes();
}

std::size_t CellsState::bytes_per_cell() const {
    std::size_t bytes = (2 + divide_rules_) * session_.scalar_bytes() + 2 * sizeof(cl_int);
    for (std::size_t array = 0; array < cell_array_count; ++array) bytes += 2 * planes_[array] * element_bytes(array);
    return bytes;
}

void CellsState::check_memory(std::size_t cells) const {
    if (cells > largest_cell_count - 2 * extra_places) {
        throw Error(
            fmt::format("{} cells; no more than {} can be addressed", cells, largest_cell_count - 2 * extra_places));
    }
    const std::size_t bytes = bytes_per_cell() * cells;
    const std::size_t largest = std::max<std::size_t>(2, planes_[1]) * session_.scalar_bytes() * cells;
    const DeviceInfo& device = session_.info();
    if (bytes > device.memory || largest > device.max_allocation) {
        throw Error(fmt::format(
            "{} cells need {} MiB, {} MiB of them in one piece; device '{}' has {} MiB and allows {} MiB "
            "in one piece",
            cells, bytes >> 20, largest >> 20, device.name, device.memory >> 20, device.max_allocation >> 20));
    }
}

cl::Buffer CellsState::grown(const cl::Buffer& from, std::size_t from_pitch, std::size_t planes, std::size_t bytes,
                             std::size_t pitch, const std::string& what) const {
    cl::Buffer to = session_.buffer(planes * pitch * bytes, what);
    if (planes == 0) return to;
    session_.queue().enqueueFillBuffer(to, cl_int{0}, 0, planes * pitch * bytes);
    for (std::size_t plane = 0; from() != nullptr && plane < planes; ++plane) {
        session_.queue().enqueueCopyBuffer(from, to, plane * from_pitch * bytes, plane * pitch * bytes,
                                           std::min(from_pitch, pitch) * bytes);
    }
    return to;
}

void CellsState::reserve(std::size_t cells) {
    if (cells + extra_places <= pitch_) return;
    check_memory(cells);
    const std::size_t pitch = pitch_for(cells + extra_places);
    auto its_pitch = pitches_.begin();
    const auto regrow = [&](cl::Buffer& buffer, std::size_t planes, std::size_t bytes, const char* what) {
        buffer = grown(buffer, *its_pitch, planes, bytes, pitch, what);
        *its_pitch++ = pitch;
    };
    for (std::size_t array = 0; array < cell_array_count; ++array) {
        regrow(now_[array], planes_[array], element_bytes(array), array_names[array]);
        regrow(spare_[array], planes_[array], element_bytes(array), array_names[array]);
    }
    regrow(built_, 2, session_.scalar_bytes(), "earlier positions");
    regrow(place_of_, 1, sizeof(cl_int), "places of cells");
    regrow(divides_, 1, sizeof(cl_uint), "marks of dividing cells");
    regrow(degrees_, divide_rules_, session_.scalar_bytes(), "directions of division");
    pitch_ = pitch;
}

// Contents too: whoever calls this brings new ones.
void CellsState::forget_torn() {
    if (std::ranges::all_of(pitches_, [&](std::size_t pitch) { return pitch == pitch_; })) return;
    for (cl::Buffer& buffer : now_) buffer = cl::Buffer();
    for (cl::Buffer& buffer : spare_) buffer = cl::Buffer();
    for (cl::Buffer* buffer : {&built_, &place_of_, &divides_, &degrees_}) *buffer = cl::Buffer();
    pitches_.fill(0);
    pitch_ = 0;
}

void CellsState::grow(std::size_t cells) {
    if (cells + extra_places <= pitch_) return;
    try {
        with_device(session_.info().name, [&] { reserve(std::max(cells, cells_ + cells_ / 2)); });
    } catch (const Error&) {
        reserve(cells);
    }
}

void CellsState::upload(const Snapshot& snapshot) {
    cells_ = 0;
    forget_torn();
    reserve(snapshot.cells());
    cells_ = snapshot.cells();
    if (session_.is_double()) {
        upload_as<double>(snapshot);
    } else {
        upload_as<float>(snapshot);
    }
    std::vector<cl_int> ids(cells_);
    std::iota(ids.begin(), ids.end(), 0);
    write(session_, now(CellArray::id), 0, ids);
    write(session_, place_of_, 0, ids);
    write(session_, now(CellArray::neighbours), 0, snapshot.neighbours);
    write(session_, now(CellArray::birth), 0, snapshot.birth);
    write(session_, now(CellArray::fixed), 0, converted<cl_int>(snapshot.fixed));
}

template <class T>
void CellsState::put(CellArray array, std::size_t plane, const std::vector<double>& values) {
    std::vector<T> numbers(values.size());
    std::ranges::transform(values, numbers.begin(), in_precision<T>);
    write(session_, now(array), plane * pitch_, numbers);
}

template <class T>
void CellsState::upload_as(const Snapshot& snapshot) {
    put<T>(CellArray::position, 0, snapshot.x);
    put<T>(CellArray::position, 1, snapshot.y);
    put<T>(CellArray::polarity, 0, snapshot.polarity_x);
    put<T>(CellArray::polarity, 1, snapshot.polarity_y);
    for (std::size_t i = 0; i < snapshot.conc.size(); ++i) put<T>(CellArray::conc, i, snapshot.conc[i]);
    for (std::size_t i = 0; i < snapshot.diff.size(); ++i) put<T>(CellArray::rate, i, snapshot.diff[i]);
    for (std::size_t i = 0; i < snapshot.mappings.size(); ++i) put<T>(CellArray::mapping, i, snapshot.mappings[i]);
}

template <class T>
void CellsState::download_as(const std::vector<std::size_t>& place, Snapshot& snapshot) const {
    const auto get = [&](CellArray array, std::size_t plane) {
        return by_id<double>(fetch<T>(session_, now(array), plane * pitch_, cells_), place);
    };
    snapshot.x = get(CellArray::position, 0);
    snapshot.y = get(CellArray::position, 1);
    snapshot.polarity_x = get(CellArray::polarity, 0);
    snapshot.polarity_y = get(CellArray::polarity, 1);
    for (std::size_t i = 0; i < planes_[1]; ++i) snapshot.conc.push_back(get(CellArray::conc, i));
    for (std::size_t i = 0; i < planes_[2]; ++i) snapshot.diff.push_back(get(CellArray::rate, i));
    for (std::size_t i = 0; i < planes_[4]; ++i) snapshot.mappings.push_back(get(CellArray::mapping, i));
}

Snapshot CellsState::download() const {
    const std::vector<cl_int> ids = fetch<cl_int>(session_, now(CellArray::id), 0, cells_);
    std::vector<std::size_t> place(cells_, cells_);
    for (std::size_t i = 0; i < cells_; ++i) {
        const auto id = static_cast<std::size_t>(ids[i]);
        if (id >= cells_ || place[id] != cells_) {
            throw Error(fmt::format("device '{}' holds cell {} twice or never had it", session_.info().name, ids[i]));
        }
        place[id] = i;
    }
    Snapshot snapshot;
    if (session_.is_double()) {
        download_as<double>(place, snapshot);
    } else {
        download_as<float>(place, snapshot);
    }
    const auto get = [&](CellArray array) { return fetch<cl_int>(session_, now(array), 0, cells_); };
    snapshot.neighbours = by_id<std::int32_t>(get(CellArray::neighbours), place);
    snapshot.birth = by_id<std::uint32_t>(get(CellArray::birth), place);
    snapshot.fixed = by_id<std::uint8_t>(get(CellArray::fixed), place);
    return snapshot;
}

void CellsState::fill_rate(std::size_t chemical, double rate) {
    const cl::Buffer& rates = now(CellArray::rate);
    const std::size_t bytes = session_.scalar_bytes();
    const std::size_t offset = chemical * pitch_ * bytes;
    if (session_.is_double()) {
        session_.queue().enqueueFillBuffer(rates, static_cast<cl_double>(rate), offset, pitch_ * bytes);
    } else {
        session_.queue().enqueueFillBuffer(rates, in_precision<cl_float>(rate), offset, pitch_ * bytes);
    }
}

void CellsState::add_now(Arguments& arguments) const {
    for (const cl::Buffer& buffer : now_) arguments.add(buffer);
}

void CellsState::add_spare(Arguments& arguments) const {
    for (const cl::Buffer& buffer : spare_) arguments.add(buffer);
}

}  // namespace pelage
