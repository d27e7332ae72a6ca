// Machines that leave the command little: few processors, damaged caches, folders that nobody can write to.
#include "support/process.hpp"
#include "support/sanitizers.hpp"
#include "texts.hpp"

#include <sched.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace fs = std::filesystem;
using Catch::Contains;
using test::Child;
using test::Folder;
using test::Outcome;
using test::program;
using test::read_all;
using test::shell;

namespace {

// A user whose home, caches and temporary files lie in a folder; the last two are not set by variables of ours.
struct User {
    Folder folder;
    std::string file = folder.write("spots.pex", test::spots);
    std::string expected;

    User() {
        fs::create_directories(home());
        fs::create_directories(temporary());
        const Outcome reference = run(folder / "reference", "", "--backend reference");
        REQUIRE(reference.exit_code == 0);
        expected = read_all(folder / "reference" / "final.csv");
    }

    fs::path home() const { return folder / "home"; }
    fs::path temporary() const { return folder / "temporary"; }
    fs::path cache() const { return home() / ".cache" / "pelage"; }

    std::string start(const std::string& variables) const {
        return "env -u PELAGE_CACHE -u POCL_CACHE_DIR -u POCL_AFFINITY -u XDG_CACHE_HOME HOME=" + home().string() +
               " TMPDIR=" + temporary().string() + " " + variables + " " + program + " ";
    }
    Outcome run(const fs::path& out, const std::string& variables, const std::string& options) const {
        return shell(start(variables) + "run " + file + " --format csv --quiet --out " + out.string() + " " + options);
    }
    void check_run(const std::string& variables = "", const std::string& options = "") const {
        const Outcome outcome = run(folder / "out", variables, "--backend opencl " + options);
        INFO(variables << " " << options << ": " << outcome.err);
        CHECK(outcome.exit_code == 0);
        CHECK(read_all(folder / "out" / "final.csv") == expected);
        CHECK(test::names_in(temporary()).empty());
        fs::remove_all(folder / "out");
    }
};

std::vector<fs::path> files_below(const fs::path& folder) {
    std::vector<fs::path> found;
    if (!fs::exists(folder)) return found;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
}

// The last processor that this test may use.
int last_processor() {
    cpu_set_t set;
    REQUIRE(sched_getaffinity(0, sizeof set, &set) == 0);
    int last = 0;
    for (int i = 0; i < CPU_SETSIZE; ++i) last = CPU_ISSET(i, &set) ? i : last;
    return last;
}

std::string after(const fs::path& file, const std::string& word) {
    const std::string text = read_all(file);
    const auto place = text.find(word);
    if (place == std::string::npos) return {};
    std::istringstream rest(text.substr(place + word.size()));
    std::string value;
    rest >> value;
    return value;
}

}  // namespace

TEST_CASE("threads stay on the processors that the command may use") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    const std::string processor = std::to_string(last_processor());
    Child child({"taskset", "-c", processor, PELAGE_COMMAND, "run", file, "--backend", "opencl", "--no-self-test",
                 "--no-tune", "--iterations", "400000000", "--checkpoint-every", "500", "--out", folder / "out"});
    REQUIRE(test::wait_for(folder / "out" / "checkpoint.pelage", child));

    for (const auto& thread : fs::directory_iterator("/proc/" + std::to_string(child.id()) + "/task")) {
        CHECK(after(thread.path() / "status", "Cpus_allowed_list:") == processor);
    }
    child.signal(SIGTERM);
    CHECK(child.wait().exit_code == 130);
}

TEST_CASE("processes that verify starts beside each other may run on all processors") {
    constexpr std::size_t with_threads_of_pocl = 3;
    constexpr auto pause = std::chrono::milliseconds(5);
    const std::string all = after("/proc/self/status", "Cpus_allowed_list:");
    Child child({"env", "-u", "POCL_AFFINITY", PELAGE_COMMAND, "verify", "--filter", "pairs/", "--jobs", "2"});
    const pid_t worker = test::child_of(child.id(), "--worker");
    REQUIRE(worker != 0);
    const fs::path threads = "/proc/" + std::to_string(worker) + "/task";
    while (test::names_in(threads).size() < with_threads_of_pocl) {
        REQUIRE(child.running());
        std::this_thread::sleep_for(pause);
    }
    std::this_thread::sleep_for(20 * pause);

    for (const auto& thread : fs::directory_iterator(threads)) {
        CHECK(after(thread.path() / "status", "Cpus_allowed_list:") == all);
    }
}

TEST_CASE("any number of PoCL's threads gives the reference's bits, bound or not") {
    const User user;
    for (const char* count : {"1", "3", "5", "64", "-2", "many"}) {
        user.check_run(std::string("POCL_MAX_PTHREAD_COUNT=") + count, "--no-self-test");
    }
    user.check_run("POCL_MAX_PTHREAD_COUNT=3 POCL_AFFINITY=1", "--no-self-test");
    user.check_run("taskset -c " + std::to_string(last_processor()) + " env POCL_MAX_PTHREAD_COUNT=7 POCL_AFFINITY=1");
}

TEST_CASE("threads that share a processor take each other's work instead of waiting") {
    const User user;
    const std::string processor = std::to_string(last_processor());
    const auto seconds = [&](const std::string& threads) {
        const Outcome outcome =
            shell(user.start("POCL_MAX_PTHREAD_COUNT=" + threads + " taskset -c " + processor) + "run " + user.file +
                  " --backend opencl --no-tune --format csv --iterations 60000 " + "--quiet --json " +
                  (user.folder / "run.json").string() + " --out " + (user.folder / "out").string());
        REQUIRE(outcome.exit_code == 0);
        return std::stod(after(user.folder / "run.json", "\"seconds\":"));
    };
    const double alone = seconds("1");

    CHECK(seconds("2") < 8 * alone + 1);
    CHECK(seconds("16") < 8 * alone + 1);
}

TEST_CASE("what was compiled is kept, and found by the next run") {
    const User user;
    user.check_run();
    std::vector<fs::file_time_type> times;
    for (const fs::path& entry : files_below(user.cache())) times.push_back(fs::last_write_time(entry));
    user.check_run();
    std::vector<fs::file_time_type> later;
    for (const fs::path& entry : files_below(user.cache())) later.push_back(fs::last_write_time(entry));

    CHECK(times.size() >= 2);
    CHECK(later == times);  // it would have been written anew
}

TEST_CASE("a damaged entry of the cache is compiled again") {
    test::overlook_leaks();
    const User user;
    user.check_run();
    const std::vector<fs::path> entries = files_below(user.cache());
    REQUIRE(entries.size() >= 2);
    for (const std::size_t first : {0U, 1U}) {
        for (std::size_t i = 0; i < entries.size(); ++i) {
            const auto size = fs::file_size(entries[i]);
            if ((first + i) % 3 < 2) {
                fs::resize_file(entries[i], (first + i) % 3 == 0 ? size / 2 : 0);
            } else {
                std::fstream file(entries[i], std::ios::in | std::ios::out | std::ios::binary);
                file.seekp(static_cast<std::streamoff>(size / 2));
                file << std::string(64, '\0');
            }
        }
        user.check_run();
    }
    CHECK(files_below(user.cache()) == entries);
}

TEST_CASE("PoCL's own cache is neither read nor written") {
    const User user;
    user.check_run("POCL_CACHE_DIR=" + (user.home() / "pocl").string());
    CHECK(files_below(user.home() / "pocl").empty());
    CHECK_FALSE(fs::exists(user.home() / ".cache" / "pocl"));
}

TEST_CASE("option --no-cache leaves nothing on the disk") {
    const User user;
    user.check_run("", "--no-cache");
    CHECK(test::names_in(user.home()).empty());
    CHECK(shell(user.start("") + "verify --filter random/many --quiet").exit_code == 0);
    CHECK(test::names_in(user.temporary()).empty());
}

TEST_CASE("a command that is killed leaves no folder, or the next one removes it") {
    const User user;
    const int signal = GENERATE(SIGTERM, SIGALRM, SIGKILL);
    Child child({"sh", "-c",
                 "exec " + user.start("") + "run " + user.file + " --backend opencl --no-cache --quiet " +
                     "--no-tune --no-self-test --iterations 400000000 --checkpoint-every 500 --out " +
                     (user.folder / "out").string()});
    REQUIRE(test::wait_for(user.folder / "out" / "checkpoint.pelage", child));
    CHECK(test::names_in(user.temporary()).size() == 1);
    CHECK(shell(user.start("") + "devices").exit_code == 0);
    CHECK(test::names_in(user.temporary()).size() == 1);  // of one that lives

    child.signal(signal);

    CHECK(child.wait().exit_code == (signal == SIGTERM ? 130 : 128 + signal));
    CHECK(test::names_in(user.temporary()).size() == (signal == SIGKILL ? 1 : 0));
    CHECK(shell(user.start("") + "devices").exit_code == 0);
    CHECK(test::names_in(user.temporary()).empty());
    CHECK(files_below(user.home()).empty());
}

TEST_CASE("a home that cannot be written to is no reason to go without OpenCL") {
    const User user;
    const std::vector<std::string> bad{"TMPDIR=/proc/nonexistent",
                                       "POCL_CACHE_DIR=/proc/nonexistent",
                                       "POCL_CACHE_DIR=" + user.file,
                                       "HOME=/proc/nonexistent",
                                       "env -u HOME",
                                       "PELAGE_CACHE=" + user.file};
    for (const std::string& variables : bad) {
        user.check_run(variables, "--no-self-test");
    }
}
