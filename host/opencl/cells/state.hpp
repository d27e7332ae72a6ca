// All that free cells hold, on the device: the arrays of kernels/cells/state.cl, twice, for a step reads one set and
// writes the other.
#pragma once

#include "core/snapshot.hpp"
#include "opencl/device/launch.hpp"
#include "opencl/device/session.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pelage {

// In the order of kernel parameters.
enum class CellArray { position, conc, rate, polarity, mapping, neighbours, id, birth, fixed };
inline constexpr std::size_t cell_array_count = 9;

class CellsState {
public:
    // `divides`: number of `divide` rules.
    CellsState(const Session&, std::size_t chemicals, std::size_t mappings, std::size_t divides);

    int cells() const { return static_cast<int>(cells_); }
    int pitch() const { return static_cast<int>(pitch_); }                // from plane to plane
    int room() const { return static_cast<int>(pitch_ - extra_places); }  // most cells, until more is reserved
    int chemicals() const { return static_cast<int>(planes_[static_cast<std::size_t>(CellArray::conc)]); }
    std::size_t divide_rules() const { return divide_rules_; }
    int mappings() const { return static_cast<int>(planes_[static_cast<std::size_t>(CellArray::mapping)]); }

    void upload(const Snapshot&);  // physical order: that of ids
    Snapshot download() const;     // in order of id; mirrors are left out
    void fill_rate(std::size_t chemical, double rate);

    // Makes room for that many cells; what is there stays, in both sets. Throws Error when memory does not suffice;
    // then only a smaller reserve() or an upload() may follow.
    void reserve(std::size_t cells);
    void grow(std::size_t cells);                              // as reserve(), with room for more where memory allows
    void append(std::size_t children) { cells_ += children; }  // that a kernel has written

    const cl::Buffer& now(CellArray array) const { return now_[static_cast<std::size_t>(array)]; }
    const cl::Buffer& spare(CellArray array) const { return spare_[static_cast<std::size_t>(array)]; }
    void flip(CellArray array) {
        std::swap(now_[static_cast<std::size_t>(array)], spare_[static_cast<std::size_t>(array)]);
    }
    void flip_all() { std::swap(now_, spare_); }

    void add_now(Arguments&) const;
    void add_spare(Arguments&) const;

    // Guarded sessions: what a step must write holds NaN before it does. `changes(array)` tells which arrays it writes.
    template <class Changes>
    void poison_spare(const Changes& changes) const {
        for (std::size_t i = 0; i < cell_array_count; ++i) {
            if (changes(static_cast<CellArray>(i)))
                session_.poison_buffer(spare_[i], planes_[i] * pitch_ * element_bytes(i));
        }
    }

    const cl::Buffer& built() const { return built_; }        // positions when the lists were built
    const cl::Buffer& place_of() const { return place_of_; }  // [id], as of the latest build
    const cl::Buffer& divides() const { return divides_; }    // [id], a bit for each `divide` rule
    const cl::Buffer& degrees() const { return degrees_; }    // [nth `divide` rule][id]

private:
    static constexpr std::size_t extra_places = 32;  // vectors read and write past the last cell

    std::size_t element_bytes(std::size_t array) const;
    std::size_t bytes_per_cell() const;
    // A buffer of planes of `pitch` elements that holds what `from` does, in planes of `from_pitch`.
    cl::Buffer grown(const cl::Buffer& from, std::size_t from_pitch, std::size_t planes, std::size_t bytes,
                     std::size_t pitch, const std::string& what) const;
    void forget_torn();
    void check_memory(std::size_t cells) const;

    template <class T>
    void upload_as(const Snapshot&);
    template <class T>
    void download_as(const std::vector<std::size_t>& place, Snapshot&) const;
    template <class T>
    void put(CellArray, std::size_t plane, const std::vector<double>&);

    const Session& session_;
    std::array<std::size_t, cell_array_count> planes_;
    std::size_t divide_rules_;
    std::size_t cells_ = 0;
    std::size_t pitch_ = 0;
    std::array<cl::Buffer, cell_array_count> now_;
    std::array<cl::Buffer, cell_array_count> spare_;
    cl::Buffer built_, place_of_, divides_, degrees_;
    // Of each buffer, in the order of reserve(). They differ from pitch_ only when that could not be carried through.
    std::array<std::size_t, 2 * cell_array_count + 4> pitches_{};
};

}  // namespace pelage
