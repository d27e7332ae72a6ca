// See check.hpp.
#include "verify/check.hpp"

#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/device/subnormal.hpp"
#include "reference/backend.hpp"
#include "verify/seed.hpp"

#include <fmt/format.h>

#include <exception>

namespace pelage::verify {

namespace {

constexpr cl_uint turns_wanted = 70'000;

const char* const loop_kernel = R"(
kernel void pelage_count_turns(global volatile uint* turns, const uint most) {
    uint done = 0;
    for (uint i = 0; i < most; ++i) {
        turns[1] = i;  // kept by the compiler: the loop must be run
        done += 1;
    }
    turns[0] = done;
}
)";

}  // namespace

std::string Setting::text() const {
    std::string text;
    const auto put = [&](const std::string& part) { text += text.empty() ? part : ", " + part; };
    if (precision == Precision::double_) put("double");
    if (path != Path::step) put(word(path));
    if (work_group != 0) put(fmt::format("work-group {}", work_group));
    if (search == NeighbourSearch::spatial_sorting) put("spatial sorting");
    if (width != 0) put(fmt::format("width {}", width));
    if (!guarded) put("again, unguarded");
    return text;
}

Place::Place(DeviceInfo device, std::uint64_t seed, bool full, bool small)
    : device_(std::move(device)), seed_(seed), full_(full), small_(small) {}

Experiment Place::seeded(Experiment experiment) const {
    if (seed_ != usual_seed) experiment.seed = static_cast<std::int64_t>(seed_);
    return experiment;
}

OpenclBackend& Place::backend(const Setting& setting) {
    auto& backend = backends_[setting];
    if (!backend) {
        OpenclOptions options;
        options.device = std::to_string(device_.index);
        options.guarded = setting.guarded;
        options.precision = setting.precision;
        options.path = setting.path;
        options.work_group = setting.work_group;
        options.width = setting.width;
        options.variants = setting.variants;
        options.cut = {setting.depth, setting.columns, setting.rows, setting.group};
        options.neighbours = setting.search;
        backend = opencl_backend(options);
    }
    return *backend;
}

const Session& Place::session(Precision precision) {
    auto& session = sessions_[precision];
    if (!session) {
        OpenclOptions options;
        options.guarded = true;
        options.precision = precision;
        session = std::make_unique<Session>(device_, options);
    }
    return *session;
}

std::uint64_t Place::loop_limit() {
    if (loop_limit_) return *loop_limit_;
    const Session& on = session();
    const cl_uint turns = with_device(device_.name, [&] {
        cl::Kernel kernel(on.build(loop_kernel), "pelage_count_turns");
        const cl::Buffer result = on.buffer(2 * sizeof(cl_uint), "turns of a loop");
        kernel.setArg(0, result);
        kernel.setArg(1, turns_wanted);
        on.launch(kernel, cl::NDRange(1), cl::NDRange(1));
        cl_uint found = 0;
        on.queue().enqueueReadBuffer(result, CL_TRUE, 0, sizeof found, &found);
        return found;
    });
    loop_limit_ = turns == turns_wanted ? 0 : turns;
    return *loop_limit_;
}

const std::string& Place::subnormal_difference() {
    if (!subnormal_difference_) subnormal_difference_ = pelage::subnormal_difference(session());
    return *subnormal_difference_;
}

const char* word(Verdict verdict) {
    switch (verdict) {
        case Verdict::passed:
            return "passed";
        case Verdict::failed:
            return "failed";
        case Verdict::mistrusted:
            return "mistrusted";
        case Verdict::skipped:
            return "skipped";
    }
    return "?";
}

void conclude(Outcome& outcome) {
    if (!outcome.tally.equal()) outcome.verdict = Verdict::failed;
}

Outcome beside_the_reference(Place& place, const Experiment& experiment, std::span<const Setting> settings,
                             std::span<const std::uint64_t> stretches) {
    const Snapshot initial = initial_state(experiment, Precision::single_);
    const auto expected = reference_backend(Precision::single_)->make_tissue(experiment, initial);
    std::vector<std::unique_ptr<Tissue>> found;
    for (const Setting& setting : settings) found.push_back(place.backend(setting).make_tissue(experiment, initial));
    Outcome outcome;
    for (const std::uint64_t steps : stretches) {
        expected->advance(steps);
        const Snapshot there = expected->read();
        for (std::size_t i = 0; i < settings.size(); ++i) {
            found[i]->advance(steps);
            const std::string where = settings[i].text() + (settings[i].text().empty() ? "" : ", ");
            add(outcome.tally, there, found[i]->read(), Precision::single_,
                fmt::format("{}iteration {}", where, there.iteration));
        }
    }
    conclude(outcome);
    return outcome;
}

std::vector<std::size_t> telling_counts(const Place& place) {
    if (place.small()) return {1, 17, 65};
    return {1, 2, 7, 15, 16, 17, 63, 64, 65, 257, 1021, 5003};
}

std::vector<Check> all_checks(std::uint64_t seed, bool full) {
    std::vector<Check> checks = primitive_checks(seed);
    for (auto part : {function_checks(), neighbour_checks(seed), order_checks(), gather_checks(seed), lattice_checks(),
                      batch_checks(), alike_checks(), law_checks(seed), cell_checks(), aggregate_checks(),
                      term_checks(), learn_checks(), mesh_checks(), checkpoint_checks(), array_checks(full),
                      finite_checks(), course_checks(), reading_checks(), random_checks(seed)}) {
        checks.insert(checks.end(), std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()));
    }
    if (!full) std::erase_if(checks, [](const Check& check) { return !check.quick; });
    return checks;
}

Outcome carry_out(const Check& check, Place& place) {
    try {
        return check.run(place);
    } catch (const std::exception& error) {
        Outcome outcome;
        outcome.verdict = Verdict::failed;
        outcome.message = error.what();
        outcome.broken_off = true;
        return outcome;
    }
}

}  // namespace pelage::verify
