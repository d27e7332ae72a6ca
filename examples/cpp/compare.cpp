// The same experiment on the plain C++ reference and on an OpenCL device: do they give the same bits?
#include <pelage/pelage.hpp>

#include <cstdio>

namespace {

pelage::Snapshot grown_on(pelage::Backend& backend, const pelage::Experiment& experiment) {
    const auto tissue = backend.make_tissue(experiment);
    tissue->advance(500);
    return tissue->read();
}

const char* const text = R"(
define chemical U limit 1
define chemical V limit 1
use seed 3
use chemical U conc 1 diff 0.16
use chemical V conc 0.1 dev 0.1 diff 0.08
create matrix 50 40 no-flux
rule always react U V gray-scott f 0.04 k 0.06
)";

}  // namespace

int main() {
    try {
        const pelage::Experiment experiment = pelage::parse_experiment(text, "compare", ".");
        const auto reference = pelage::reference_backend(pelage::Precision::single_);
        const auto device = pelage::opencl_backend();
        const bool equal = grown_on(*reference, experiment).conc == grown_on(*device, experiment).conc;
        std::printf("%s and %s: %s\n", reference->name().c_str(), device->name().c_str(),
                    equal ? "the same bits" : "different");
        return equal ? 0 : 1;
    } catch (const pelage::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
