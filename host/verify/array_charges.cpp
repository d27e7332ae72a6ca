// See array_text.hpp: experiments with charges. What is drawn for one place of the text depends on its own factor
// alone.
#include "verify/array_text.hpp"

#include <fmt/format.h>

#include <array>

namespace pelage::verify {

namespace {

class ChargesWriter {
public:
    explicit ChargesWriter(const GeneratedCase& one)
        : size_(one.size), seed_(one.run_seed()), world_(one.world()), start_(std::stoull(world_["start"])) {}

    std::string text() const {
        std::string text = "define time_step 0.05\n";
        for (const char* const name : {"order", "phi", "family", "mass"})
            text += fmt::format("define chemical {}\n", name);
        text += fmt::format("use seed {}\ncreate charges {} {}{}{}\n", seed_, size_.columns, size_.rows, at(), where());
        text += seeds();
        text += is("when", "every") ? "rule every 2 offset 1 always " : "rule always ";
        text += action(eta()) + "\n";
        if (!is("when", "phases")) return text + fmt::format("stop at {}\n", start_ + 400);
        text += fmt::format("phase \"one\" {}\nphase \"two\" 40\nrule every 3 offset 1 always {}\n", start_ + 2,
                            action("eta 8.5"));
        return text + "phase \"three\" 400\n";
    }

private:
    bool is(const char* factor, const char* value) const { return world_[factor] == value; }

    std::string at() const { return is("at", "elsewhere") ? " at -7.5 3.25" : ""; }

    // Walls have doors; grains are free sites at random.
    std::string where() const {
        if (is("where", "walls")) return " where (mod(COLUMN, 9) != 8 or ROW == mod(7 * COLUMN, ROWS))";
        return is("where", "grains") ? " where (RANDOM < 0.85 or " + seed() + ")" : "";
    }

    // Where charges are at the start, never in a wall: a few, or lines of more than a device takes at once, and some
    // more than there were when bounds were made anew.
    std::string seed() const {
        if (is("seeds", "few")) return "mod(COLUMN, 9) == 3 and mod(ROW, 11) == 2";
        return "mod(COLUMN, 9) != 8 and COLUMN != 0 and mod(ROW, 5) == 1";
    }

    // Sizes come again neither with the lines nor with a device's groups of charges.
    std::string seeds() const {
        std::string text = fmt::format("set cells where ({}) chemical order conc (1 + mod(COLUMN + ROW, 3))", seed());
        if (is("family", "given")) text += " chemical family conc (mod(COLUMN, 4))";
        if (!is("charges", "alike")) text += " chemical mass conc (0.125 * mod(COLUMN + 3 * ROW, 7))";
        return text + "\n";
    }

    std::string elapsed() const { return fmt::format("(ITERATION - {})", start_); }

    std::string eta() const {
        if (is("eta", "0")) return "eta 0";
        return is("eta", "number") ? "eta 3.5" : fmt::format("eta (1 + {} / 64)", elapsed());
    }

    std::string action(const std::string& eta) const {
        std::string text = "aggregate order phi " + eta;
        if (is("radius", "number")) text += " radius 2.25";
        if (is("radius", "expression")) text += fmt::format(" radius (2 + {} / 512)", elapsed());
        if (is("towards", "number")) text += " towards 20.5 -4 strength 3";
        if (is("towards", "expression"))
            text += fmt::format(" towards ({} - 40) (TIME - {}) strength (5 - {} / 256)", elapsed(),
                                0.05 * static_cast<double>(start_), elapsed());
        if (is("field", "far")) text += " far-field";
        if (!is("family", "none")) text += " seed family";
        if (is("charges", "number")) text += " size mass 2.75";
        if (is("charges", "expression")) text += " size mass (0.01 + 20 * RANDOM ^ 3)";
        return text;
    }

    Size size_;
    std::int64_t seed_;
    Values world_;
    std::uint64_t start_;
};

}  // namespace

std::string charges_text(const GeneratedCase& one) { return ChargesWriter(one).text(); }

// Wide ones have more candidates than a block of weights; small ones are full in the end.
Size charges_size(const GeneratedWorld& made) {
    const Values world(Realm::charges, made.world);
    if (world.has("sizes", "full")) return {19, 11};
    const std::array<Size, 2> wide{Size{89, 71}, Size{120, 121}}, narrow{Size{97, 5}, Size{5, 83}};
    return (world.has("sizes", "wide") ? wide : narrow)[made.number % 2];
}

}  // namespace pelage::verify
