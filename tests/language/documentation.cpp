// What docs/language.md must not leave out.
#include "core/models.hpp"

#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>

using namespace pelage;

TEST_CASE("the page on the language lists every reaction with its parameters") {
    std::ifstream file(PELAGE_SOURCE "/docs/language.md");
    std::stringstream page;
    page << file.rdbuf();
    REQUIRE(page.str().size() > 1000);
    for (const ModelFacts& model : model_table()) {
        std::string row = "| `" + model.word;
        for (const ModelParameter& parameter : model.parameters) row += " " + parameter.name + " PAR";
        INFO("docs/language.md needs a row that begins with " << row << "` |");
        CHECK(page.str().find(row + "` |") != std::string::npos);
    }
}
