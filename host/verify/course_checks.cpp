// See check.hpp: whole runs, each made so that something happens in it that few runs have: what is kept from one launch
// to the next must still be right when it comes.
#include "language/parse.hpp"
#include "verify/check.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pelage::verify {

namespace {

struct Course {
    const char* name;
    const char* kernel;
    std::array<std::uint64_t, 2> stretches;  // iterations that the device is given at once
    Path path;
    bool quick;
    const char* text;
    const char* space = "";     // the last line of the text
    std::size_t variants = 16;  // programs for sets of rules that act together, before one tests them all
};

// At first all of them act.
constexpr const char* rules_in_turn = R"(
define chemical A floor none
use chemical A conc 1 dev 0.5 diff 0.1
rule every 2 always change A conc 0.125
rule every 3 always change A conc (0.1 * A)
)";

constexpr std::array<Course, 11> all_courses{{
    // Cells are born while others press against the edge of their domain.
    {"courses/packed-births", "division", {200, 20}, Path::shared, true, R"(
define chemical A
define domain packed area 2.9
use chemical A conc 1 dev 0.5 diff 0.1
create hex_circle 8
rule probability 0.01 divide direction 0 dev 180
)"},
    // Rules begin long after the others, and within a launch.
    {"courses/far-ahead", "cell step", {150, 20}, Path::shared, true, R"(
define chemical A floor none
define chemical B floor none
use chemical A conc 1 dev 0.5 diff 0.1
use chemical B conc 1 dev 0.5 diff 0.1
create hex_circle 6
rule every 2 always change A conc 0.01
rule from 57 always change A conc (0.1 * A)
rule from 64 until 101 always change B conc (0.1 * B)
rule from 133 always change B conc -0.5
)"},
    // A rule ends soon after the device was asked, which a while ago was not so soon.
    {"courses/far-end", "cell step", {40, 40}, Path::shared, true, R"(
define chemical A floor none
use chemical A conc 1 dev 0.5 diff 0.1
create hex_circle 3
rule until 60 always change A conc 0.01
)"},
    // Two come near who were not in each other's lists, none of them far from where it was; at many distances.
    {"courses/head-on", "neighbour search", {60, 60}, Path::shared, true, R"(
define chemical A
define domain 800 800
use chemical A conc 1 dev 0.9 diff 0.2
use polarity 0
create cell -300 0
create cell -250 0
create cell -200 0
create cell -150 0
create cell -100 0
create cell -50 0
create cell 0 0
create cell 50 0
create cell 100 0
create cell 150 0
use chemical A conc 4 diff 0.2
use polarity 180
create cell -296.55 0
create cell -246.5 0
create cell -196.45 0
create cell -146.4 0
create cell -96.35 0
create cell -46.3 0
create cell 3.75 0
create cell 53.8 0
create cell 103.85 0
create cell 153.9 0
rule always move 0.01
)"},
    // A lattice grows into buffers that had other rows before.
    {"courses/growth", "expansion", {60, 7}, Path::step, true, R"(
define chemical A
define chemical B
use chemical A conc 1 dev 0.5 diff 0.1
use chemical B conc 2 dev 0.5 diff 0.2
create matrix 40 30 absorbing
rule every 5 always expand rows 1 columns 1
)"},
    // Of several fields of spots first one is read, then another.
    {"courses/blobs", "mesh step", {20, 5}, Path::step, true, R"(
define chemical A floor none
use chemical A conc 1 dev 0.5 diff 0.1
define field F blobs 5 sigma 0.2
define field G blobs 3 sigma 0.4
define field H blobs 4 sigma 0.3
create icosphere 3
rule until 10 always change A conc (0.1 * F)
rule from 5 always change A conc (0.1 * H)
rule until 15 always change A conc (0.1 * G)
)"},
    // First all rules act, then some, and there is one program for all that come after the first ones.
    {"courses/mesh-sets", "mesh step", {20, 5}, Path::step, true, rules_in_turn, "create icosphere 2", 1},
    {"courses/lattice-sets", "single steps", {20, 5}, Path::step, false, rules_in_turn, "create matrix 20 15", 1},
    {"courses/volume-sets", "volumes", {20, 5}, Path::step, false, rules_in_turn, "create volume 8 7 5", 1},
    // Buffers grow again and again.
    {"courses/candidates", "aggregates", {1300, 1700}, Path::step, true, R"(
define chemical order
define chemical potential
create charges 300 300
set cells where (COLUMN == 150 and ROW == 150) chemical order conc 1
rule always aggregate order potential eta 1
)"},
    {"courses/far-candidates", "aggregates", {1300, 1700}, Path::step, false, R"(
define chemical order
define chemical potential
create charges 300 300
set cells where (COLUMN == 150 and ROW == 150) chemical order conc 1
rule always aggregate order potential eta 1 far-field
)"},
}};

Outcome check_course(const Course& course, Place& place) {
    if (place.small()) return {Verdict::skipped, {}, "left out with --small", {}};
    std::vector<Setting> settings{{.path = course.path, .variants = course.variants}};
    if (place.full()) {
        const Path other = course.path == Path::step ? Path::automatic : Path::step;
        settings.insert(settings.end(), {{.path = other}, {.path = course.path, .guarded = false}});
    }
    const std::string text = std::string("use seed 7\n") + course.text + course.space + "\nstop at 4000\n";
    return beside_the_reference(place, parse_experiment(text, course.name, "."), settings, course.stretches);
}

}  // namespace

std::vector<Check> course_checks() {
    std::vector<Check> checks;
    for (const Course& one : all_courses)
        checks.push_back({one.name, one.kernel, one.quick, [&one](Place& place) { return check_course(one, place); }});
    return checks;
}

}  // namespace pelage::verify
