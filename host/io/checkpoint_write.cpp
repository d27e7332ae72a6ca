// See checkpoint.hpp and checkpoint_format.hpp.
#include "io/atomic_file.hpp"
#include "io/checkpoint.hpp"
#include "io/checkpoint_format.hpp"
#include "io/checksum.hpp"

#include <cstring>
#include <string_view>
#include <vector>

namespace pelage {
namespace {

template <class T>
bool same_bits(const std::vector<T>& values) {
    return values.size() > 1 && std::memcmp(values.data(), values.data() + 1, (values.size() - 1) * sizeof(T)) == 0;
}

namespace format = checkpoint_format;

class CheckpointWriter {
public:
    explicit CheckpointWriter(AtomicFile& file) : file_(file) {}

    template <class T>
    void number(const T& value) {
        bytes(&value, sizeof value);
    }
    void text(const std::string& value) {
        number(std::uint64_t{value.size()});
        bytes(value.data(), value.size());
    }
    void rows(const Snapshot& state) {
        number(std::uint64_t{state.rows} | std::uint64_t{state.layers} << format::layers_shift);
    }
    void precision(Precision value) { number(static_cast<std::uint8_t>(value == Precision::double_ ? 8 : 4)); }

    template <class T>
    void column(std::string_view name, const std::vector<T>& values) {
        if (name == "order" && values.empty()) return;
        array(values, !checkpoint_format::place(name) && same_bits(values));
    }
    void column(std::string_view name, const ColumnList& list) {
        number(std::uint64_t{list.size()});
        for (const auto& one : list) column(name, one);
    }
    void column(std::string_view name, const PairColumn& pairs) {
        std::vector<std::uint32_t> flat;
        for (const auto& [first, second] : pairs) flat.insert(flat.end(), {first, second});
        column(name, flat);
    }

    std::uint64_t checksum() const { return sum_.value(); }

private:
    template <class T>
    void array(const std::vector<T>& values, bool repeated) {
        number(std::uint64_t{values.size()});
        number(static_cast<std::uint8_t>(repeated));
        bytes(values.data(), (repeated ? 1 : values.size()) * sizeof(T));
    }

    void bytes(const void* from, std::size_t count) {
        file_.write(from, count);
        sum_.add(from, count);
    }

    AtomicFile& file_;
    Checksum sum_;
};

struct StateView {
    const Snapshot& snapshot;
    const CheckpointInfo& info;
};

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const Snapshot& snapshot, const CheckpointInfo& info) {
    static_assert(sizeof(std::size_t) == 8);
    AtomicFile file(path);
    file.write(format::magic);
    const std::uint32_t version = snapshot.order.empty() ? 1 : format::version;
    file.write(&version, sizeof version);
    std::uint64_t size = 0;
    file.write(&size, sizeof size);
    CheckpointWriter writer(file);
    const StateView view{snapshot, info};
    format::visit(writer, view);
    const auto checksum = writer.checksum();
    file.write(&checksum, sizeof checksum);
    size = file.position();
    file.seek(format::size_place);
    file.write(&size, sizeof size);
    file.sync();
    file.commit();
}

}  // namespace pelage
