// See check.hpp: what a device can do, random numbers, sort and scan.
#include "core/philox.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/device/program.hpp"
#include "opencl/device/subnormal.hpp"
#include "verify/check.hpp"
#include "verify/sorting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>

namespace pelage::verify {

namespace {

using Words = std::vector<std::uint32_t>;

// --- random numbers

const char* const draw_kernel = R"(
kernel void pelage_draw(global const uint* in, global uint* words, global scalar* units) {
    const size_t i = get_global_id(0);
    global const uint* c = in + 6 * i;
    const struct pelage_words w =
        pelage_philox4x32_10((uintv)(c[0]), (uintv)(c[1]), (uintv)(c[2]), (uintv)(c[3]), c[4], c[5]);
    words[4 * i] = w.x; words[4 * i + 1] = w.y; words[4 * i + 2] = w.z; words[4 * i + 3] = w.w;
    units[i] = UNIT(w.x);
}
)";

struct Draws {
    Words words;
    std::vector<float> units;
};

Draws draw_on_device(const Session& on, const Words& inputs) {
    return with_device(on.info().name, [&] {
        Source source;
        source.file("common/prelude.cl").file("rules/philox.cl").text(draw_kernel);
        cl::Kernel kernel(on.build(source.str()), "pelage_draw");
        const std::size_t count = inputs.size() / 6;
        const cl::Buffer in = on.buffer(inputs.size() * 4, "counters");
        const cl::Buffer words = on.buffer(count * 16, "random words");
        const cl::Buffer units = on.buffer(count * 4, "random numbers");
        on.queue().enqueueWriteBuffer(in, CL_TRUE, 0, inputs.size() * 4, inputs.data());
        kernel.setArg(0, in);
        kernel.setArg(1, words);
        kernel.setArg(2, units);
        on.launch(kernel, cl::NDRange(count), cl::NDRange(1));
        Draws draws{Words(4 * count), std::vector<float>(count)};
        on.queue().enqueueReadBuffer(words, CL_TRUE, 0, 16 * count, draws.words.data());
        on.queue().enqueueReadBuffer(units, CL_TRUE, 0, 4 * count, draws.units.data());
        return draws;
    });
}

// Salmon, Moraes, Dror & Shaw (2011), known answers of Philox4x32-10.
Outcome known_answers(Place& place) {
    const Words inputs{0,          0,          0,          0,          0,          0,
                       0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff,
                       0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344, 0xa4093822, 0x299f31d0};
    const Words answers{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8, 0x408f276d, 0x41c83b0e,
                        0xa20bc7c6, 0x6d5451fd, 0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1};
    Outcome outcome;
    add(outcome.tally, answers, draw_on_device(place.session(), inputs).words, "words");
    conclude(outcome);
    return outcome;
}

Outcome many_draws(Place& place, std::uint64_t seed) {
    Words inputs;
    Draws expected;
    std::mt19937_64 engine(seed);
    for (int i = 0; i < (place.small() ? 50 : 5000); ++i) {
        std::array<std::uint32_t, 6> in{};
        for (std::uint32_t& word : in) word = static_cast<std::uint32_t>(engine());
        const auto words = philox4x32_10({in[0], in[1], in[2], in[3]}, {in[4], in[5]});
        inputs.insert(inputs.end(), in.begin(), in.end());
        expected.words.insert(expected.words.end(), words.begin(), words.end());
        expected.units.push_back(unit_uniform<float>(words[0]));
    }
    const Draws found = draw_on_device(place.session(), inputs);
    Outcome outcome;
    add(outcome.tally, expected.words, found.words, "words");
    add(outcome.tally, expected.units, found.units, "numbers of [0, 1)");
    conclude(outcome);
    return outcome;
}

// --- sort and scan

struct Keys {
    Words keys;
    std::uint32_t end = 1;  // all keys are smaller
};

std::vector<Keys> key_sets(Place& place, std::uint64_t seed) {
    std::mt19937_64 engine(seed);
    std::vector<Keys> sets;
    for (const std::size_t count : telling_counts(place)) {
        for (const std::uint32_t end : {1u, 16u, 3000u}) {
            if (place.small() && end > 100) continue;
            if (!place.full() && count % 16 == 15) continue;  // as one more than a group, nearly
            Keys set{Words(count), end};
            for (std::uint32_t& key : set.keys) key = static_cast<std::uint32_t>(engine() % end);
            sets.push_back(set);
        }
    }
    Keys backwards{Words(1000), 1000};
    std::iota(backwards.keys.rbegin(), backwards.keys.rend(), 0u);
    if (!place.small()) sets.push_back(backwards);
    // More keys than 16 bits count.
    Keys scattered{Words(2000), 100'000};
    for (std::uint32_t& key : scattered.keys) key = static_cast<std::uint32_t>(engine() % scattered.end);
    if (!place.small() && place.loop_limit() == 0) sets.push_back(scattered);
    // More in a chunk than 16 bits count.
    if (!place.small() && place.loop_limit() == 0) sets.push_back({Words(140'001, 0), 16});
    return sets;
}

std::vector<SortShape> sort_shapes() { return {{1, 0}, {2, 0}, {7, 0}, {100, 4}, {13, 8}}; }

Outcome check_sort(Place& place, std::uint64_t seed) {
    Outcome outcome;
    DeviceSort sort(place.session());
    for (const Keys& set : key_sets(place, seed)) {
        Words expected(set.keys.size());
        std::iota(expected.begin(), expected.end(), 0u);
        std::ranges::stable_sort(expected, {}, [&](std::uint32_t i) { return set.keys[i]; });
        for (const SortShape& shape : sort_shapes()) {
            const std::string where = fmt::format("order of {} keys below {}, {} chunks, {} bits", set.keys.size(),
                                                  set.end, shape.chunks, shape.bits);
            for (int time = 0; time < (place.small() ? 1 : 2); ++time) {
                add(outcome.tally, expected, sort.order(set.keys, set.end, shape).order, where);
            }
        }
    }
    conclude(outcome);
    return outcome;
}

Outcome check_scan(Place& place, std::uint64_t seed) {
    Outcome outcome;
    DeviceSort sort(place.session());
    for (const Keys& set : key_sets(place, seed)) {
        Words counts(set.end, 0);
        for (const std::uint32_t key : set.keys) ++counts[key];
        Words expected(set.end + 1, 0);
        std::inclusive_scan(counts.begin(), counts.end(), expected.begin() + 1);
        for (const SortShape& shape : sort_shapes()) {
            const std::string where = fmt::format("starts of {} keys below {}, {} chunks, {} bits", set.keys.size(),
                                                  set.end, shape.chunks, shape.bits);
            add(outcome.tally, expected, sort.order(set.keys, set.end, shape).starts, where);
        }
    }
    conclude(outcome);
    return outcome;
}

// Bins of 0 to 40 points, in every order but the right one.
Outcome check_tidy(Place& place, std::uint64_t seed) {
    std::mt19937 engine(static_cast<std::mt19937::result_type>(seed));
    Words starts{0}, order(place.small() ? 30 : 820), expected;
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::shuffle(order, engine);
    expected = order;
    for (std::uint32_t bin = 0; starts.back() < order.size(); ++bin) {
        const auto begin = starts.back();
        starts.push_back(std::min(begin + bin, static_cast<std::uint32_t>(order.size())));
        std::ranges::sort(expected.begin() + begin, expected.begin() + starts.back());
        if (bin % 3 == 0) std::ranges::sort(order.begin() + begin, order.begin() + starts.back(), std::greater());
    }
    Outcome outcome;
    add(outcome.tally, expected, tidied_on_device(place.session(), starts, order), "points of bins");
    conclude(outcome);
    return outcome;
}

// --- the device

// A loop of one work-item that is longer than 16 bits count. Where a device ends it early, what needs such loops is
// left out, by name.
Outcome long_loop(Place& place) {
    Outcome outcome;
    const std::uint64_t limit = place.loop_limit();
    outcome.tally.cells_compared = 1;
    if (limit != 0) {
        outcome.verdict = Verdict::skipped;
        outcome.message = fmt::format(
            "the device ends loops silently after {} turns of a work-item: no kernel here may "
            "take more there, and cases that would are left out",
            limit);
    }
    return outcome;
}

// Subnormal numbers are 0, in and out. Where a device keeps them, cases that are full of them are left out, by name.
Outcome subnormal_numbers(Place& place) {
    Outcome outcome;
    outcome.tally.cells_compared = 1;
    if (outcome.message = subnormal_fault(place.session()); !outcome.message.empty()) {
        outcome.verdict = Verdict::failed;
        return outcome;
    }
    outcome.message = place.subnormal_difference();
    if (!outcome.message.empty()) outcome.verdict = Verdict::skipped;
    return outcome;
}

}  // namespace

std::vector<Check> primitive_checks(std::uint64_t seed) {
    return {{"device/long-loop", "long loops", true, long_loop},
            {"device/subnormal", "subnormal numbers", true, subnormal_numbers},
            {"random/known-answers", "random numbers", true, known_answers},
            {"random/many", "random numbers", true, [=](Place& place) { return many_draws(place, seed); }},
            {"sort/keys", "sort", true, [=](Place& place) { return check_sort(place, seed); }},
            {"scan/starts", "scan", true, [=](Place& place) { return check_scan(place, seed); }},
            {"sort/tickets", "sort", true, [=](Place& place) { return check_tidy(place, seed); }}};
}

}  // namespace pelage::verify
