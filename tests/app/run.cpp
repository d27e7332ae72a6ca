// `pelage run`: the files it promises, the manifest, and what its options change.
#include "support/process.hpp"
#include "texts.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

using test::command;
using test::Folder;
using test::Outcome;
using test::read_all;

namespace {

nlohmann::json read_json(const std::filesystem::path& file) { return nlohmann::json::parse(read_all(file)); }

Outcome run(const std::string& file, const std::string& out, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"run", file, "--out", out});
    return command(more);
}

}  // namespace

TEST_CASE("a run leaves the promised files and a manifest with all keys") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    const std::string backend = GENERATE(as<std::string>(), "reference", "opencl");

    const Outcome outcome = run(file, folder / "out", {"--backend", backend, "--format", "exr,png,npy,csv,vti"});

    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(outcome.out.find((folder / "out").string()) != std::string::npos);
    CHECK(test::names_in(folder / "out") == std::vector<std::string>{"final.U.npy", "final.V.npy", "final.csv",
                                                                     "final.exr", "final.png", "final.vti",
                                                                     "manifest.json"});
    const nlohmann::json manifest = read_json(folder / "out" / "manifest.json");
    CHECK(manifest.at("backend") == backend);
    CHECK(manifest.at("precision") == "float");
    CHECK(manifest.at("seed") == 7);
    CHECK(manifest.at("iterations") == 60);
    CHECK(manifest.at("cells") == 24 * 16);
    CHECK(manifest.at("seconds").get<double>() > 0);
    CHECK(manifest.at("updates_per_second").get<double>() > 0);
    CHECK_FALSE(manifest.at("device").get<std::string>().empty());
    CHECK(manifest.at("experiment").at("text") == test::spots);
    CHECK(manifest.at("fast") == false);
    CHECK(manifest.at("end") == "finished");
}

TEST_CASE("without --format a run writes EXR and PNG") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);

    const Outcome outcome = run(file, folder / "out", {"--backend", "reference"});

    REQUIRE(outcome.exit_code == 0);
    CHECK(test::names_in(folder / "out") == std::vector<std::string>{"final.exr", "final.png", "manifest.json"});
}

TEST_CASE("without --out the results are in out/NAME of the folder one is in") {
    const Folder folder;
    const std::string file = folder.write("my spots.pex", test::spots);
    test::Surroundings there;
    there.folder = folder.path();

    const Outcome outcome = command({"run", file, "--backend", "reference"}, there);

    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(std::filesystem::exists(folder.path() / "out" / "my spots" / "final.png"));
}

TEST_CASE("option --json writes the manifest's object a second time") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);

    const Outcome outcome =
        run(file, folder / "out", {"--backend", "reference", "--json", folder / "new" / "run.json"});

    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(read_json(folder.path() / "new" / "run.json") == read_json(folder / "out" / "manifest.json"));
}

TEST_CASE("both backends end in the same bits") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);

    REQUIRE(run(file, folder / "a", {"--backend", "reference", "--format", "npy"}).exit_code == 0);
    REQUIRE(run(file, folder / "b", {"--backend", "opencl", "--format", "npy"}).exit_code == 0);

    for (const char* name : {"final.U.npy", "final.V.npy"}) {
        const std::string bytes = read_all(folder / "a" / name);
        CHECK(std::set<char>(bytes.end() - 400, bytes.end()).size() > 20);  // not a flat field
        CHECK(bytes == read_all(folder / "b" / name));
    }
}

TEST_CASE("option --iterations moves the end, 0 included") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    const std::uint64_t count = GENERATE(0u, 1u, 61u, 200u);

    const Outcome outcome =
        run(file, folder / "out", {"--backend", "reference", "--iterations", std::to_string(count)});

    REQUIRE(outcome.exit_code == 0);
    CHECK(read_json(folder / "out" / "manifest.json").at("iterations") == count);
}

TEST_CASE("option --seed changes the result, and the same seed repeats it") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    const auto result = [&](const std::string& name, const std::vector<std::string>& seed) {
        std::vector<std::string> more{"--backend", "reference", "--format", "npy"};
        more.insert(more.end(), seed.begin(), seed.end());
        REQUIRE(run(file, folder / name, more).exit_code == 0);
        return read_all(folder / name / "final.U.npy");
    };

    const std::string own = result("own", {});
    const std::string seven = result("seven", {"--seed", "7"});
    const std::string eight = result("eight", {"--seed", "8"});

    CHECK(own == seven);
    CHECK(own != eight);
    CHECK(read_json(folder / "eight" / "manifest.json").at("seed") == 8);
}

TEST_CASE("seed 0 comes from the clock and is written down, so that the run can be repeated") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    REQUIRE(run(file, folder / "a", {"--backend", "reference", "--format", "npy", "--seed", "0"}).exit_code == 0);
    const auto seed = read_json(folder / "a" / "manifest.json").at("seed").get<std::int64_t>();

    REQUIRE(run(file, folder / "b", {"--backend", "reference", "--format", "npy", "--seed", std::to_string(seed)})
                .exit_code == 0);

    CHECK(seed > 1'000'000'000);
    CHECK(read_all(folder / "a" / "final.U.npy") == read_all(folder / "b" / "final.U.npy"));
}

TEST_CASE("option --precision double computes in double") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);

    REQUIRE(run(file, folder / "a", {"--backend", "reference", "--format", "npy"}).exit_code == 0);
    REQUIRE(run(file, folder / "b", {"--backend", "reference", "--format", "npy", "--precision", "double"}).exit_code ==
            0);

    CHECK(read_json(folder / "b" / "manifest.json").at("precision") == "double");
    CHECK(read_all(folder / "b" / "final.U.npy").size() == 128 + 24 * 16 * 8);
    CHECK(read_all(folder / "a" / "final.U.npy").size() == 128 + 24 * 16 * 4);
}

TEST_CASE("snapshots are named after their iteration") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots + "snap at 5 33\n");

    const Outcome outcome =
        run(file, folder / "out", {"--backend", "reference", "--format", "png,csv", "--snap-every", "25"});

    REQUIRE(outcome.exit_code == 0);
    CHECK(test::names_in(folder / "out") == std::vector<std::string>{"0.csv", "0.png", "25.csv", "25.png", "33.csv",
                                                                     "33.png", "5.csv", "5.png", "50.csv", "50.png",
                                                                     "final.csv", "final.png", "manifest.json"});
}

TEST_CASE("snapshots and batches change no bit of the result") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    const std::string backend = GENERATE(as<std::string>(), "reference", "opencl");

    REQUIRE(run(file, folder / "a", {"--backend", backend, "--format", "npy"}).exit_code == 0);
    REQUIRE(run(file, folder / "b", {"--backend", backend, "--format", "npy", "--snap-every", "7"}).exit_code == 0);

    CHECK(read_all(folder / "a" / "final.V.npy") == read_all(folder / "b" / "final.V.npy"));
    CHECK(read_all(folder / "b" / "0.V.npy") != read_all(folder / "b" / "7.V.npy"));
}

TEST_CASE("option --quiet says nothing, and otherwise the run says what it runs on") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);

    const Outcome quiet = run(file, folder / "out", {"--backend", "reference", "--quiet"});
    const Outcome loud = run(file, folder / "out", {"--backend", "reference"});

    CHECK(quiet.exit_code == 0);
    CHECK(quiet.out.empty());
    CHECK(quiet.err.empty());
    CHECK(loud.err.find("backend: reference") != std::string::npos);
    CHECK(loud.err.find("million cell-updates a second") != std::string::npos);
    CHECK(loud.err.find('\x1b') == std::string::npos);  // no bar in a log
}

TEST_CASE("a run prints the warnings of its experiment once, and none with --quiet") {
    const Folder folder;
    const std::string file = folder.write("doubtful.pex", test::spots + "snap at 99\n");
    const std::vector<std::string> run{"run",      file,  "--backend", "reference",
                                       "--format", "csv", "--out",     folder / "out"};
    const auto with = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words = run;
        words.insert(words.end(), more.begin(), more.end());
        return command(words);
    };

    const Outcome loud = with({});

    CHECK(loud.exit_code == 0);
    const std::size_t at = loud.err.find("doubtful.pex:11:9: warning: the snapshot at 99");
    CHECK(at != std::string::npos);
    CHECK(loud.err.find("warning:", loud.err.find("warning:") + 1) == std::string::npos);
    CHECK(with({"--quiet"}).err.empty());
    CHECK_THAT(with({"--iterations", "100"}).err, !Catch::Contains("warning"));  // it comes in a longer run
    CHECK_THAT(with({"--iterations", "5"}).err, !Catch::Contains("ends at 5"));
}

TEST_CASE("the default backend is opencl where a device is, else the reference, and the run says which and why") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    test::Surroundings bare;
    bare.environment["OCL_ICD_VENDORS"] = folder / "no drivers here";

    const Outcome usual = run(file, folder / "a");
    const Outcome without = command({"run", file, "--out", folder / "b"}, bare);

    CHECK(usual.exit_code == 0);
    CHECK(usual.err.find("backend: opencl") != std::string::npos);
    CHECK(without.exit_code == 0);
    CHECK(without.err.find("backend: reference") != std::string::npos);
    CHECK(without.err.find("not opencl: ") != std::string::npos);
    CHECK(read_json(folder / "b" / "manifest.json").at("backend") == "reference");
}

TEST_CASE("options may stand before the file, and a seed may be negative") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);

    const Outcome outcome = command(
        {"run", "--backend", "reference", "--seed", "-3", "--out", folder / "out", "--format", "npy,png", file});

    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(read_json(folder / "out" / "manifest.json").at("seed") == -3);
}

TEST_CASE("option --fast and --no-cache are accepted on opencl, and --fast is in the manifest") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);

    const Outcome outcome = run(file, folder / "out", {"--backend", "opencl", "--fast", "--no-cache"});

    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(read_json(folder / "out" / "manifest.json").at("fast") == true);
}

TEST_CASE("pictures of a tissue that grows are in one scale, that of the last one") {
    const Folder folder;
    const std::string file = folder.write("growing.pex",
                                          "define chemical U\nuse chemical U conc 1 dev 1\ncreate matrix 20 20\n"
                                          "rule always expand columns 1 rows 1\nstop at 80\n");
    REQUIRE(command({"run", file, "--backend", "reference", "--format", "png", "--snap-every", "40", "--quiet", "--out",
                     folder / "out"})
                .exit_code == 0);
    // The header of a PNG: width and height in big-endian bytes from the 16th on.
    const auto width = [&](const char* name) {
        const std::string bytes = test::read_all(folder / "out" / name);
        return 256 * static_cast<unsigned char>(bytes.at(18)) + static_cast<unsigned char>(bytes.at(19));
    };
    CHECK(width("0.png") == 4 * 20);
    CHECK(width("40.png") == 4 * 60);
    CHECK(width("final.png") == 4 * 100);
}

TEST_CASE("counts in the manifest are whole numbers") {
    const Folder folder;
    const std::string file = folder.write("cells.pex", "define chemical U\ncreate hex_circle 3\nstop at 10\n");
    REQUIRE(command({"run", file, "--backend", "opencl", "--neighbours", "spatial-sorting", "--quiet", "--out",
                     folder / "out"})
                .exit_code == 0);
    const nlohmann::json manifest = read_json(folder / "out" / "manifest.json");
    for (const char* key : {"first_iteration", "neighbours_missed", "neighbours_exact"}) {
        INFO(key);
        CHECK(manifest.at(key).is_number_unsigned());
    }
}
