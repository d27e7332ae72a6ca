// include "FILE": other files' lines, and where messages say they stand.
#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "language/lint.hpp"
#include "language/parse.hpp"
#include "parsed.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

using namespace pelage;
using Catch::Matchers::Contains;

namespace {

template <class Act>
std::string error_of(Act&& act) {
    try {
        act();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

// A folder in which files include each other.
class Shelf {
public:
    void put(const std::string& name, const std::string& text) const {
        const auto path = folder_.path() / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
    }
    Experiment read(const std::vector<Setting>& settings = {}, Outline* outline = nullptr) const {
        return parse_experiment_file(folder_.path() / "main.pex", outline, StartPictures::read, settings);
    }
    std::string error() const {
        return error_of([&] { read(); });
    }
    std::string main() const { return (folder_.path() / "main.pex").string(); }

private:
    test::Folder folder_;
};

const std::string begin = "define chemical U\ncreate matrix 8 6\n";

}  // namespace

TEST_CASE("an included file's lines stand in the place of the statement, and the text holds them all") {
    const Shelf shelf;
    shelf.put("main.pex", begin + "\tinclude \"parts/start.pex\"  // a disc\nrule always change U conc 1\nstop at 3\n");
    shelf.put("parts/start.pex",
              "\xef\xbb\xbf"
              "define parameter r 4\r\ninclude \"disc.pex\"\r\n");
    shelf.put("parts/disc.pex", "set cells where (hypot(X, Y) < r) chemical U conc 2");
    const Experiment wide = shelf.read({{"r", "100"}});
    const Experiment experiment = shelf.read();

    CHECK(experiment.prepattern.size() == 2);
    CHECK(experiment.rules.at(0).line == 9);
    CHECK_THAT(wide.text, Contains("define parameter r 100\n"));
    CHECK(initial_state(wide).conc[0] == std::vector<double>(48, 2.0));
    const Experiment again = parse_experiment(wide.text, "again.pex", "/not/there");
    CHECK(initial_state(again).conc == initial_state(wide).conc);
    CHECK(again.rules.size() == 1);
    CHECK(again.included.empty());
}

TEST_CASE("messages name every file on the way to a line, with the line's number in each") {
    const Shelf shelf;
    const std::string middle = "// one\ninclude \"empty.pex\"\ninclude \"inner.pex\"\n";
    shelf.put("empty.pex", "");
    shelf.put("inner.pex", "// one\n\n  set cell 99 fixed\n");
    SECTION("in a file in a file") {
        shelf.put("main.pex", begin + "include \"empty.pex\"\n\ninclude \"middle.pex\"\n");
        shelf.put("middle.pex", middle);
        CHECK_THAT(shelf.error(),
                   Contains(shelf.main() + ":5: in middle.pex:3: in inner.pex:3:12: '99' is out of range"));
    }
    SECTION("behind what is included") {
        shelf.put("middle.pex", "include \"empty.pex\"\ninclude \"empty.pex\"\nrule always\n");
        shelf.put("main.pex", begin + "include \"empty.pex\"\ninclude \"middle.pex\"\n");
        CHECK_THAT(shelf.error(), Contains(shelf.main() + ":4: in middle.pex:3:12: the line ends too early"));
        shelf.put("middle.pex", "include \"empty.pex\"\n\n");
        shelf.put("main.pex", begin + "include \"empty.pex\"\ninclude \"middle.pex\"\nrule never");
        CHECK_THAT(shelf.error(), Contains(shelf.main() + ":5:6: unknown word 'never'"));
    }
    SECTION("of what only the whole file shows") {
        shelf.put("main.pex", "define chemical U\ncreate hex_grid 3 3\ninclude \"growth.pex\"\n");
        shelf.put("growth.pex", "\nrule always expand columns 1\n");
        CHECK_THAT(shelf.error(), Contains(shelf.main() + ":3: in growth.pex:2:13: 'expand' needs a matrix"));
    }
    SECTION("of warnings") {
        shelf.put("main.pex", begin + "include \"more.pex\"\n");
        shelf.put("more.pex", "\ndefine chemical Unused\n");
        Outline outline;
        const Experiment experiment = shelf.read({}, &outline);
        const auto warnings = lint(experiment, outline, 10);
        const auto unused = std::ranges::find(warnings, "unused-chemical", &Warning::lint);
        REQUIRE(unused != warnings.end());
        CHECK_THAT(shown(experiment, *unused), Contains(shelf.main() + ":3: in more.pex:2:17: warning"));
    }
    SECTION("of what the start shows") {
        shelf.put("main.pex", begin + "include \"start.pex\"\n");
        shelf.put("start.pex", "\n\nset cells where (1) chemical U conc (0 - X - 100)\n");
        CHECK_THAT(
            error_of([&] { initial_state(shelf.read()); }),
            Contains(":3: in start.pex:3:37: an expression starts 'U' with the concentration -93 in cell 0; it must be "
                     "a number not below 0"));
    }
}

TEST_CASE("what cannot be included") {
    const Shelf shelf;
    shelf.put("main.pex", begin + "include \"a.pex\"\n");
    shelf.put("a.pex", "include \"b.pex\"\n");
    const auto problem = [&](const std::string& text) {
        shelf.put("b.pex", text);
        return shelf.error();
    };
    CHECK_THAT(problem("include \"a.pex\""), Contains("in a.pex:1: in b.pex:1:9: \"a.pex\" includes itself"));
    CHECK_THAT(problem("include \"./b.pex\""), Contains("\"./b.pex\" includes itself"));
    CHECK_THAT(problem("include \"main.pex\""), Contains("\"main.pex\" includes itself"));
    CHECK_THAT(problem("include \"c.pex\""), Contains("\"c.pex\" is no file that can be read"));
    CHECK_THAT(problem("include \"/dev/zero\""), Contains("\"/dev/zero\" is no file that can be read"));
    CHECK_THAT(problem("include \".\""), Contains("\".\" is no file that can be read"));
    CHECK_THAT(problem("include"), Contains("the line ends too early; the included file's name must be"));
    CHECK_THAT(problem("include c.pex"), Contains("'c.pex' has no quotes"));
    CHECK_THAT(problem("include \"c.pex\" again"), Contains("'again' follows a statement that is complete"));
    CHECK_THAT(problem("include(1)"), Contains("has no quotes"));
    CHECK_THAT(problem("includes \"c.pex\""), Contains("unknown word 'includes'"));
}

TEST_CASE("a text that grows with each file it includes ends at the limit") {
    const Shelf shelf;
    shelf.put("main.pex", begin + "include \"0.pex\"\n");
    for (int i = 0; i < 20; ++i) {
        std::string text;
        for (int k = 0; k < 10; ++k) text += "include \"" + std::to_string(i + 1) + ".pex\"\n";
        shelf.put(std::to_string(i) + ".pex", text);
    }
    shelf.put("20.pex", "");
    CHECK_THAT(shelf.error(), Contains("more than 16 files include each other"));
    shelf.put("10.pex", std::string(1000, '/') + "\n");
    CHECK_THAT(shelf.error(), Contains("longer than the 16777216 bytes allowed"));
}
