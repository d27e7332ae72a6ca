// Parts of the command that can be judged without running it.
#include "app/finite_guard.hpp"
#include "app/interrupt.hpp"
#include "app/memory.hpp"
#include "app/progress.hpp"
#include "app/run_options.hpp"
#include "app/tile_batches.hpp"
#include "app/timetable.hpp"
#include "language/parse.hpp"
#include "reference/backend.hpp"
#include "texts.hpp"

#include <catch2/catch.hpp>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <string>

using namespace pelage::app;

TEST_CASE("numbers are shown as people read them") {
    CHECK(grouped(0) == "0");
    CHECK(grouped(999) == "999");
    CHECK(grouped(242000) == "242,000");
    CHECK(grouped(1234567890) == "1,234,567,890");
    CHECK(counted(1, "cell") == "1 cell");
    CHECK(counted(2000, "cell") == "2,000 cells");
    CHECK(counted(0, "cell lies", "cells lie") == "0 cells lie");
    CHECK(clock_time(0) == "0:00");
    CHECK(clock_time(41.2) == "0:42");
    CHECK(clock_time(3599.5) == "1:00:00");
    CHECK(clock_time(INFINITY) == "?");
    CHECK(megas(0) == "0");
    CHECK(megas(812.4e6) == "812");
    CHECK(megas(27.31e6) == "27.3");
    CHECK(megas(5.24e6) == "5.2");
    CHECK(readable_bytes(512) == "512 B");
    CHECK(readable_bytes(1.5 * 1024 * 1024 * 1024) == "1.5 GiB");
}

TEST_CASE("a line of progress holds phase, iterations, percent, time left and speed, and fits the terminal") {
    const std::string log = progress_line("growth", 60500, 242000, 41.2, 812e6, 0);
    const std::string bar = progress_line("growth", 60500, 242000, 41.2, 812e6, 100);

    CHECK(log == "growth  60,500/242,000  25%  ETA 0:42  812 M updates/s");
    CHECK(bar.find("[#######") != std::string::npos);
    CHECK(bar.find("25%") != std::string::npos);
    for (const std::size_t width : {1u, 20u, 40u, 60u, 80u, 200u}) {
        CHECK(progress_line("growth", 60500, 242000, 41.2, 812e6, width).size() < width);
    }
    CHECK(progress_line("", 0, 0, 0, 0, 0).find("100%") != std::string::npos);
    const auto end_of_bar = [](const std::string& line) { return line.find(']'); };
    CHECK(end_of_bar(progress_line("growth", 5, 242000, INFINITY, 1e9, 100)) == end_of_bar(bar));
    CHECK(end_of_bar(progress_line("growth", 242000, 242000, 40000, 8.2e6, 100)) == end_of_bar(bar));
}

TEST_CASE("a run stops at every snapshot, at every checkpoint and at its end, and nowhere else") {
    const Timetable times{100, {5, 33, 500}, 25, 40};
    std::vector<std::uint64_t> stops;

    for (std::uint64_t at = 0; at < times.last; at = times.next_stop(at)) stops.push_back(times.next_stop(at));

    CHECK(stops == std::vector<std::uint64_t>{5, 25, 33, 40, 50, 75, 80, 100});
    CHECK(times.snapshot_at(0));
    CHECK(times.snapshot_at(33));
    CHECK_FALSE(times.snapshot_at(40));
    CHECK(times.checkpoint_at(40));
    CHECK_FALSE(times.checkpoint_at(0));
    CHECK_FALSE(Timetable{100, {}, 0, 0}.snapshot_at(0));
}

TEST_CASE("batches find the length that takes their time, from slow and from fast beginnings") {
    const double speed = GENERATE(2.0, 300.0, 1e6);  // iterations a second
    BatchSize size;
    size.took(1, 3.0, 1.0);  // the first batch compiles kernels

    for (int i = 0; i < 20; ++i) size.took(size.iterations(), static_cast<double>(size.iterations()) / speed, 1.0);

    const double seconds = static_cast<double>(size.iterations()) / speed;
    CHECK((size.iterations() == 1 || seconds > BatchSize::target / 2));
    CHECK((size.iterations() == 1 || seconds < BatchSize::target * 2));
}

TEST_CASE("the printed command is quoted for the shell") {
    RunOptions options;
    options.file = "it's here.pex";
    options.backend = "opencl";
    options.precision = pelage::Precision::double_;
    options.iterations = 500;
    options.snap_every = 10;
    options.fast = true;

    CHECK(shell_quoted("a b") == "'a b'");
    CHECK(shell_quoted("") == "''");
    CHECK(shell_quoted("$HOME") == "'$HOME'");
    CHECK(shell_quoted("out/a-1.pex") == "out/a-1.pex");
    CHECK(resume_command(options, "out/c.pelage", 40, -3) ==
          "pelage run 'it'\\''s here.pex' --backend opencl --precision double --iterations 500 --seed -3 "
          "--out 'out/it'\\''s here' --snap-every 10 --fast --resume out/c.pelage");

    options.video.file = "films/it's.new.mp4";
    options.video.of = "V";
    options.video.size = "64x48";
    CHECK_THAT(resume_command(options, "out/c.pelage", 40, -3),
               Catch::Contains(" --video 'films/it'\\''s.new-40.mp4' --video-of V --size 64x48 --fast"));
}

TEST_CASE("where a run goes on for seconds after Ctrl-C a line tells of the second one") {
    std::array<int, 2> ends{};
    REQUIRE(pipe(ends.data()) == 0);
    const int own = dup(STDERR_FILENO);
    {
        const Interrupt interrupt;
        raise(SIGINT);
        CHECK(Interrupt::came());
        CHECK(alarm(0) > 0);  // it would come
        dup2(ends[1], STDERR_FILENO);
        raise(SIGALRM);
        dup2(own, STDERR_FILENO);
        alarm(100);
    }
    CHECK(alarm(0) == 0);
    std::array<char, 200> text{};
    const auto count = read(ends[0], text.data(), text.size());
    CHECK_THAT(std::string(text.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))),
               Catch::Contains("Ctrl-C again ends at once"));
    for (const int one : {ends[0], ends[1], own}) close(one);
}

TEST_CASE("the memory a run needs counts its growth") {
    const std::string growing =
        "define chemical U\ncreate matrix 10 10\n"
        "rule from 5 every 10 always expand columns 2 rows 1\nstop at 100\n";
    const pelage::Experiment experiment = pelage::parse_experiment(growing, "growing", ".");

    const Footprint early = footprint(experiment, 10, pelage::Precision::single_, false);
    const Footprint late = footprint(experiment, 100, pelage::Precision::single_, false);
    const Footprint twice = footprint(experiment, 100, pelage::Precision::double_, false);

    CHECK(early.cells == 10 * 10);  // acts at 10, 20, ... 90: the period counts from 0
    CHECK(late.cells == (10 + 9 * 2) * (10 + 9));
    CHECK(twice.device > late.device);
    CHECK(late.reference > late.device);
    const double enough = late.states() + late.reference;
    CHECK_NOTHROW(check_host_memory(experiment, late, Worked::by_reference, enough));
    CHECK_NOTHROW(check_host_memory(experiment, late, Worked::on_a_card, late.states() + compiler_bytes));
    CHECK_THROWS_WITH(check_host_memory(experiment, late, Worked::in_main_memory, late.states()),
                      Catch::Contains("532 cells") && Catch::Contains("bytes a cell"));
    CHECK_THROWS_WITH(check_host_memory(experiment, late, Worked::by_reference, enough / 2),
                      Catch::Contains("532 cells"));
    CHECK(why_not_on_device(late, late.device).empty());
    CHECK_THAT(why_not_on_device(late, late.device / 2), Catch::Contains("on the device"));
}

TEST_CASE("tiles of a batch fill a card, leave some to the other threads, and end soon enough") {
    pelage::app::Footprint tile;
    tile.cells = 64 * 64;
    tile.a_snapshot = 100;
    constexpr double plenty = 1e12;
    CHECK(tiles_a_batch(tile, 5000, 100'000, 8, plenty) == (1 << 20) / (64 * 64));
    CHECK(tiles_a_batch(tile, 5000, 192, 8, plenty) == 24);
    CHECK(tiles_a_batch(tile, 5000, 190, 8, plenty) == 24);
    CHECK(tiles_a_batch(tile, 5000, 3, 8, plenty) == 1);
    CHECK(tiles_a_batch(tile, 24'000'000, 100'000, 8, plenty) == 10);
    CHECK(tiles_a_batch(tile, 4'000'000'000, 100'000, 8, plenty) == 1);
    CHECK(tiles_a_batch(tile, 0, 100'000, 1, plenty) == 256);
    CHECK(tiles_a_batch(tile, 5000, 100'000, 1, 100 * 4 * 4 * 4096 * 10) == 10);
    CHECK(tiles_a_batch(tile, 5000, 100'000, 1, 1) == 1);
}

TEST_CASE("the guard finds the very iteration however long the batch was") {
    const pelage::Experiment experiment = pelage::parse_experiment(test::doubling, "doubling", ".");
    const auto tissue = pelage::reference_backend(pelage::Precision::single_)->make_tissue(experiment);
    const std::uint64_t before = GENERATE(0u, 1u, 100u, 127u);
    const std::uint64_t batch = GENERATE(129u, 200u, 1000u);
    FiniteGuard guard(*tissue);
    REQUIRE_FALSE(guard.look());
    tissue->advance(before);
    REQUIRE_FALSE(guard.look());

    tissue->advance(batch);
    const auto breakdown = guard.look();

    REQUIRE(breakdown);
    CHECK(breakdown->iteration == 128);
    CHECK(breakdown->finite_after == 127);
    CHECK(breakdown->where.cell == 10);
    CHECK(tissue->iteration() == 128);
    CHECK(describe(*breakdown, *tissue) ==
          "chemical 'U' became inf in iteration 128, first in cell 10 (row 2, column 0)");
}
