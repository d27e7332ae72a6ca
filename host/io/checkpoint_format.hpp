// How a checkpoint lies on the disk; see checkpoint.hpp. All numbers are little-endian.
//   8 bytes   magic
//   uint32    format version
//   uint64    size of the whole file in bytes
//   payload   experiment, source, folder, backend, device, version (texts: uint64 length, bytes); precision (uint8: 4
//   or 8),
//             seed (int64); iteration, columns, rows (uint64; a volume's layers in its upper half), origin_x, origin_y
//             (double); x, y (arrays); conc, diff, mappings (uint64 number, then arrays); polarity_x, polarity_y
//             (arrays of double), birth (uint32), neighbours (int32), fixed (uint8), mirrors (uint32, two a pair);
//             in format 2, that of states with one, the order of spatial sorting (uint32). An array: uint64 count,
//             uint8 1 when all elements have the same bits and only one follows, else 0; x and y are always written
//             out: their length bounds what a short file can ask for.
//   uint64    Checksum of the payload
#pragma once

#include "core/columns.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pelage::checkpoint_format {

inline constexpr std::string_view magic = "PELAGE\r\n";  // spoilt by transfers that mend line ends
inline constexpr std::uint32_t version = 2;              // 1 where the state has no order
inline constexpr unsigned layers_shift = 32;
inline constexpr std::size_t size_place = 12;
inline constexpr std::size_t payload_place = 20;
inline constexpr std::size_t checksum_size = 8;

// Their length bounds what a short file can ask for.
inline bool place(std::string_view column) { return column == "x" || column == "y"; }

// Visits all parts of a checkpoint in the order of the file: with a writer and a constant one, or a reader.
template <class Visitor, class Checkpoint>
void visit(Visitor& part, Checkpoint& checkpoint) {
    auto& info = checkpoint.info;
    for (auto* text : {&info.experiment, &info.source, &info.folder, &info.backend, &info.device, &info.version})
        part.text(*text);
    part.precision(info.precision);
    part.number(info.seed);

    auto& state = checkpoint.snapshot;
    part.number(state.iteration);
    part.number(state.columns);
    part.rows(state);
    part.number(state.origin_x);
    part.number(state.origin_y);
    each_column([&](std::string_view name, auto& column) { part.column(name, column); }, state);
}

}  // namespace pelage::checkpoint_format
