// See contest.hpp.
#include "bench/contest.hpp"

#include "bench/openmp.hpp"
#include "bench/points.hpp"
#include "bench/tissue_tasks.hpp"
#include "core/error.hpp"
#include "core/prepattern.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage::bench {

namespace {

// What the reference does in a second or less; beyond, it takes part only where it is asked for by name.
constexpr double patience_lattice = 1.2e6, patience_cells = 1.2e5, patience_points = 1.2e6;
constexpr double patience_whole_lattice = 1e8, patience_whole_cells = 1e7, patience_particles = 2'000;

class Maker {
public:
    Maker(const Options& options, const Case& one, std::size_t size, const std::vector<DeviceSessions>& devices)
        : options_(options), case_(one), size_(size), devices_(devices) {
        contest_.cells = one.cells(size);
        const std::size_t whole = one.particles ? size : one.whole;
        contest_.whole = options.quick ? std::min<std::size_t>(whole, 120) : whole;
        contest_.stretch = contest_.whole != 0 ? contest_.whole : one.text ? 37 : 1;
        contest_.updates = static_cast<double>(contest_.cells);
    }

    Contest made() {
        if (case_.text) {
            add_tissues();
        } else {
            add_searches();
        }
        add_probes();
        return std::move(contest_);
    }

private:
    using Make = std::function<std::unique_ptr<Task>()>;

    void add(const std::string& backend, const std::string& device, const std::string& why_not, const Make& make,
             bool exact = true) {
        if (!options_.wants(backend)) return;
        if (why_not.empty()) {
            const bool in_memory = std::ranges::any_of(devices_, [&](const DeviceSessions& one) {
                return one.plain->info().name == device && one.plain->info().type == "cpu";
            });
            const bool threads = backend == "openmp" || backend == "nanoflann-openmp";
            contest_.contenders.push_back({backend, device, exact, threads, in_memory, make});
        } else {
            contest_.absent.push_back({case_.suite, case_.name, size_, backend, device, why_not, false});
        }
    }

    bool named(const std::string& backend) const {
        return std::ranges::find(options_.against, backend) != options_.against.end();
    }

    std::string too_long(double work, double patience) const {
        if (work <= patience || named("reference")) return {};
        return "too long for one plain thread; name it with --against to have it all the same";
    }

    void add_tissues() {
        const auto experiment = std::make_shared<const Experiment>(experiment_of(case_, size_));
        const auto initial = std::make_shared<const Snapshot>(initial_state(*experiment));
        contest_.initial = outcome_of(*initial);
        contest_.cells = initial->cells();
        contest_.updates = static_cast<double>(contest_.cells);
        const bool lattice = initial->on_grid();
        constexpr double usual_flops = 300;
        double work = contest_.updates * std::max(1.0, case_.flops / usual_flops);
        if (case_.particles) {
            contest_.updates = work = static_cast<double>(contest_.whole);
        } else if (contest_.whole != 0) {
            contest_.updates = count_updates(devices_.front().standard, *experiment, *initial, contest_.whole);
            work = contest_.updates;
        }
        const double patience = case_.particles       ? patience_particles
                                : contest_.whole == 0 ? (lattice ? patience_lattice : patience_cells)
                                                      : (lattice ? patience_whole_lattice : patience_whole_cells);
        add("reference", processor_name(), too_long(work, patience),
            [=] { return reference_task(*experiment, initial); });
        const std::optional<Kernel> kernel = case_.kernel;
        const bool particles = case_.particles, volume = case_.suite == "volume", mesh = case_.suite == "mesh",
                   neural = case_.suite == "neural";
        add("openmp", processor_name(), why_no_openmp(case_), [=] {
            if (particles) return openmp_aggregate(*experiment, *initial);
            if (volume) return openmp_volume(*experiment, *initial);
            if (mesh) return openmp_mesh(*experiment, *initial);
            if (neural) return openmp_network(*experiment, *initial);
            return kernel ? openmp_lattice(*kernel, *experiment, *initial) : openmp_cells(*experiment, *initial);
        });
        for (const DeviceSessions& device : devices_) {
            const std::string name = device.standard->info().name;
            const auto on = [&](const std::shared_ptr<const Session>& session) {
                return [=] { return opencl_task(session, *experiment, initial); };
            };
            const std::string same = case_.far_field ? "a far field has one kernel"
                                     : lattice       ? ""
                                     : mesh          ? "meshes have one kernel"
                                                     : "free cells have one kernel";
            if (lattice || named("opencl-plain")) add("opencl-plain", name, same, on(device.plain));
            if (lattice || named("opencl-step")) add("opencl-step", name, same, on(device.step));
            add("opencl", name, "", on(device.standard));
            add("opencl-fast", name, "", on(device.fast), false);
            if (case_.twin) add_twin(device);
        }
    }

    // The twin as `pelage run` would carry it out.
    void add_twin(const DeviceSessions& device) {
        const auto experiment = std::make_shared<const Experiment>(twin_of(case_, size_));
        const auto initial = std::make_shared<const Snapshot>(initial_state(*experiment));
        const std::size_t before = contest_.contenders.size();
        add(
            "opencl-twin", device.standard->info().name, "",
            [=, session = device.standard] { return opencl_task(session, *experiment, initial); }, false);
        if (contest_.contenders.size() > before) contest_.contenders.back().twin = true;
    }

    void add_searches() {
        const auto points = std::make_shared<const Points>(make_points(size_, case_.shuffled));
        add("reference", processor_name(), too_long(contest_.updates, patience_points),
            [=] { return reference_search(*points); });
        add("nanoflann", processor_name(), "", [=] { return nanoflann_search(*points, false); });
        add("nanoflann-openmp", processor_name(), why_no_openmp(case_),
            [=] { return nanoflann_search(*points, true); });
        for (const DeviceSessions& device : devices_) {
            const auto session = device.standard;
            add("opencl", session->info().name, "", [=] { return opencl_search(session, *points); });
        }
    }

    void add_probes() {
        const auto bytes = static_cast<std::size_t>(case_.bytes / 2 * static_cast<double>(contest_.cells));
        contest_.probes.push_back({"copy", processor_name(), true, true, false, [=] { return host_copy(bytes); }});
        for (const DeviceSessions& device : devices_) {
            const auto session = device.plain;
            contest_.probes.push_back(
                {"copy", session->info().name, true, false, false, [=] { return device_copy(session, bytes); }});
        }
    }

    const Options& options_;
    const Case& case_;
    std::size_t size_;
    const std::vector<DeviceSessions>& devices_;
    Contest contest_;
};

DeviceSessions open_device(const DeviceInfo& info) {
    OpenclOptions plain, step, fast;
    plain.path = step.path = Path::step;
    plain.width = 1;
    fast.fast = true;
    return {std::make_shared<const Session>(info, plain), std::make_shared<const Session>(info, step),
            std::make_shared<const Session>(info, OpenclOptions{}), std::make_shared<const Session>(info, fast)};
}

}  // namespace

std::vector<DeviceSessions> open_devices(const std::string& wanted) {
    std::vector<DeviceSessions> open;
    if (wanted != "all") {
        open.push_back(open_device(select_device(wanted.empty() ? std::nullopt : std::optional(wanted))));
        return open;
    }
    for (const DeviceInfo& info : list_devices()) {
        if (info.unusable.empty()) open.push_back(open_device(info));
    }
    if (open.empty()) throw Error("there is no usable OpenCL device; `pelage devices` says why");
    return open;
}

Contest make_contest(const Options& options, const Case& one, std::size_t size,
                     const std::vector<DeviceSessions>& devices) {
    return Maker(options, one, size, devices).made();
}

}  // namespace pelage::bench
