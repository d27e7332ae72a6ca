// How lattices are carried out: the path, the cut and the reason, on devices that need not be there.
#include "opencl/lattice/choice.hpp"

#include "core/error.hpp"
#include "opencl/lattice/explain.hpp"
#include "opencl/lattice/step.hpp"

#include <catch2/catch.hpp>

using namespace pelage;
using Catch::Matchers::Contains;

namespace {

DeviceInfo processor(std::uint32_t threads) {
    DeviceInfo device = usual_processor();
    device.compute_units = threads;
    device.processors = threads;
    return device;
}

DeviceInfo graphics(std::uint64_t local_memory) {
    DeviceInfo device;
    device.name = "made-up";
    device.type = "gpu";
    device.compute_units = 100;
    device.max_work_group = 1024;
    device.local_memory = local_memory;
    device.own_local_memory = true;
    return device;
}

DeviceInfo without_local_memory() {
    DeviceInfo device = graphics(32 * 1024);
    device.own_local_memory = false;
    return device;
}

// Whatever type rusticl gives it.
DeviceInfo rasteriser(const char* type) {
    DeviceInfo device = graphics(64 * 1024);
    device.type = type;
    device.name = "llvmpipe (LLVM 15.0.6, 512 bits)";
    return device;
}

RuleNeeds two_fields() {
    RuleNeeds needs;
    needs.fields.all = 2;
    return needs;
}

RuleNeeds needs(bool RuleNeeds::*what) {
    RuleNeeds made = two_fields();
    made.*what = true;
    return made;
}

// A run of so many cell-updates, half of them done.
Work work(double side, double updates) { return {side * side, 16, updates / 2, updates / 2, false}; }

OpenclOptions asked(Path path) {
    OpenclOptions options;
    options.path = path;
    return options;
}

Path path_of(const DeviceInfo& device, const Work& work, const RuleNeeds& needs = two_fields()) {
    return choose(device, needs, work, {}).path;
}

}  // namespace

TEST_CASE("choice: each kind of device has its path") {
    struct Row {
        DeviceInfo device;
        Work work;
        Path path;
    };
    const std::vector<Row> rows{
        {processor(2), work(100, 1e12), Path::shared},      // too few cells
        {processor(2), work(256, 1e8), Path::shared},       // over too soon
        {processor(2), work(256, 9e9), Path::shared},       // in caches
        {processor(2), work(256, 1.1e10), Path::streamed},  // in caches, and long
        {processor(2), work(1024, 3e9), Path::shared},          {processor(2), work(1024, 5e9), Path::streamed},
        {processor(64), work(1024, 5e9), Path::shared},  // more threads, more caches
        {processor(64), work(1024, 1.1e10), Path::streamed},    {processor(64), work(4096, 5e9), Path::streamed},
        {graphics(48 * 1024), work(16, 1e3), Path::tiled},      {graphics(48 * 1024), work(4096, 1e12), Path::tiled},
        {without_local_memory(), work(4096, 1e12), Path::step}, {rasteriser("gpu"), work(1024, 1e12), Path::step},
        {rasteriser("cpu"), work(1024, 1e12), Path::step}};
    for (const Row& row : rows) {
        CAPTURE(row.device.type, row.device.compute_units, row.work.cells, row.work.done);
        CHECK(path_of(row.device, row.work) == row.path);
    }
}

TEST_CASE(
    "choice: tiles are small where there would be too few large ones, and shallow where arithmetic sets the pace") {
    const auto cut = [](double side, const RuleNeeds& needs) {
        return choose(graphics(48 * 1024), needs, work(side, 1e12), {}).cut;
    };
    const FusedShape small = cut(390, two_fields());
    CHECK(small.vectors == 20 + 2 * 6);
    CHECK(small.rows == 20);
    CHECK(small.group == 128);
    const FusedShape large = cut(4096, two_fields());
    CHECK(large.vectors == 52 + 2 * 6);
    CHECK(large.rows == 32);
    CHECK(large.group == 256);
    CHECK(cut(4096, needs(&RuleNeeds::draws)).depth == 4);
}

TEST_CASE("choice: a batch is tiled where a lattice is, else stepped, whatever is asked for") {
    const auto chosen = [](const DeviceInfo& device, const RuleNeeds& needs, double side, Path asked) {
        OpenclOptions options;
        options.path = asked;
        const Choice choice = choose_for_batch(device, needs, work(side, 1e12), options);
        CHECK(choice.cut.batch);
        return choice;
    };
    for (const Path asked : {Path::automatic, Path::step, Path::streamed, Path::shared, Path::tiled}) {
        CAPTURE(word(asked));
        const bool tiles = asked == Path::tiled;
        CHECK(chosen(processor(2), two_fields(), 1024, asked).path == (tiles ? Path::tiled : Path::step));
        CHECK(chosen(processor(2), needs(&RuleNeeds::wide), 1024, asked).path == Path::step);
        const bool on_a_card = tiles || asked == Path::automatic;
        CHECK(chosen(graphics(48 * 1024), two_fields(), 64, asked).path == (on_a_card ? Path::tiled : Path::step));
        CHECK(chosen(without_local_memory(), needs(&RuleNeeds::wide), 64, asked).path == Path::step);
    }
    // What counts is how many cells all lattices have together.
    CHECK(chosen(graphics(48 * 1024), two_fields(), 64, Path::automatic).cut.rows == 20);
    CHECK(chosen(graphics(48 * 1024), two_fields(), 64 * 16, Path::automatic).cut.rows == 32);
}

TEST_CASE("choice: in a batch on a processor a work-item has a lattice, for so long as the host may wait") {
    const Grid grid{64, 64};
    CHECK(batch_shape(grid, 5000, 1).steps == 8'000'000 / 4096);
    CHECK(batch_shape(grid, 5000, 10).steps == 800'000 / 4096);
    CHECK(batch_shape(grid, 7, 1).steps == 7);
    CHECK(batch_shape({4000, 4000}, 7, 1).steps == 1);
    const LaunchShape shape = batch_shape(grid, 5000, 1);
    CHECK(shape.across * shape.bands * shape.work_group == 1);
    CHECK(shape.band == 64);
}

TEST_CASE("choice: a processor streams only what pays, and says why not") {
    const auto why = [](const Work& work, const RuleNeeds& needs = two_fields()) {
        const Choice choice = choose(processor(2), needs, work, {});
        CHECK(choice.path == Path::shared);
        return choice.text();
    };
    const std::string begins = "shared, each thread steps a strip of rows; not streamed: ";
    CHECK(why(work(100, 1e12)) == begins + "a lattice of so few cells would gain nothing");
    CHECK(why(work(256, 1e9)) == begins + "caches hold the lattice, streaming would gain too little");
    CHECK(why(work(1024, 1e9)) == begins + "too little work lies ahead to pay for the compilation");
    CHECK(why({1e6, 16, 1e8, 1e10, false}) == begins + "the run has only begun");
    const Work much = work(1024, 1e12);
    CHECK(why(much, needs(&RuleNeeds::draws)) == begins + "random draws, not memory, set its pace");
    CHECK(why(much, needs(&RuleNeeds::polarizes)) ==
          begins + "polarities that follow gradients, not memory, set its pace");
    CHECK(why(much, needs(&RuleNeeds::uneven_rates)) ==
          begins + "diffusion rates that differ between cells, not memory, set its pace");
}

TEST_CASE("choice: past the last iteration, what has been done stands for what is to come") {
    CHECK(path_of(processor(2), {1e6, 16, 3e9, {}, false}) == Path::streamed);
    CHECK(path_of(processor(2), {1e6, 16, 1e9, {}, false}) == Path::shared);
}

TEST_CASE("choice: what streams goes on to stream, however little lies ahead") {
    Work end = work(1024, 1e12);
    end.ahead = 1e6;
    CHECK(path_of(processor(2), end) == Path::shared);
    end.compiled = true;
    CHECK(path_of(processor(2), end) == Path::streamed);
    end.cells = 1000;
    CHECK(path_of(processor(2), end) == Path::shared);
}

TEST_CASE("choice: what is asked for is done where it can be") {
    const Work small = work(16, 1e3);
    for (const Path path : {Path::step, Path::streamed, Path::shared, Path::tiled}) {
        CHECK(choose(processor(2), two_fields(), small, asked(path)).path == path);
    }
    CHECK(choose(graphics(48 * 1024), two_fields(), small, asked(Path::shared)).path == Path::step);
    OpenclOptions groups = asked(Path::shared);
    groups.work_group = 3;
    CHECK(choose(processor(2), two_fields(), small, groups).path == Path::step);
    CHECK(choose(processor(2), two_fields(), small, asked(Path::step)).text() ==
          "step, one launch an iteration; as asked for");
}

TEST_CASE("choice: a cut fits the device's local memory") {
    const FusedShape roomy = choose(graphics(48 * 1024), two_fields(), {}, {}).cut;
    CHECK(roomy.depth == 6);
    CHECK(roomy.group == 128);
    const auto bytes = [](const FusedShape& shape, std::size_t fields) {
        return 4 * (2 * (shape.rows + 2 * shape.depth) * fields * shape.vectors + 32);
    };
    RuleNeeds many = two_fields();
    for (const std::size_t kilobytes : {1u, 4u, 16u, 48u, 227u}) {
        for (many.fields.all = 1; many.fields.all < 12; ++many.fields.all) {
            CAPTURE(kilobytes, many.fields.all);
            const Choice choice = choose(graphics(kilobytes * 1024), many, {}, {});
            if (choice.path == Path::tiled) CHECK(bytes(choice.cut, many.fields.all) <= kilobytes * 1024);
        }
    }
}

TEST_CASE("choice: where not even the smallest cut fits, an automatic run goes on in single steps") {
    const Choice choice = choose(graphics(100), two_fields(), work(1024, 1e12), {});
    CHECK(choice.path == Path::step);
    CHECK(choice.cut.group == 64);
    CHECK_THAT(choice.text(), Contains("bytes of local memory; device 'made-up' has 100"));
    CHECK_THROWS_AS(choose(graphics(100), two_fields(), {}, asked(Path::tiled)), Error);
}

TEST_CASE("choice: work-items handle vectors on processors and cells elsewhere") {
    CHECK(choose(processor(2), two_fields(), {}, {}).width == 16);
    CHECK(choose(graphics(48 * 1024), two_fields(), {}, {}).width == 1);
    OpenclOptions twice;
    twice.precision = Precision::double_;
    CHECK(choose(processor(2), two_fields(), {}, twice).width == 8);
    twice.width = 4;
    CHECK(choose(processor(2), two_fields(), {}, twice).width == 4);
}
