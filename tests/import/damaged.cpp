// Damaged files: never a crash, always an experiment or a sentence.
#include "import/files.hpp"

#include <catch2/catch.hpp>

#include <fstream>
#include <random>

using namespace test;

namespace {

const std::vector<std::string> whole_files{"spots.vti", "image.vti", "labyrinth.json", "address.txt"};

std::string file(const std::string& name) { return read_all(std::string(PELAGE_SOURCE "/tests/import/") + name); }

// Anything but Error fails the test.
bool taken(const std::string& bytes) { return refusal(bytes).empty(); }

}  // namespace

TEST_CASE("a file that is cut off anywhere is taken or refused") {
    for (const std::string& name : whole_files) {
        const std::string whole = file(name);
        INFO(name);
        CHECK(taken(whole));
        std::size_t refused = 0;
        for (std::size_t end = 0; end<whole.size(); end += whole.size()> 2000 ? 7 : 1)
            refused += taken(whole.substr(0, end)) ? 0 : 1;
        CHECK(refused > whole.size() / 10);
    }
}

TEST_CASE("a file with wrong bits is taken or refused") {
    std::mt19937 random(7);
    for (const std::string& name : whole_files) {
        const std::string whole = file(name);
        std::size_t refused = 0;
        for (int i = 0; i < 400; ++i) {
            std::string changed = whole;
            for (int k = 0; k < 1 + i % 3; ++k)
                changed[random() % changed.size()] ^= static_cast<char>(1u << random() % 8);
            refused += taken(changed) ? 0 : 1;
        }
        INFO(name);
        CHECK(refused > 20);
    }
}

TEST_CASE("elements without end, and entities that grow, are refused") {
    std::string deep, many = "<a>";
    for (int i = 0; i < 100'000; ++i) deep += "<a>";
    CHECK_THAT(refusal(deep), Catch::Contains("nested too deeply"));
    for (int i = 0; i < 110'000; ++i) many += "<b/>";
    CHECK_THAT(refusal(many + "</a>"), Catch::Contains("too many elements"));
    CHECK_THAT(refusal("<!DOCTYPE a [<!ENTITY x \"y\">]><a>&x;</a>"), Catch::Contains("document type"));
}

TEST_CASE("the command writes an experiment that can be checked, or nothing") {
    const Folder folder;
    const std::string source = std::string(PELAGE_SOURCE "/tests/import/image.vti");
    const std::string result = (folder / "x.pex").string();
    const Outcome made = command({"import", source, "-o", result});
    CHECK(made.exit_code == 0);
    CHECK(made.out == result + "\n" + (folder / "x.a.npy").string() + "\n");
    CHECK(command({"check", "--strict", result}).exit_code == 0);

    const std::string broken = folder.write("broken.vti", file("image.vti").substr(0, 900));
    const Outcome refused = command({"import", broken});
    CHECK(refused.exit_code == 2);
    CHECK(refused.out.empty());
    CHECK_THAT(refused.err, Catch::StartsWith("pelage: " + broken + ":"));
    CHECK(names_in(folder.path()) == std::vector<std::string>{"broken.vti", "x.a.npy", "x.pex"});

    const std::string copy = folder.write("y.json", file("labyrinth.json"));
    CHECK(command({"import", copy, "--quiet"}).out.empty());
    CHECK(names_in(folder.path()).size() == 5);
    CHECK_THAT(command({"import", copy}).err, Catch::Contains("is there already"));
    CHECK(command({"import", (folder / "none.vti").string()}).exit_code == 2);
    CHECK(command({"import", folder.path().string(), "-o", result}).exit_code == 2);
    CHECK(command({"import", copy, "-o", (folder / "no/where.pex").string()}).exit_code == 2);
}

TEST_CASE("the command does not write over what it imports, by its own name, another or a link") {
    const Folder folder;
    const std::string source = folder.write("y.json", file("labyrinth.json"));
    const std::string before = read_all(source);
    std::filesystem::create_symlink(source, folder / "link.pex");
    for (const std::string& out : {source, (folder / "../").string() + folder.path().filename().string() + "/y.json",
                                   (folder / "link.pex").string()}) {
        const Outcome refused = command({"import", source, "-o", out});
        CHECK(refused.exit_code == 2);
        CHECK_THAT(refused.err, Catch::Contains("-o " + out + " is what is imported; name another file"));
        CHECK(read_all(source) == before);
    }
    const std::string array = folder.write("x.a.npy", file("image.vti"));  // where the experiment's array would lie
    const Outcome refused = command({"import", array, "-o", (folder / "x.pex").string()});
    CHECK(refused.exit_code == 2);
    CHECK_THAT(refused.err, Catch::Contains("x.a.npy is what is imported"));
    CHECK(read_all(array) == file("image.vti"));
}

TEST_CASE("every file here runs") {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(PELAGE_SOURCE "/tests/import")) {
        const auto ending = entry.path().extension();
        if (ending != ".vti" && ending != ".json" && ending != ".txt") continue;
        INFO(entry.path().string());
        const auto made = imported(read_all(entry.path()));
        const auto state = run(made, 20);
        for (const auto& values : state.conc) {
            for (const double value : values) REQUIRE(std::isfinite(value));
        }
        ++files;
    }
    CHECK(files >= 10);
}
