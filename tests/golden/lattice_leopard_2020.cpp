// The 2020 notebooks' own results ("The leopard never changes its spots") against the double reference.
#include "lattice_notebook.hpp"
#include "support/shared.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <random>

namespace {

using namespace pelage;
using test::Growth;
using test::Notebook;
using test::Order;

constexpr double no_limit = std::numeric_limits<double>::infinity();

// numpy's RandomState(1).random_sample, added to the middle row of b before each iteration.
class NoisyRow {
public:
    void skip(std::size_t numbers) { words_.discard(2 * numbers); }

    void advance(Tissue& tissue, std::uint64_t iteration) {
        while (tissue.iteration() < iteration) {
            Snapshot state = tissue.read();
            for (std::size_t column = 0; column < state.columns; ++column) {
                state.conc[1][65 * state.columns + column] += 0.01 * uniform();
            }
            tissue.write(state);
            tissue.advance(1);
        }
    }

private:
    double uniform() {
        const auto high = static_cast<double>(words_() >> 5);
        const auto low = static_cast<double>(words_() >> 6);
        return (high * 67108864.0 + low) / 9007199254740992.0;
    }

    std::mt19937 words_{1};
};

}  // namespace

TEST_CASE("the notebooks' examples of reaction and diffusion") {
    if (test::shared_missing("golden/leopard_2020/base_rd")) return;
    const Notebook notebook("base_rd");
    for (const std::string part : {"ex1", "ex2", "ex3", "ex4", "ex5", "ex6"}) {
        const NpyArray a = notebook.array(part + ".a0");
        const auto tissue = test::start(notebook.turing(part, a.shape), {a, notebook.array(part + ".b0")});
        notebook.check_steps(*tissue, part, {1, 10, 100});
        notebook.check_end(*tissue, part);
    }
}

TEST_CASE("the notebooks' examples of reinforcement") {
    if (test::shared_missing("golden/leopard_2020/base_re")) return;
    const Notebook notebook("base_re");
    for (const std::string part : {"ex1", "ex2", "ex3", "ex4", "ex5", "ex6", "ex7"}) {
        const NpyArray c = notebook.array(part + ".c0");
        const auto tissue = test::start(notebook.reinforcement(part, c.shape), {c});
        notebook.check_steps(*tissue, part, {1, 10, 100});
        notebook.check_end(*tissue, part);
    }
}

TEST_CASE("the notebooks' frog, growing") {
    if (test::shared_missing("golden/leopard_2020/frog")) return;
    const Notebook notebook("frog");
    const NpyArray a = notebook.array("p1.a0");
    const auto still = test::start(notebook.turing("p1", a.shape), {a, notebook.array("p1.b0")});
    notebook.check_steps(*still, "p1", {1, 10, 100});
    notebook.check_end(*still, "p1");

    const NpyArray end = notebook.array("p1.a_end");
    const auto tissue = test::start(notebook.turing("p2", end.shape), {end, notebook.array("p1.b_end")});
    Growth growth(notebook.array("p2.picks"), Order::column_first, 200);
    growth.check_steps(notebook, *tissue, "p2", {1, 10, 100, 200, 201, 1000});
    growth.advance(*tissue, notebook.steps("p2"));
    notebook.check(*tissue, "p2", "_end", 1e-3);
    CHECK(growth.used_up());
}

TEST_CASE("the notebooks' reticulate whipray, growing") {
    if (test::shared_missing("golden/leopard_2020/whip")) return;
    const Notebook notebook("whip");
    const NpyArray a = notebook.array("ret_p1.a0");
    const auto still = test::start(notebook.turing("ret_p1", a.shape), {a, notebook.array("ret_p1.b0")});
    notebook.check_steps(*still, "ret_p1", {1, 10, 100});

    const NpyArray end = notebook.array("ret_p1.a_end");
    const auto tissue = test::start(notebook.turing("ret_p2", end.shape), {end, notebook.array("ret_p1.b_end")});
    Growth growth(notebook.array("ret_p2.picks"), Order::column_first, 100);
    growth.check_steps(notebook, *tissue, "ret_p2", {1, 10, 100, 1000});
}

TEST_CASE("the notebooks' comparison of growing models") {
    if (test::shared_missing("golden/leopard_2020/comparison")) return;
    const Notebook notebook("comparison");
    const NpyArray a0 = notebook.array("ref.a0");
    const auto still = test::start(notebook.turing("ref", a0.shape), {a0, notebook.array("ref.b0")});
    notebook.check_steps(*still, "ref", {1, 10, 100});

    const NpyArray a = notebook.array("ref.a_end");
    const NpyArray b = notebook.array("ref.b_end");
    for (const std::string part : {"rd", "sat"}) {
        const auto tissue = test::start(notebook.turing(part, a.shape), {a, b});
        Growth growth(notebook.array(part + ".picks"), Order::column_first, 50);
        growth.check_steps(notebook, *tissue, part, {1, 10, 50, 100, 500});
    }
    const auto tissue = test::start(notebook.reinforcement("rein", b.shape), {b});
    Growth growth(notebook.array("rein.picks"), Order::row_first, 50);
    growth.check_steps(notebook, *tissue, "rein", {1, 10, 50, 100, 500});
}

TEST_CASE("the notebooks' growth without diffusion only moves elements") {
    if (test::shared_missing("golden/leopard_2020/comparison")) return;
    const NpyArray b = test::golden("leopard_2020/comparison/ref.b_end");
    const Experiment still = test::matrix(b.shape[1], b.shape[0], Boundary::wrap, Stencil::nine_point, 1.0,
                                          {{"b", 0.0, {-no_limit, no_limit}}});
    const auto tissue = test::start(still, {b});
    Growth growth(test::golden("leopard_2020/comparison/nodiff.picks"), Order::column_first, 50);
    for (const std::uint64_t steps : {50u, 500u, 5000u}) {
        growth.advance(*tissue, steps);
        const NpyArray wanted = test::golden("leopard_2020/comparison/nodiff.b" + std::to_string(steps));
        const test::Difference difference = test::difference(tissue->read().conc[0], wanted.values);
        CHECK(difference.range > 0.0);
        CHECK(difference.unequal == 0);
    }
    CHECK(growth.used_up());
}

TEST_CASE("the notebooks' leopard: definition of its spots") {
    if (test::shared_missing("golden/leopard_2020/leopard")) return;
    const Notebook notebook("leopard");
    const NpyArray a0 = notebook.array("p1a.a0");
    NoisyRow noise;
    noise.skip(130 * 130);  // drawn for an initial b that is then replaced
    const auto first = test::start(notebook.turing("p1a", a0.shape), {a0, notebook.array("p1a.b0")});
    noise.skip(130);  // already in b0
    first->advance(1);
    notebook.check(*first, "p1a", "1", 1e-12);
    noise.advance(*first, 10);
    notebook.check(*first, "p1a", "10", 1e-11);
    noise.advance(*first, 100);
    notebook.check(*first, "p1a", "100", 1e-9);
    noise.advance(*first, 1000);
    notebook.check(*first, "p1a", "1000", 1e-9);

    const NpyArray end = notebook.array("p1a.a_end");
    const auto second = test::start(notebook.turing("p1b", end.shape), {end, notebook.array("p1a.b_end")});
    NoisyRow again;  // the stream starts anew with each part
    for (const std::uint64_t steps : {1u, 10u, 100u}) {
        again.advance(*second, steps);
        notebook.check(*second, "p1b", std::to_string(steps), test::tolerance(steps));
    }
}

TEST_CASE("the notebooks' leopard: growth and maintenance") {
    if (test::shared_missing("golden/leopard_2020/leopard")) return;
    const Notebook notebook("leopard");
    const NpyArray a = notebook.array("p1b.a_end");
    const NpyArray b = notebook.array("p1b.b_end");
    const auto spots = test::start(notebook.turing("p2ab", a.shape), {a, b});
    Growth growth(notebook.array("p2ab.picks"), Order::row_first, 50);
    growth.check_steps(notebook, *spots, "p2ab", {1, 10, 100, 1000});

    const auto base = test::start(notebook.reinforcement("p2c", b.shape), {b});
    Growth same_growth(notebook.array("p2c.picks"), Order::row_first, 50);
    same_growth.check_steps(notebook, *base, "p2c", {1, 10, 100, 1000});
}

TEST_CASE("the notebooks' leopard: maintenance between two growths") {
    if (test::shared_missing("golden/leopard_2020/leopard")) return;
    const Notebook notebook("leopard");
    for (const std::string part : {"p3base", "p3spot"}) {
        const NpyArray c = notebook.array(part + ".c0");  // after the first growth; kept in float
        const auto tissue = test::start(notebook.reinforcement(part, c.shape), {c});
        for (const std::uint64_t at : {1u, 10u, 100u}) {
            tissue->advance(at - tissue->iteration());
            notebook.check(*tissue, part, std::to_string(at), 1e-6);
        }
    }
}
