// See every_call.hpp.
#include "every_call.hpp"

#include "codes.hpp"
#include "opencl/device/cl_error.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

namespace test {

std::vector<Call> calls_of_a_good_run(Stage& stage) {
    Faults& layer = Faults::layer();
    for (int i = 0; i < 2; ++i) {  // the first one fills the cache
        layer.reset();
        const Ending ending = stage.run();
        INFO(ending.error);
        REQUIRE(ending.finished);
    }
    REQUIRE(layer.unbalanced().empty());
    stage.keep_as_good();
    return layer.calls();
}

void check_nothing_broken(const Stage& stage, const Ending& ending) {
    if (ending.finished) CHECK(names_in(stage.results()).size() == stage.good().size());
    for (const std::string& text : stage.damage()) FAIL_CHECK(text);
    for (const std::string& text : Faults::layer().unbalanced()) FAIL_CHECK(text);
}

bool check_failing_call(Stage& stage, std::size_t nth, cl_int code) {
    Faults& layer = Faults::layer();
    layer.reset();
    layer.fail(nth, code);
    const Ending ending = stage.run();
    const bool struck = layer.struck() == 1;
    const std::string name = struck ? layer.calls()[nth].name : "none";

    INFO(fmt::format("call {}, {}, fails with {}: {}", nth, name, pelage::cl_error_name(code), ending.error));
    if (!ending.finished) CHECK(tells(ending.error, name, code));
    check_nothing_broken(stage, ending);
    return struck;
}

}  // namespace test
