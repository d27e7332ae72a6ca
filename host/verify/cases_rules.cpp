// See cases.hpp: conditions, actions, quantities, intervals, phases and growth.
#include "core/philox.hpp"
#include "verify/cases.hpp"
#include "verify/lab.hpp"

#include <fmt/format.h>

#include <cmath>

namespace pelage::verify {

namespace {

constexpr std::uint64_t far_iteration = largest_iteration - 60;
constexpr double late_from = static_cast<double>(far_iteration) + 2;

Lab plain(Size size, Boundary boundary = Boundary::wrap) { return Lab::matrix(size.columns, size.rows, boundary); }

Operand conc(std::size_t chemical) { return quantity(Quantity::concentration, chemical); }

Set set_conc(std::size_t chemical, Operand value) { return {Target::concentration, chemical, value}; }
Set set_rate(std::size_t chemical, Operand value) { return {Target::rate, chemical, value}; }

// Every quantity read once as an operand, once in a condition.
Experiment quantities(Lab lab) {
    const Quantity all[] = {Quantity::neighbours, Quantity::age,       Quantity::birth,  Quantity::x,
                            Quantity::y,          Quantity::row,       Quantity::column, Quantity::rows,
                            Quantity::columns,    Quantity::iteration, Quantity::random};
    const auto fed = lab.chemical("F", {10, 4}, {0.05, 0}, unbounded);
    for (const Quantity what : all) {
        const auto place = lab.chemical(fmt::format("Q{}", static_cast<int>(what)), {1, 1}, {0, 0}, unbounded);
        lab.rule(change(place, quantity(what)));
        lab.rule(change(place, number(0.25)), compare(quantity(what), Comparison::less, conc(fed)));
    }
    const auto mapping = lab.mapping("M");
    lab.rule(Map{conc(fed), 6, 14, mapping, -1, 1});
    lab.rule(change(fed, quantity(Quantity::mapping, mapping)));
    lab.rule(change(fed, quantity(Quantity::rate, fed)));
    return lab.done();
}

// Comparisons of whole numbers where float no longer tells them apart: each of them, with a sum of powers of two that
// says which held.
Experiment whole_numbers(Lab lab) {
    const Comparison all[] = {Comparison::equal,      Comparison::not_equal, Comparison::less,
                              Comparison::less_equal, Comparison::greater,   Comparison::greater_equal};
    const auto store = [&](const char* name) { return lab.chemical(name, {1, 1}, {0.05, 0}, unbounded); };
    const auto tell = [&](std::size_t chemical, int nth, const Condition& condition) {
        lab.rule(change(chemical, number(std::ldexp(1.0, -nth))), condition);
    };
    const std::size_t stores[] = {store("I"), store("A"), store("B"), store("P")};
    const Operand iteration = quantity(Quantity::iteration), age = quantity(Quantity::age);
    const Operand birth = quantity(Quantity::birth), row = quantity(Quantity::row);
    int nth = 0;
    for (const Comparison comparison : all) {
        ++nth;
        const double late = static_cast<double>(far_iteration) + 5;
        tell(stores[0], nth, compare(iteration, comparison, number(late)));
        tell(stores[1], nth, compare(number(16777217), comparison, age));
        tell(stores[1], nth + 6, compare(age, comparison, number(2147483648.5)));
        tell(stores[2], nth, compare(birth, comparison, number(2147483649)));
        tell(stores[2], nth + 6, compare(birth, comparison, age));
        tell(stores[3], nth, compare(row, comparison, quantity(Quantity::column)));
        tell(stores[3], nth + 6, compare(quantity(Quantity::neighbours), comparison, number(4.5)));
    }
    tell(stores[0], 7, Within{iteration, number(late_from), number(late_from + 2)});
    tell(stores[1], 13, Within{age, birth, number(4294967294)});
    tell(stores[2], 13, Within{number(16777217), birth, quantity(Quantity::random)});
    tell(stores[3], 13, compare(quantity(Quantity::rows), Comparison::less, quantity(Quantity::columns)));
    return lab.done();
}

void whole_numbers_touch(Snapshot& state) {
    constexpr std::uint32_t ages[] = {0, 16777215, 2147483646, 4294967000u, 2147483570, 70000};
    state.iteration = far_iteration;
    for (std::size_t cell = 0; cell < state.cells(); ++cell) {
        const auto away = static_cast<std::uint32_t>(cell % 5);
        state.birth[cell] = static_cast<std::uint32_t>(far_iteration) - ages[cell % 6] - away;
        state.neighbours[cell] = static_cast<std::int32_t>(cell % 6);
    }
}

void quantities_touch(Snapshot& state) {
    state.iteration = 13;
    for (std::size_t cell = 0; cell < state.cells(); ++cell) {
        state.birth[cell] = 13 - static_cast<std::uint32_t>(cell * 7 % 13);
        state.neighbours[cell] = static_cast<std::int32_t>(cell % 6);
        state.fixed[cell] = cell % 3 == 0 ? 1 : 0;
        state.mappings[0][cell] = static_cast<double>(cell % 11) * 0.125;
    }
}

Experiment draws(Lab lab, std::int64_t seed) {
    const auto a = lab.chemical("A", {4, 1}, {0.2, 0}, unbounded);
    const auto b = lab.chemical("B", {2, 1}, {0.1, 0}, unbounded);
    const auto c = lab.chemical("C", {2, 1}, {0.1, 0.05}, unbounded);
    const Operand any = quantity(Quantity::random);
    // What the first cell draws in the sixth iteration: not less, but equal.
    const double drawn = unit_uniform<double>(counted_words(0, 5, 0, purpose::condition, seed)[0]);
    lab.rule(change(a, number(0.005), 0.5), Probability{number(drawn)});
    lab.rule(change(b, any, 0.125), Within{any, number(0.25), any});
    React reaction = react(model_named("linear"), {a, b}, {0.8, -0.9, 0.4, 0.3, 0.9, 1.1, -0.2, -0.6, 0.5, 0.8});
    for (std::size_t i : {0u, 2u, 3u, 6u}) reaction.parameters[i] = any;
    reaction.scale = any;
    lab.rule(reaction, compare(any, Comparison::less_equal, any));
    lab.rule(change_rate(c, number(-0.001), 0.01), Probability{any});
    lab.rule(set_conc(c, any), Probability{number(0.03)});
    return lab.seed(seed).done();
}

// Chains of conditions, some of which are asleep now and then.
Experiment chains(Lab lab) {
    const auto a = lab.chemical("A", {4, 2}, {0.2, 0}, unbounded);
    const auto b = lab.chemical("B", {4, 2}, {0.1, 0}, unbounded);
    const auto c = lab.chemical("C", {4, 2}, {0.0, 0}, unbounded);
    lab.rule(And{}, compare(conc(a), Comparison::greater, number(3.5)));
    lab.rule(And{}, compare(conc(b), Comparison::less, number(4.5)));
    lab.rule(change(a, number(0.0625)), Within{conc(c), number(2.5), number(5)});
    lab.rule(And{}, compare(conc(a), Comparison::not_equal, conc(b))).until = 40;
    lab.rule(change(b, number(-0.03125)), compare(conc(c), Comparison::greater_equal, number(3)));
    lab.rule(And{}, compare(conc(a), Comparison::less_equal, conc(b)));
    lab.rule(change(b, number(5))).from = 1000;
    lab.rule(change(c, conc(a)), compare(conc(c), Comparison::equal, conc(c)));
    lab.rule(And{}, Probability{number(0.5)}).from = 20;
    lab.rule(And{}, Probability{number(0.5)});
    lab.rule(set_conc(b, conc(c)));
    lab.rule(And{});
    return lab.done();
}

Experiment sets(Lab lab) {
    const auto a = lab.chemical("A", {4, 2}, {0.2, 0}, {3, 5});
    const auto b = lab.chemical("B", {4, 2}, {0.1, 0.1}, unbounded);
    const auto m = lab.mapping("M");
    const auto n = lab.mapping("N");
    lab.rule(Map{conc(a), 3.5, 4.5, m, 5, 2});
    lab.rule(Map{quantity(Quantity::mapping, m), 3, 4, n, 0, 0.25});
    lab.rule(Map{quantity(Quantity::mapping, n), 1, 0.0625, n, 0.125, 0.5}).every = 3;
    lab.rule(set_conc(a, conc(b)), compare(conc(b), Comparison::greater, number(4.5)));
    lab.rule(set_conc(a, quantity(Quantity::mapping, m)), compare(conc(b), Comparison::greater, number(5.5)));
    lab.rule(set_rate(b, quantity(Quantity::mapping, n)), compare(conc(a), Comparison::greater, number(4)));
    lab.rule(set_rate(b, number(-1)), compare(conc(a), Comparison::greater, number(4.75))).every = 4;
    lab.rule(change_rate(b, number(-0.0078125)));
    lab.rule(change(b, number(0.015625)));
    return lab.done();
}

// More sets of active rules than programs are compiled for.
Experiment restless(Lab lab) {
    const auto a = lab.chemical("A", {4, 2}, {0.2, 0}, unbounded);
    const auto b = lab.chemical("B", {4, 2}, {0.1, 0}, unbounded);
    for (std::size_t i = 0; i < 6; ++i) {
        if (i % 2 == 0) lab.rule(And{}, compare(conc(a), Comparison::greater, number(3.75))).every = i + 2;
        Rule& rule = lab.rule(change(i % 3 == 0 ? a : b, number(0.01 * static_cast<double>(i + 1)), 0.02));
        rule.every = i + 2;
        rule.offset = i;
        rule.from = 3 * i;
        rule.until = 90 - i;
    }
    lab.rule(react(model_named("turing"), {a, b}, {16, 12}, 0.25)).until = 70;
    lab.rule(change(a, number(1))).from = (std::uint64_t{1} << 32) + 5;  // never: no iteration has 33 bits
    return lab.time_step(0.02).done();
}

Experiment phased(Lab lab) {
    const auto a = lab.chemical("A", {4, 2}, {0.2, 0}, {0, 5.5});
    const auto b = lab.chemical("B", {4, 2}, {0.1, 0.05}, {3, 5});
    const auto c = lab.chemical("C", {4, 2}, {0, 0}, unbounded);
    lab.rule(react(model_named("turing"), {a, b}, {16, 12}));
    lab.rule(change(c, number(0.01), 0.01)).until = 29;
    Phase& second = lab.phase(30);
    second.time_step = 0.02;
    second.bounds[a].limit = 4.5;
    second.rates[a] = 0.4;
    second.rates[b] = 0.05;
    Phase& third = lab.phase(61);
    third.bounds[b] = unbounded;
    third.rates[c] = 0.3;
    Rule& late = lab.rule(change(b, number(0.001), 0.001));
    late.from = late.origin = 61;
    late.every = 5;
    late.offset = 2;
    return lab.done();
}

Expand expansion(std::size_t columns, std::size_t rows, Distribution distribution) {
    Expand growth;
    growth.columns = columns;
    growth.rows = rows;
    growth.distribution = distribution;
    return growth;
}

// Fields of every kind, so that each must follow the growth.
Experiment growing(Lab lab, Expand first, Expand second) {
    const auto a = lab.chemical("A", {4, 1}, {0.4, 0}, {0, 5.5});
    const auto b = lab.chemical("B", {4, 1}, {0.1, 0}, {0, 4.75});
    const auto c = lab.chemical("C", {4, 1}, {0.1, 0.05}, unbounded, true);
    const auto d = lab.chemical("D", {1, 1}, {0, 0}, unbounded);
    const auto m = lab.mapping("M");
    lab.polarity(45, 90);
    lab.rule(react(model_named("turing"), {a, b}, {16, 12}));
    lab.rule(Map{conc(b), 3, 5, m, 0, 1}).every = 2;
    lab.rule(change(d, quantity(Quantity::neighbours)));
    lab.rule(change(d, quantity(Quantity::age)),
             compare(quantity(Quantity::x), Comparison::less, quantity(Quantity::y)));
    lab.rule(change(d, quantity(Quantity::mapping, m)));
    lab.rule(change(c, number(0.01), 0.01), compare(quantity(Quantity::row), Comparison::equal, number(3)));
    Rule& grow = lab.rule(first);
    grow.every = 3;
    grow.offset = 1;
    Rule& more = lab.rule(second);
    more.from = 7;
    more.every = 5;
    return lab.done();
}

// Nothing but concentrations lies on the device.
Experiment growing_plain(Lab lab, Expand growth) {
    const auto a = lab.chemical("A", {4, 1}, {0.4, 0}, {0, 5.5});
    const auto b = lab.chemical("B", {4, 1}, {0.1, 0}, {0, 4.75});
    lab.polarity(45, 90);
    lab.rule(react(model_named("turing"), {a, b}, {16, 12}));
    lab.rule(growth).every = 2;
    return lab.done();
}

void growing_touch(Snapshot& state) {
    state.iteration = 9;
    for (std::size_t cell = 0; cell < state.cells(); ++cell) {
        state.birth[cell] = 9 - static_cast<std::uint32_t>(cell % 9);
        state.neighbours[cell] = static_cast<std::int32_t>(cell % 6);
        state.fixed[cell] = cell % 4 == 0 ? 1 : 0;
    }
}

}  // namespace

std::vector<Case> rule_cases() {
    const auto fused = [](auto make) {
        return [make](Size size) { return make(Lab::matrix(size.columns, size.rows, Boundary::wrap)); };
    };
    const auto published = [](auto make) {
        return [make](Size size) { return make(Lab::grid(size.columns, size.rows, false)); };
    };
    const auto drawn = [](std::int64_t seed) { return [seed](Lab lab) { return draws(std::move(lab), seed); }; };
    const std::vector<Size> sizes{{3, 2}, {20, 9}, {67, 31}};
    return {
        {"rules/quantities/fused", fused(quantities), sizes, 40, quantities_touch, false, true},
        {"rules/quantities/published", published(quantities), sizes, 40, quantities_touch, false, true},
        {"rules/whole-numbers/fused", fused(whole_numbers), sizes, 40, whole_numbers_touch},
        {"rules/whole-numbers/published", published(whole_numbers), sizes, 40, whole_numbers_touch},
        {"rules/draws/fused", fused(drawn(-987654321987654321)), sizes, 60, {}},
        {"rules/draws/published", published(drawn(7)), sizes, 60, {}},
        {"rules/chains/fused", fused(chains), sizes, 60, {}},
        {"rules/chains/published", published(chains), sizes, 60, {}},
        {"rules/sets/fused", fused(sets), sizes, 60, {}, false, true},
        {"rules/sets/published", published(sets), sizes, 60, {}, false, true},
        {"rules/restless", fused(restless), sizes, 100, {}},
        {"rules/phases/fused", fused(phased), sizes, 100, {}},
        {"rules/phases/published", published(phased), sizes, 100, {}},
    };
}

std::vector<Case> growth_cases() {
    const std::vector<Size> sizes{{1, 1}, {4, 3}, {15, 14}, {31, 6}};
    Expand weighted = expansion(2, 1, Distribution::uniform);
    weighted.rows_first = true;
    weighted.band_weight = 0.5;
    weighted.band_low = 0.25;
    weighted.band_high = 0.5;
    const Expand shuffled = expansion(0, 3, Distribution::shuffled);
    const Expand normal = expansion(1, 1, Distribution::normal);
    const Expand triangular = expansion(3, 0, Distribution::triangular);
    const auto stretched = [](std::size_t columns, std::size_t rows, Interpolation interpolation) {
        Expand growth = expansion(columns, rows, Distribution::uniform);
        growth.interpolation = interpolation;
        return growth;
    };
    const std::vector<Size> few{{1, 1}, {5, 3}, {31, 7}};
    const Expand nearest = stretched(2, 1, Interpolation::nearest);
    const Expand bilinear = stretched(1, 3, Interpolation::bilinear);
    const Expand bicubic = stretched(3, 1, Interpolation::bicubic);
    const auto grown = [](Boundary boundary, Expand first, Expand second) {
        return [=](Size size) { return growing(plain(size, boundary), first, second); };
    };
    const auto simple = [](Boundary boundary, Expand first) {
        return [=](Size size) { return growing_plain(plain(size, boundary), first); };
    };
    return {
        {"growth/wrap", grown(Boundary::wrap, weighted, shuffled), sizes, 24, growing_touch, true},
        {"growth/no-flux", grown(Boundary::no_flux, normal, triangular), sizes, 24, growing_touch, true},
        {"growth/absorbing", grown(Boundary::absorbing, triangular, weighted), sizes, 24, growing_touch, true},
        {"growth/plain/no-flux", simple(Boundary::no_flux, weighted), sizes, 30, growing_touch, true},
        {"growth/plain/absorbing", simple(Boundary::absorbing, triangular), sizes, 30, growing_touch, true},
        {"growth/by/wrap", grown(Boundary::wrap, bicubic, weighted), few, 12, growing_touch, true},
        {"growth/by/no-flux", grown(Boundary::no_flux, bilinear, nearest), few, 12, growing_touch, true},
        {"growth/by/absorbing", grown(Boundary::absorbing, nearest, bicubic), few, 12, growing_touch, true},
        {"growth/by/plain", simple(Boundary::wrap, bicubic), few, 12, growing_touch, true},
    };
}

}  // namespace pelage::verify
