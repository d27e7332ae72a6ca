// From a text in Pelage's language to a picture: spots of Turing's reaction, in final.png of the folder that is named.
#include <pelage/pelage.hpp>

#include <cstdio>

namespace {

const char* const text = R"(
define chemical U limit 10
define chemical V limit 10
define time_step 0.01
use seed 7
use chemical U conc 4 dev 0.5 diff 10
use chemical V conc 4 dev 0.5 diff 2
create matrix 64 64 wrap
rule always react U V turing alpha 16 beta 12
output U colormap heat
stop at 3000
)";

}  // namespace

int main(int argc, char** argv) {
    const char* folder = argc > 1 ? argv[1] : "out";
    try {
        const pelage::Experiment experiment = pelage::parse_experiment(text, "spots", ".");
        const auto backend = pelage::opencl_backend();
        const auto tissue = backend->make_tissue(experiment);
        tissue->advance(experiment.last_iteration());
        pelage::ResultOptions options;
        options.formats = {pelage::Format::png};
        for (const std::string& name :
             pelage::write_results(folder, "final", tissue->read(), tissue->experiment(), options)) {
            std::printf("%s/%s, made on %s\n", folder, name.c_str(), backend->name().c_str());
        }
        return 0;
    } catch (const pelage::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
