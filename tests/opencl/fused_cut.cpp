// How lattices are cut for streamed steps.
#include "opencl/lattice/fused_cut.hpp"

#include <catch2/catch.hpp>

using namespace pelage;

namespace {

DeviceInfo processor_of(std::uint32_t units) {
    DeviceInfo device;
    device.type = "cpu";
    device.compute_units = units;
    return device;
}

FusedShape shape() {
    FusedShape made;
    made.depth = 16;
    made.rows = 4;
    made.vectors = 26;
    made.together = true;
    return made;
}

constexpr std::size_t width = 16;

}  // namespace

TEST_CASE("streamed cut: strips that share passes cover all rows and are no lower than a margin") {
    bool shared = false;
    for (const std::uint32_t units : {1u, 2u, 3u, 8u, 16u, 32u, 48u, 64u}) {
        for (std::size_t rows = 1; rows < 700; rows += 3) {
            for (const std::uint64_t count : {1u, 5u, 16u, 1000u}) {
                CAPTURE(units, rows, count);
                const FusedLaunch launch = stream_launch(processor_of(units), Grid{400, rows}, shape(), width, count);
                REQUIRE(launch.margin == 0);
                REQUIRE(launch.bands == 1);
                REQUIRE(launch.vectors * width >= 400);
                REQUIRE(launch.strips * launch.strip >= rows);
                REQUIRE((launch.strips - 1) * launch.strip < rows);
                REQUIRE(launch.steps * launch.passes <= count);
                if (!launch.together) continue;
                REQUIRE(rows - (launch.strips - 1) * launch.strip >= launch.steps);
                shared = true;
            }
        }
    }
    REQUIRE(shared);
}

TEST_CASE("streamed cut: bands with margins cover all columns, in equal shares for the threads") {
    for (const std::uint32_t units : {1u, 2u, 4u, 16u}) {
        for (std::size_t columns = 417; columns < 9000; columns += 61) {
            CAPTURE(units, columns);
            const FusedLaunch launch = stream_launch(processor_of(units), Grid{columns, 4096}, shape(), width, 16);
            REQUIRE(launch.margin == launch.steps);
            REQUIRE(launch.passes == 1);
            REQUIRE(launch.vectors <= shape().vectors);
            REQUIRE(launch.bands * (launch.vectors * width - 2 * launch.margin) >= columns);
        }
        const FusedLaunch whole = stream_launch(processor_of(units), Grid{4096, 4096}, shape(), width, 16);
        REQUIRE(whole.bands * whole.strips % units == 0);
    }
}
