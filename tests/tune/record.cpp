// What is remembered: kept, found again, and not mistaken for something else.
#include "tune/record.hpp"

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/file_bytes.hpp"
#include "lattices.hpp"

#include <unistd.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>

using namespace pelage;
using namespace pelage::tune;

namespace {

class Folder {
public:
    Folder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "pelage-tuning-XXXXXX").string();
        REQUIRE(mkdtemp(pattern.data()) != nullptr);
        path = pattern;
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::filesystem::path path;
};

const Candidate deep{Path::streamed, 16, {32, 256, 8, 0}};
const Candidate shallow{Path::streamed, 16, {8, 256, 8, 0}};

Key some_key() {
    DeviceInfo device;
    device.name = "Some \xff device";  // not UTF-8
    device.version = "OpenCL 3.0";
    device.driver = "1.2";
    device.platform_version = "3";
    return make_key(device, "00ff", Precision::single_, false, test::spots(100, 80));
}

Trial good(const Candidate& candidate, double speed) { return {candidate, Verdict::good, speed, "fused", ""}; }
Trial struck(const Candidate& candidate, Verdict verdict) { return {candidate, verdict, 0, "", "because"}; }

Record some_record() {
    Record record;
    record.key = some_key();
    record.complete = true;
    record.put(good({}, 1e9));
    record.put(good(deep, 1.5e9));
    record.put(struck(shallow, Verdict::crashed));
    return record;
}

}  // namespace

TEST_CASE("a record is found again as it was kept") {
    const Folder folder;
    const Record record = some_record();

    REQUIRE(store_record(folder.path / "new", record).empty());
    const auto back = load_record(folder.path / "new", some_key());

    REQUIRE(back.has_value());
    CHECK(back->key == record.key);
    CHECK(back->complete);
    CHECK_FALSE(back->exhaustive);
    CHECK(to_json(*back) == to_json(record));
    CHECK(back->best() == deep);
}

TEST_CASE("another driver, program, precision, size or set of rules has another record") {
    const Folder folder;
    REQUIRE(store_record(folder.path, some_record()).empty());
    Key key = some_key();

    SECTION("device") { key.device = "Other"; }
    SECTION("driver") { key.driver = "1.3"; }
    SECTION("program") { key.program = "00fe"; }
    SECTION("precision") { key.precision = "double"; }
    SECTION("fast") { key.fast = true; }
    SECTION("size") { key.size = "256 x 64"; }
    SECTION("rules") { key.rules += "rule always polarize U\n"; }

    CHECK_FALSE(load_record(folder.path, key).has_value());
}

TEST_CASE("a file under the right name that speaks of another key is not taken") {
    const Folder folder;
    Record record = some_record();
    record.key.driver = std::string("9");
    REQUIRE(store_record(folder.path, record).empty());

    std::filesystem::rename(record_file(folder.path, record.key), record_file(folder.path, some_key()));

    CHECK_FALSE(load_record(folder.path, some_key()).has_value());
}

TEST_CASE("a damaged record is not there") {
    const Folder folder;
    REQUIRE(store_record(folder.path, some_record()).empty());
    const auto file = record_file(folder.path, some_key());
    const std::string whole = read_file(file);

    for (const std::string& text :
         {std::string(), whole.substr(0, whole.size() / 2), std::string("[1, 2]"), std::string("\xff\xfe"),
          std::string(whole).replace(whole.find("crashed"), 7, "dancing"),
          std::string(whole).replace(whole.rfind("\"depth\""), 7, "\"death\"")}) {
        write_file(file, text);
        CHECK_FALSE(load_record(folder.path, some_key()).has_value());
    }
}

TEST_CASE("a forgotten record is not there, and forgetting nothing is no error") {
    const Folder folder;
    REQUIRE(store_record(folder.path, some_record()).empty());

    forget_record(folder.path, some_key());
    forget_record(folder.path, some_key());

    CHECK_FALSE(load_record(folder.path, some_key()).has_value());
}

TEST_CASE("without a folder, or in one that cannot be made, nothing is kept and nothing breaks") {
    const Folder folder;
    write_file(folder.path / "file", "x");

    CHECK(store_record({}, some_record()) == "there is no folder for it");
    CHECK(store_record(folder.path / "file" / "below", some_record()).find("below") != std::string::npos);
    CHECK_FALSE(load_record({}, some_key()).has_value());
}

TEST_CASE("the fastest is best only where it is clearly faster than the defaults") {
    Record record;
    record.put(good({}, 1e9));

    record.put(good(deep, 1.02e9));
    CHECK(record.best() == Candidate{});
    CHECK(record.gain() == 0);

    record.put(good(deep, 1.25e9));
    CHECK(record.best() == deep);
    CHECK(record.gain() == Approx(0.25));
}

TEST_CASE("what is struck out is never best, the defaults neither") {
    Record record;
    record.put(good({}, 1e9));
    record.put(good(deep, 2e9));
    record.put(good(shallow, 1.5e9));

    record.put(struck(deep, Verdict::wrong));
    CHECK(record.best() == shallow);

    record.put(struck({}, Verdict::hung));
    CHECK(record.best() == shallow);
    CHECK(record.gain() == 0);

    record.put(struck(shallow, Verdict::wrong));
    CHECK(record.best() == Candidate{});
}

TEST_CASE("before the defaults have been tried they stay") {
    Record record;
    record.put(good(deep, 2e9));

    CHECK(record.best() == Candidate{});
}
