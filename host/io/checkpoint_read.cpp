// See checkpoint.hpp and checkpoint_format.hpp.
#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/experiment.hpp"
#include "io/checkpoint.hpp"
#include "io/checkpoint_format.hpp"
#include "io/checksum.hpp"
#include "io/file_bytes.hpp"

#include <fmt/format.h>
#include <cstring>
#include <utility>
#include <vector>

namespace pelage {
namespace {

namespace format = checkpoint_format;

class CheckpointReader {
public:
    CheckpointReader(std::string_view payload, const std::string& name) : rest_(payload), name_(name) {}

    template <class T>
    void number(T& value) {
        value = load<T>(bytes(1, sizeof(T)));
    }
    void text(std::string& value) {
        const auto length = count();
        value.assign(bytes(length, 1), length);
    }
    void rows(Snapshot& state) {
        std::uint64_t both = 0;
        number(both);
        state.layers = both >> format::layers_shift;
        state.rows = both - (std::uint64_t{state.layers} << format::layers_shift);
    }
    void precision(Precision& value) {
        std::uint8_t size = 0;
        number(size);
        if (size != 4 && size != 8) fail();
        value = size == 8 ? Precision::double_ : Precision::single_;
    }

    template <class T>
    void column(std::string_view name, std::vector<T>& values) {
        if (name == "order" && rest_.empty()) return;
        const auto length = count();
        std::uint8_t repeated = 0;
        number(repeated);
        if (length > largest_cell_count || repeated > 1) fail();
        if (repeated != 0) {
            if (length > 2 * cells_) fail();  // mirrors have two elements a pair
            values.assign(length, load<T>(bytes(1, sizeof(T))));
            return;
        }
        const char* const from = bytes(length, sizeof(T));
        values.resize(length);
        if (length != 0) std::memcpy(values.data(), from, length * sizeof(T));
        if (format::place(name)) cells_ = values.size();
    }
    void column(std::string_view name, ColumnList& list) {
        const auto columns = count();
        if (columns > rest_.size()) fail();
        list.resize(columns);
        for (auto& one : list) column(name, one);
    }
    void column(std::string_view name, PairColumn& pairs) {
        std::vector<std::uint32_t> flat;
        column(name, flat);
        if (flat.size() % 2 != 0) fail();
        pairs.clear();
        for (std::size_t i = 0; i < flat.size(); i += 2) pairs.emplace_back(flat[i], flat[i + 1]);
    }
    void finish() const {
        if (!rest_.empty()) fail();
    }

private:
    std::uint64_t count() {
        std::uint64_t value = 0;
        number(value);
        return value;
    }
    const char* bytes(std::uint64_t length, std::size_t size) {
        if (length > rest_.size() / size) fail();
        const char* const from = rest_.data();
        rest_.remove_prefix(length * size);
        return from;
    }
    [[noreturn]] void fail() const {
        throw Error(fmt::format("'{}' is a corrupted checkpoint: its parts do not fit together", name_));
    }

    std::string_view rest_;
    const std::string& name_;
    std::size_t cells_ = 0;
};

// The payload of a file that is a whole checkpoint of ours.
std::string_view checked_payload(std::string_view bytes, const std::string& name) {
    if (bytes.empty() || bytes.substr(0, format::magic.size()) != format::magic.substr(0, bytes.size())) {
        throw Error(fmt::format("'{}' is not a checkpoint", name));
    }
    if (bytes.size() < format::payload_place + format::checksum_size) {
        throw Error(fmt::format("'{}' is a truncated checkpoint: it has only {}", name, counted(bytes.size(), "byte")));
    }
    const auto version = load<std::uint32_t>(bytes.data() + format::magic.size());
    if (version == 0 || version > format::version) {
        throw Error(fmt::format("'{}' is a checkpoint of format {}; this program knows formats 1 to {}", name, version,
                                format::version));
    }
    const auto size = load<std::uint64_t>(bytes.data() + format::size_place);
    if (size != bytes.size()) {
        throw Error(fmt::format("'{}' is a {} checkpoint: it has {} and should have {}", name,
                                bytes.size() < size ? "truncated" : "corrupted", counted(bytes.size(), "byte"), size));
    }
    const auto payload =
        bytes.substr(format::payload_place, bytes.size() - format::payload_place - format::checksum_size);
    Checksum sum;
    sum.add(payload.data(), payload.size());
    if (sum.value() != load<std::uint64_t>(payload.data() + payload.size())) {
        throw Error(fmt::format("'{}' is a corrupted checkpoint: its checksum is wrong", name));
    }
    return payload;
}

}  // namespace

Checkpoint parse_checkpoint(std::string_view bytes, const std::string& name) {
    CheckpointReader reader(checked_payload(bytes, name), name);
    Checkpoint checkpoint;
    format::visit(reader, checkpoint);
    reader.finish();
    return checkpoint;
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
    return parse_checkpoint(read_file(path), path.string());
}

}  // namespace pelage
