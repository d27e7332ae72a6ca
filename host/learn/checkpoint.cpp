// See checkpoint.hpp. The file: a magic, the length of a JSON text and that text, arrays of numbers as memory holds
// them, and a checksum of all before it.
#include "learn/checkpoint.hpp"

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/checksum.hpp"
#include "io/file_bytes.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <sstream>

namespace pelage::learn {

namespace {

using nlohmann::json;

constexpr std::string_view magic{"PELAGE-LEARN-1\n\0", 16};

class Writer {
public:
    explicit Writer(const std::filesystem::path& path) : file_(path) {}

    void bytes(const void* from, std::size_t count) {
        file_.write(from, count);
        sum_.add(from, count);
    }
    template <class T>
    void array(const std::vector<T>& values) {
        bytes(values.data(), values.size() * sizeof(T));
    }
    void finish() {
        const std::uint64_t sum = sum_.value();
        file_.write(&sum, sizeof sum);
        file_.sync();
        file_.commit();
    }

private:
    AtomicFile file_;
    Checksum sum_;
};

class Reader {
public:
    Reader(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {
        if (!bytes.starts_with(magic)) throw Error(fmt::format("'{}' is no checkpoint of a training", name_));
        if (bytes.size() < magic.size() + 2 * sizeof(std::uint64_t)) fail();
        Checksum sum;
        sum.add(bytes.data(), bytes.size() - sizeof(std::uint64_t));
        if (sum.value() != load<std::uint64_t>(bytes.data() + bytes.size() - sizeof(std::uint64_t))) fail();
        bytes_ = bytes.substr(magic.size(), bytes.size() - magic.size() - sizeof(std::uint64_t));
    }

    std::string_view take(std::size_t count) {
        if (count > bytes_.size()) fail();
        const std::string_view piece = bytes_.substr(0, count);
        bytes_.remove_prefix(count);
        return piece;
    }
    template <class T>
    std::vector<T> array(std::size_t count) {
        if (count > bytes_.size() / sizeof(T)) fail();
        std::vector<T> values(count);
        std::memcpy(values.data(), take(count * sizeof(T)).data(), count * sizeof(T));
        return values;
    }
    void end() const {
        if (!bytes_.empty()) fail();
    }
    [[noreturn]] void fail() const { throw Error(fmt::format("'{}' is damaged: it is not as it was written", name_)); }

private:
    std::string_view bytes_;
    std::string name_;
};

json header_of(const Identity& identity, const CourseState& course, const PoolStates& pool) {
    json places = json::array();
    for (const auto& [place, state] : pool) places.push_back(place);
    return {{"identity", identity.settings},
            {"picture", identity.picture},
            {"backend", identity.backend},
            {"steps", course.steps},
            {"count", course.count},
            {"slowed", course.slowed},
            {"records", course.records.size()},
            {"sound_count", course.sound_count},
            {"places", places}};
}

void check_same(const Identity& saved, const Identity& now, const std::string& name) {
    if (saved.settings != now.settings)
        throw Error(fmt::format("'{}' was saved by another training:\n  saved: {}\n  now:   {}", name, saved.settings,
                                now.settings));
    if (saved.picture != now.picture)
        throw Error(fmt::format("'{}' was saved by a training with another picture", name));
    if (saved.backend != now.backend)
        throw Error(
            fmt::format("'{}' was saved by a training on {}; this one is on {}", name, saved.backend, now.backend));
}

Saved with_header(const json& header) {
    Saved saved;
    header.at("identity").get_to(saved.identity.settings);
    header.at("picture").get_to(saved.identity.picture);
    header.at("backend").get_to(saved.identity.backend);
    header.at("steps").get_to(saved.course.steps);
    header.at("count").get_to(saved.course.count);
    header.at("slowed").get_to(saved.course.slowed);
    header.at("sound_count").get_to(saved.course.sound_count);
    for (const json& place : header.at("places")) saved.pool[place.get<std::size_t>()];
    return saved;
}

}  // namespace

void write_saved(const std::filesystem::path& path, const Identity& identity, const CourseState& course,
                 const PoolStates& pool) {
    Writer file(path);
    file.bytes(magic.data(), magic.size());
    const std::string header = header_of(identity, course, pool).dump();
    const std::uint64_t length = header.size();
    file.bytes(&length, sizeof length);
    file.bytes(header.data(), header.size());
    for (const Learned<float>* learned : {&course.learned, &course.sound}) {
        for (const auto* numbers : {&learned->weights, &learned->mean, &learned->square}) file.array(*numbers);
    }
    file.bytes(&course.seed_loss, sizeof course.seed_loss);
    for (const StepRecord& record : course.records) {
        file.bytes(&record.step, sizeof record.step);
        file.bytes(&record.loss, sizeof record.loss);
        file.bytes(&record.rate, sizeof record.rate);
        file.bytes(&record.iterations, sizeof record.iterations);
    }
    for (const auto& [place, state] : pool) file.array(state);
    file.finish();
}

Saved parse_saved(std::string_view bytes, const LearningShape& shape, const Identity& now, const std::string& name) {
    Reader file(bytes, name);
    const auto length = load<std::uint64_t>(file.take(sizeof(std::uint64_t)).data());
    const json header = json::parse(file.take(length), nullptr, false);
    if (header.is_discarded()) file.fail();
    Saved saved = with_header(header);
    check_same(saved.identity, now, name);
    CourseState& course = saved.course;
    for (Learned<float>* learned : {&course.learned, &course.sound}) {
        for (auto* numbers : {&learned->weights, &learned->mean, &learned->square})
            *numbers = file.array<float>(shape.weights());
    }
    course.seed_loss = file.array<float>(1)[0];
    for (std::size_t n = header.at("records").get<std::size_t>(); n > 0; --n) {
        StepRecord& record = course.records.emplace_back();
        record.step = file.array<std::uint64_t>(1)[0];
        record.loss = file.array<float>(1)[0];
        record.rate = file.array<double>(1)[0];
        record.iterations = file.array<std::uint64_t>(1)[0];
    }
    for (auto& [place, state] : saved.pool) state = file.array<float>(shape.sample());
    file.end();
    return saved;
}

Saved read_saved(const std::filesystem::path& path, const LearningShape& shape, const Identity& now) {
    return parse_saved(read_file(path), shape, now, path.string());
}

}  // namespace pelage::learn
