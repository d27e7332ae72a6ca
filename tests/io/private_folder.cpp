// Folders of a living process, beside somebody who tidies up what dead ones have left.
#include "io/locked.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <atomic>
#include <filesystem>
#include <thread>
#include <vector>

using namespace pelage;

TEST_CASE("a private folder is there, whoever tidies up while it is made") {
    const test::Folder folder;
    std::atomic<bool> done = false;
    std::vector<std::thread> tidy;
    for (int i = 0; i < 2; ++i) {
        tidy.emplace_back([&] {
            while (!done) remove_left_over(folder.path(), "own-", "");
        });
    }
    std::size_t missing = 0;
    for (int i = 0; i < 3000; ++i) {
        const PrivateFolder own(folder.path(), "own-");
        missing += std::filesystem::is_directory(own.path()) ? 0 : 1;
    }
    done = true;
    for (std::thread& one : tidy) one.join();
    CHECK(missing == 0);
}
