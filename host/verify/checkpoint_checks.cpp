// See check.hpp: a run that goes on from a checkpoint file gives the bits of one that never stopped.
#include "core/prepattern.hpp"
#include "io/checkpoint.hpp"
#include "verify/cases.hpp"
#include "verify/check.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

namespace pelage::verify {

namespace {

class ScratchFile {
public:
    ScratchFile() : path_(std::filesystem::temp_directory_path() / fmt::format("pelage-verify-{}.state", getpid())) {}
    ~ScratchFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

Outcome resumes(Place& place, const std::string& name) {
    Outcome outcome;
    const Experiment experiment = lattice_case(name).experiment({21, 17});
    OpenclBackend& backend = place.backend({});
    const auto straight = backend.make_tissue(experiment);
    const std::uint64_t before = place.small() ? 4 : 11;
    const std::uint64_t after = place.small() ? 3 : 13;
    straight->advance(before);
    const ScratchFile file;
    CheckpointInfo info;
    info.experiment = name;
    info.device = place.device().name;
    write_checkpoint(file.path(), straight->read(), info);
    straight->advance(after);
    const auto resumed = backend.make_tissue(experiment, read_checkpoint(file.path()).snapshot);
    resumed->advance(after);
    add(outcome.tally, straight->read(), resumed->read(), Precision::single_,
        fmt::format("{} iterations after the checkpoint", after));
    if (!outcome.tally.equal()) outcome.verdict = Verdict::failed;
    return outcome;
}

}  // namespace

std::vector<Check> checkpoint_checks() {
    std::vector<Check> checks;
    for (const char* name : {"growth/plain/no-flux", "rules/draws/fused", "rates/polarized/moore/wrap"}) {
        checks.push_back({std::string("checkpoint/") + name, "checkpoints", checks.size() < 2,
                          [=](Place& place) { return resumes(place, name); }});
    }
    return checks;
}

}  // namespace pelage::verify
