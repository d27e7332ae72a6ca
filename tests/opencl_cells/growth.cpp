// Growth runs on the device against the float reference: the same cells, the same bits.
#include "support/free_cells.hpp"

#include <catch2/catch.hpp>

using namespace pelage;

namespace {

// Two cells that become thousands.
const char* const growing_sheet = R"(
define chemical U limit 4.5
define chemical V
define division_limit 9
define domain 300 260
define time_step 0.1
use seed 5
use chemical U conc 4 dev 1 diff 0.40
use chemical V conc 4 dev 1 diff 0.02
create cell 0 0
create cell 1.5 0.5
rule always react U V scale 0.05 turing alpha 16 beta 12
rule probability 0.06 divide direction 0 dev 180
)";

}  // namespace

TEST_CASE("two cells grow into thousands, bit for bit") {
    const auto experiment = test::experiment(growing_sheet);
    const auto expected = test::on_reference(experiment);
    const auto found = test::on_device(experiment);

    test::check_equal_runs(*expected, *found, 600, 50);

    CHECK(found->cells() > 2000);
}
