// The table of formats: each row gives the files that it says, is documented, and loses no bit of a number.
#include "io/format.hpp"
#include "io/results.hpp"
#include "scratch.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using Catch::Matchers::Contains;
using namespace pelage;

namespace {

std::string row_of_manual() {
    const std::string text = test::get(PELAGE_SOURCE "/docs/command.md");
    const std::size_t start = text.find("| `--format LIST` |");
    return text.substr(start, text.find('\n', start) - start);
}

std::vector<std::string> written(const test::Scratch& scratch, const std::string& stem, const Snapshot& state,
                                 Format format) {
    ResultOptions options;
    options.formats = {format};
    return write_results(scratch.folder(), stem, state, test::experiment(), options);
}

}  // namespace

TEST_CASE("every format has its words, its row in the manual and the files that its row says") {
    const test::Scratch scratch;
    const std::vector<std::string> endings = format_endings();
    for (const FormatRow& row : format_table()) {
        INFO(row.words.front());
        for (const std::string& word : row.words) CHECK(parse_formats(word) == std::vector{row.format});
        CHECK_THAT(row_of_manual(), Contains("`" + row.words.front() + "`"));
        for (const bool lattice : {true, false}) {
            const Snapshot state = lattice ? test::lattice(5, 3) : test::cells({0, 2, 4}, {0, 0, 0});
            const char* ending = (lattice ? row.lattice : row.cells).ending;
            const auto files = written(scratch, lattice ? "a" : "b", state, row.format);
            CHECK(files.empty() == (ending == nullptr));
            for (const std::string& file : files) {
                CHECK(file.ends_with(ending));
                CHECK(std::ranges::any_of(endings, [&](const std::string& one) { return file.ends_with(one); }));
            }
        }
    }
}

TEST_CASE("files of numbers tell a float from its neighbour") {
    const test::Scratch scratch;
    for (const FormatRow& row : format_table()) {
        if (row.format == Format::png) continue;  // a picture
        INFO(row.words.front());
        for (const bool lattice : {true, false}) {
            Snapshot state = lattice ? test::lattice(5, 3) : test::cells({0, 2, 4}, {0, 0, 0});
            const auto before = written(scratch, "a", state, row.format);
            double& number = state.conc[1].back();
            number = std::nextafter(static_cast<float>(number), 2.0f);
            const auto after = written(scratch, "b", state, row.format);
            bool told = before.empty();
            for (std::size_t i = 0; i < before.size(); ++i)
                told = told || test::get(scratch / before[i]) != test::get(scratch / after[i]);
            CHECK(told);
        }
    }
}
