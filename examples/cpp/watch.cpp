// Looks into a tissue while it runs: how far the concentrations of U lie apart, every 200 iterations.
#include <pelage/pelage.hpp>

#include <algorithm>
#include <cstdio>

namespace {

const char* const text = R"(
define chemical U limit 10
define chemical V limit 10
define time_step 0.01
use seed 5
use chemical U conc 4 dev 0.01 diff 10
use chemical V conc 4 dev 0.01 diff 2
create matrix 40 40 wrap
rule always react U V turing alpha 16 beta 12
)";

}  // namespace

int main() {
    try {
        const auto backend = pelage::reference_backend(pelage::Precision::double_);
        const auto tissue = backend->make_tissue(pelage::parse_experiment(text, "watch", "."));
        for (int turn = 0; turn < 10; ++turn) {
            tissue->advance(200);
            const pelage::Snapshot now = tissue->read();
            const auto [low, high] = std::ranges::minmax_element(now.conc[0]);
            std::printf("iteration %llu: U from %.3f to %.3f\n", static_cast<unsigned long long>(now.iteration), *low,
                        *high);
        }
        return 0;
    } catch (const pelage::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
