// Runs cases of the table on the reference and on the selected OpenCL device, and compares.
#pragma once

#include "core/prepattern.hpp"
#include "opencl/backend.hpp"
#include "reference/backend.hpp"
#include "support/form.hpp"
#include "verify/cases.hpp"
#include "verify/compare.hpp"

#include <fmt/ranges.h>
#include <catch2/catch.hpp>

#include <memory>

namespace test {

using namespace pelage::verify;

inline pelage::Snapshot first_state(const Case& one, const pelage::Experiment& experiment) {
    pelage::Snapshot state = pelage::initial_state(experiment);
    if (one.touch) one.touch(state);
    return state;
}

inline void require_equal(const pelage::Snapshot& expected, const pelage::Snapshot& found) {
    const std::vector<std::string> lines = differences(expected, found);
    INFO("iteration " << expected.iteration << ": " << fmt::format("{}", fmt::join(lines, "\n  ")));
    REQUIRE(lines.empty());
}

// Every size of the case, where they are many a third of them but in the long form: equal after 1 and after all
// iterations, after each one where the lattice grows.
inline void check_case(const Case& one, pelage::OpenclBackend& device) {
    const auto reference = pelage::reference_backend(device.precision());
    const std::size_t of = test::long_form() || one.sizes.size() < 9 ? 1 : 3;  // each third of many
    for (std::size_t i = (one.sizes.size() - 1) % of; i < one.sizes.size(); i += of) {
        const Size size = one.sizes[i];
        INFO("case " << one.name << ", " << size.text());
        const pelage::Experiment experiment = one.experiment(size);
        const pelage::Snapshot before = first_state(one, experiment);
        const auto expected = reference->make_tissue(experiment, before);
        const auto found = device.make_tissue(experiment, before);
        require_equal(expected->read(), found->read());
        for (std::uint64_t done = 0; done < one.iterations;) {
            const std::uint64_t count = done == 0 || one.grows ? 1 : one.iterations - done;
            expected->advance(count);
            found->advance(count);
            require_equal(expected->read(), found->read());
            done += count;
        }
        if (size.cells() < 200) continue;  // few cells soon are all the same
        const std::vector<std::string> doubts = mistrusted(before, expected->read());
        INFO((doubts.empty() ? "" : doubts.front()));
        REQUIRE(doubts.empty());
    }
}

// One in `of` cases, counted from case `first`.
struct Share {
    std::size_t first = 0;
    std::size_t of = 1;
};

// Cases whose name begins with `prefix`, or a share of them.
inline void check_cases(const std::string& prefix, pelage::OpenclOptions options, Share share = {}) {
    const auto device = pelage::opencl_backend(options);
    std::size_t named = 0;
    std::size_t checked = 0;
    for (const Case& one : lattice_cases()) {
        if (!one.name.starts_with(prefix) || named++ % share.of != share.first) continue;
        check_case(one, *device);
        ++checked;
    }
    REQUIRE(checked > 0);
}

}  // namespace test
