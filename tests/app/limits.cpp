// Limits on what the command may take of the machine, and signals that its user has chosen to ignore.
#include "support/process.hpp"
#include "support/sanitizers.hpp"
#include "texts.hpp"

#include "app/commands.hpp"
#include "app/last_will.hpp"
#include "core/allowance.hpp"
#include "opencl/device/device.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <catch2/catch.hpp>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <string>

using Catch::Contains;
using test::Child;
using test::Folder;
using test::Outcome;
using test::program;
using test::shell;

namespace {

test::Surroundings within(std::chrono::seconds patience) {
    test::Surroundings surroundings;
    surroundings.patience = patience;
    return surroundings;
}

// What a child process makes of that work: its exit code.
template <class Work>
int exit_code_of(Work work) {
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        work();
        _exit(99);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

TEST_CASE("a limit on the memory of a process ends in results or a sentence, never in a driver that waits for ever") {
    if (test::addresses_are_reserved()) return;
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    const std::string limit = GENERATE(as<std::string>(), "-v 100000", "-v 200000", "-v 300000", "-v 390000",
                                       "-v 450000", "-v 500000", "-v 550000", "-d 200000");
    const auto limited = [&](const std::string& options) {
        return shell("ulimit " + limit + "; POCL_MAX_PTHREAD_COUNT=2 " + program + " run " + file +
                         " --no-cache --out " + (folder / "out").string() + options,
                     within(std::chrono::seconds(60)));
    };

    const Outcome any = limited("");
    const Outcome opencl = limited(" --backend opencl");

    INFO(limit << ": " << any.err << opencl.err);
    CHECK(any.exit_code == 0);
    const bool fits = any.err.find("backend: opencl") != std::string::npos;
    CHECK(opencl.exit_code == (fits ? 0 : 2));
    CHECK(fits == (limit == "-v 550000"));
    if (fits) return;
    CHECK_THAT(opencl.err, Contains("drivers need about") && Contains("MiB may be used (ulimit " + limit.substr(0, 2)));
    CHECK_THAT(any.err, Contains("not opencl: no OpenCL device can be used: drivers need about"));
}

TEST_CASE("a run that does not fit beside the driver's compiler is refused with the numbers") {
    if (test::addresses_are_reserved()) return;
    const Folder folder;
    const std::string file = folder.write("large.pex", "define chemical U\ncreate matrix 2000 2000 wrap\nstop at 2\n");

    const Outcome outcome = shell("ulimit -v 900000; POCL_MAX_PTHREAD_COUNT=2 " + program + " run " + file +
                                      " --no-cache --backend opencl --out " + (folder / "out").string(),
                                  within(std::chrono::seconds(60)));

    INFO(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK_THAT(outcome.err, Contains("160 MiB for the OpenCL driver's compiler") && Contains("may be used"));
}

TEST_CASE(
    "where memory runs out under a driver the process ends at once, and a crash of a limited one with a sentence") {
    if (test::addresses_are_reserved()) return;
    const auto wanting = [](bool drivers) {
        return exit_code_of([drivers] {
            pelage::app::tidy_when_killed();
            if (drivers) (void)pelage::list_devices();
            try {
                ::operator delete(::operator new (std::size_t{1} << 60));
            } catch (const std::bad_alloc&) {
                _exit(3);
            }
        });
    };
    CHECK(wanting(true) == pelage::app::bad_input);
    CHECK(wanting(false) == 3);

    const auto aborting = [](bool limited) {
        return exit_code_of([limited] {
            const rlimit limit{std::size_t{4} << 30, std::size_t{4} << 30};
            if (limited) setrlimit(RLIMIT_AS, &limit);
            std::signal(SIGABRT, SIG_DFL);  // Catch2 has its own
            pelage::app::tidy_when_killed();
            (void)pelage::list_devices();
            std::abort();
        });
    };
    CHECK(aborting(true) == pelage::app::bad_input);
    CHECK(aborting(false) == 128 + SIGABRT);
}

TEST_CASE("what a limit on the process leaves is known") {
    if (test::addresses_are_reserved()) return;
    CHECK(exit_code_of([] {
              const rlimit limit{std::size_t{4} << 30, std::size_t{4} << 30};
              setrlimit(RLIMIT_AS, &limit);
              const auto found = pelage::process_limit();
              const bool right = found && found->bytes == static_cast<double>(limit.rlim_cur) && found->taken > 0 &&
                                 pelage::usable_memory() <= found->left() && std::string(found->option) == "ulimit -v";
              _exit(right ? 0 : 1);
          }) == 0);
}

TEST_CASE("a signal that is ignored stays so under drivers that put handlers of their own in its place") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    const auto [name, signal] =
        GENERATE(table<std::string, int>({{"HUP", SIGHUP}, {"INT", SIGINT}, {"TERM", SIGTERM}}));
    const auto checkpoint = folder / "out" / "checkpoint.pelage";
    Child child({"sh", "-c",
                 "trap '' " + name + "; exec " + program + " run " + file +
                     " --backend opencl --no-cache --no-self-test --no-tune --quiet " +
                     "--iterations 400000000 --checkpoint-every 500 --out " + (folder / "out").string()});
    REQUIRE(test::wait_for(checkpoint, child));

    child.signal(signal);
    std::filesystem::remove(checkpoint);
    CHECK(test::wait_for(checkpoint, child));
    std::filesystem::remove(checkpoint);
    CHECK(test::wait_for(checkpoint, child));

    child.signal(signal == SIGTERM ? SIGINT : SIGTERM);
    CHECK(child.wait().exit_code == 130);
}

TEST_CASE("two runs at once do not mix their results in one folder") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    const std::vector<std::string> words{PELAGE_COMMAND, "run",   file,          "--backend",
                                         "reference",    "--out", folder / "out"};
    std::vector<std::string> longer = words;
    longer.insert(longer.end(), {"--iterations", "400000000", "--checkpoint-every", "500"});
    Child first(longer);
    REQUIRE(test::wait_for(folder / "out" / "checkpoint.pelage", first));

    const Outcome second = Child(words).wait();
    CHECK(second.exit_code == 2);
    CHECK_THAT(second.err, Contains("another run writes into the folder") && Contains("--out"));
    first.signal(SIGTERM);
    CHECK(first.wait().exit_code == 130);
    CHECK(Child(words).wait().exit_code == 0);
}
