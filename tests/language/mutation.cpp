// Damaged experiments: whatever the damage, parsing ends in an Experiment or an Error, and soon.
#include "core/error.hpp"
#include "language/error_case.hpp"
#include "language/parse.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

using namespace test;

namespace {

std::vector<std::string> seeds() {
    std::vector<std::string> texts;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(PELAGE_SOURCE) / "tests/fuzz/corpus")) {
        std::ifstream file(entry.path(), std::ios::binary);
        texts.push_back((std::ostringstream() << file.rdbuf()).str());
    }
    return texts;
}

class Mutator {
public:
    explicit Mutator(const std::vector<std::string>& texts) : texts_(texts) {}

    std::string next() {
        std::string text = pick(texts_);
        for (std::size_t i = below(4) + 1; i > 0; --i) damage(text);
        return text;
    }

private:
    std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }
    const std::string& pick(const std::vector<std::string>& all) { return all[below(all.size())]; }

    void damage(std::string& text) {
        static const std::vector<std::string> pieces{
            "-1", "1e999", "nan", "4294967296", "\"",   "//",   "\n", "\t", "react", "conc", "create", "phase", "none",
            "0",  "at",    "U",   "2147483647", "\r\n", "\xff", ",",  "to", "rule",  "and",  " "};
        const std::size_t at = below(text.size());
        switch (below(5)) {
            case 0:
                text.insert(at, pick(pieces));
                break;
            case 1:
                text.erase(at, below(12) + 1);
                break;
            case 2:
                if (!text.empty()) text[at] = static_cast<char>(below(256));
                break;
            case 3:
                text.replace(at, below(6), pick(pieces));
                break;
            default:
                text.insert(at, text.substr(below(text.size()), below(40)));
        }
    }

    const std::vector<std::string>& texts_;
    std::mt19937 random_{20170917};
};

}  // namespace

TEST_CASE("seeds of the fuzzer are good experiments") {
    const std::vector<std::string> texts = seeds();

    REQUIRE(texts.size() >= 8);
    for (const std::string& text : texts) {
        INFO(text);
        CHECK(message_of(text) == "(none)");
    }
}

TEST_CASE("damaged experiments are read or refused with a place, never more") {
    const std::vector<std::string> texts = seeds();
    Mutator mutator(texts);
    std::size_t refused = 0;

    for (int i = 0; i < 5000; ++i) {
        const std::string text = mutator.next();
        const std::string message = message_of(text);  // another exception would end the test
        if (message == "(none)") continue;
        ++refused;
        INFO(text << "\n" << message);
        REQUIRE(message.rfind("t.pex:", 0) == 0);
    }

    CHECK(refused > 1000);
    CHECK(refused < 5000);
}
