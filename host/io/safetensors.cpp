// See safetensors.hpp.
#include "io/safetensors.hpp"

#include "core/error.hpp"
#include "io/file_bytes.hpp"
#include "io/number_type.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <set>
#include <utility>

namespace pelage {

namespace {

using Json = nlohmann::json;

constexpr std::size_t length_size = 8;
constexpr std::size_t largest_header = 1u << 20;

class TensorReader {
public:
    TensorReader(std::string_view bytes, const std::string& name) : name_(name) {
        if (bytes.size() < length_size) fail("it is truncated");
        const auto length = load<std::uint64_t>(bytes.data());
        if (length > largest_header)
            fail(fmt::format("its header has {} bytes; at most {} are allowed", length, largest_header));
        if (length > bytes.size() - length_size) fail("it is truncated: its header is not whole");
        const std::string_view text = bytes.substr(length_size, static_cast<std::size_t>(length));
        std::set<std::string> keys;
        std::string repeated;
        const auto look = [&](int depth, Json::parse_event_t event, const Json& parsed) {
            if (depth != 1 || event != Json::parse_event_t::key) return true;
            const auto key = parsed.get<std::string>();
            if (!keys.insert(key).second) repeated = key;
            return true;
        };
        header_ = Json::parse(text.begin(), text.end(), look, false);
        if (!header_.is_object()) fail("its header is no JSON object");
        if (!repeated.empty()) fail(fmt::format("'{}' stands in its header twice", repeated));
        data_ = bytes.substr(length_size + text.size());
    }

    std::map<std::string, NpyArray> read() const {
        std::map<std::string, NpyArray> arrays;
        for (const auto& [key, entry] : header_.items()) {
            if (key != "__metadata__") arrays.emplace(key, array(key, entry));
        }
        check_places();
        return arrays;
    }

private:
    // The format wants arrays one after another, from the first byte to the last.
    void check_places() const {
        std::map<std::size_t, std::pair<std::size_t, std::string>> places;  // by begin: end and name
        for (const auto& [key, entry] : header_.items()) {
            if (key == "__metadata__") continue;
            const std::vector<std::size_t> range = numbers(key, entry["data_offsets"]);
            if (range[0] == range[1]) continue;
            const auto [other, is_new] = places.emplace(range[0], std::pair(range[1], key));
            if (!is_new) fail(fmt::format("'{}' and '{}' lie in the same place", other->second.second, key));
        }
        std::size_t end = 0;
        for (const auto& [begin, one] : places) {
            if (begin != end)
                fail(fmt::format("'{}' begins at byte {} of the numbers, those before it end at {}", one.second, begin,
                                 end));
            end = one.first;
        }
        if (end != data_.size()) fail(fmt::format("of {} bytes of numbers its arrays take {}", data_.size(), end));
    }

    NpyArray array(const std::string& key, const Json& entry) const {
        const bool whole = entry.is_object() && entry.contains("dtype") && entry["dtype"].is_string() &&
                           entry.contains("shape") && entry.contains("data_offsets");
        if (!whole) fail(fmt::format("'{}' has not the entries 'dtype', 'shape' and 'data_offsets'", key));
        const std::string type = entry["dtype"].get<std::string>();
        const NumberType number = type_of(type);
        if (number.size == 0)
            fail(fmt::format("'{}' holds numbers of type '{}'; allowed are BF16, F16, F32 and F64", key, type));
        NpyArray made{numbers(key, entry["shape"]), {}};
        const std::vector<std::size_t> range = numbers(key, entry["data_offsets"]);
        if (range.size() != 2 || range[0] > range[1] || range[1] > data_.size())
            fail(fmt::format("'{}' lies outside of the file", key));
        const std::string_view bytes = data_.substr(range[0], range[1] - range[0]);
        std::size_t count = bytes.size() / number.size;
        if (!fills(made.shape, count) || bytes.size() % number.size != 0)
            fail(fmt::format("'{}' has {} bytes of numbers, which do not fill its shape", key, bytes.size()));
        made.values.reserve(count);
        for (const char* at = bytes.data(); count > 0; --count, at += number.size)
            made.values.push_back(number.load(at));
        return made;
    }

    static NumberType type_of(const std::string& type) {
        if (type == "BF16") return bfloat_type();
        if (type == "F16") return half_type();
        if (type == "F32") return number_type<float>();
        return type == "F64" ? number_type<double>() : NumberType{};
    }

    static bool fills(const std::vector<std::size_t>& shape, std::size_t count) {
        for (const std::size_t length : shape) {
            if (length == 0) return count == 0;
            if (count % length != 0) return false;
            count /= length;
        }
        return count == 1;
    }

    std::vector<std::size_t> numbers(const std::string& key, const Json& list) const {
        std::vector<std::size_t> values;
        bool whole = list.is_array();
        for (std::size_t i = 0; whole && i < list.size(); ++i) {
            whole = list[i].is_number_unsigned();
            if (whole) values.push_back(list[i].get<std::size_t>());
        }
        if (!whole) fail(fmt::format("'{}' has a shape or a place that is no list of whole numbers", key));
        return values;
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw Error(fmt::format("'{}' cannot be read as a safetensors file: {}", name_, what));
    }

    const std::string& name_;
    Json header_;
    std::string_view data_;
};

}  // namespace

bool looks_like_safetensors(std::string_view bytes) { return bytes.size() > length_size && bytes[length_size] == '{'; }

std::map<std::string, NpyArray> parse_safetensors(std::string_view bytes, const std::string& name) {
    return TensorReader(bytes, name).read();
}

}  // namespace pelage
