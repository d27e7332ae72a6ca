// Files appear whole or not at all, and say why not.
#include "io/atomic_file.hpp"
#include "core/error.hpp"
#include "io/file_bytes.hpp"
#include "io/locked.hpp"
#include "scratch.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>

namespace fs = std::filesystem;
using Catch::Matchers::Contains;
using namespace pelage;
using test::Scratch;

TEST_CASE("a file is there after commit, not before") {
    const Scratch scratch;
    const auto path = scratch / "data.bin";
    test::put(path, "before");

    AtomicFile file(path);
    file.write("after");
    const auto during = test::get(path);
    file.commit();

    CHECK(during == "before");
    CHECK(test::get(path) == "after");
    CHECK(scratch.names() == std::vector<std::string>{"data.bin"});
}

TEST_CASE("a file that is given up leaves nothing behind") {
    const Scratch scratch;

    {
        AtomicFile file(scratch / "data.bin");
        file.write("half");
        CHECK(scratch.names().size() == 1);
    }

    CHECK(scratch.names().empty());
}

TEST_CASE("a file may be written while the process ends") {
    struct Late {
        std::filesystem::path path;
        ~Late() { write_file(path, "late"); }
    };
    const Scratch scratch;
    const pid_t child = fork();
    if (child == 0) {
        static const Late late{scratch / "late.bin"};
        for (int i = 0; i < 50; ++i) {
            const auto folder = scratch / std::to_string(i);
            fs::create_directories(folder);
            write_file(folder / "data.bin", "early");
        }
        std::exit(0);
    }

    int status = -1;
    waitpid(child, &status, 0);

    CHECK(status == 0);
    CHECK(test::get(scratch / "late.bin") == "late");
}

TEST_CASE("what a killed program left is removed, what a living one writes is not") {
    const Scratch scratch;
    test::put(scratch / ".pelage-1-0.part", "half");
    test::put(scratch / "notes.part", "somebody's");
    const pid_t child = fork();
    if (child == 0) {
        AtomicFile file(scratch / "other.bin");
        file.write("half");
        pause();
    }
    const auto begun = [&] { return scratch.names().size() == 2 && !fs::exists(scratch / ".pelage-1-0.part"); };
    while (!begun()) usleep(1000);

    write_file(scratch / "data.bin", "whole");

    CHECK(scratch.names().size() == 3);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    CHECK(scratch.names().size() == 3);
    remove_left_over(scratch / "", ".pelage-", ".part");
    CHECK(scratch.names() == std::vector<std::string>{"data.bin", "notes.part"});
}

TEST_CASE("bytes can be written over at an earlier place") {
    const Scratch scratch;

    AtomicFile file(scratch / "data.bin");
    file.write("0123456789");
    file.seek(2);
    file.write("ab");
    CHECK(file.position() == 4);
    file.sync();
    file.commit();

    CHECK(test::get(scratch / "data.bin") == "01ab456789");
}

TEST_CASE("a full device is an error that names file and reason") {
    const auto text = test::error_of([] { write_file("/dev/full", std::string(100000, 'x')); });
    const auto little = test::error_of([] { write_file("/dev/full", "x"); });  // fails as late as in the flush

    CHECK(text == "cannot write '/dev/full': No space left on device");
    CHECK(little == text);
    CHECK(fs::is_character_file("/dev/full"));
}

TEST_CASE("when the disk is full the old file stays and the half-written one goes") {
    const Scratch scratch;
    const auto path = scratch / "data.bin";
    test::put(path, "old");

    std::string text;
    std::string again;
    {
        const test::FileSizeLimit limit(10000);
        AtomicFile file(path);
        text = test::error_of([&] {
            for (int i = 0; i < 100; ++i) file.write(std::string(1000, 'x'));
        });
        again = test::error_of([&] { file.commit(); });
    }

    CHECK_THAT(text, Contains("cannot write") && Contains("data.bin") && Contains("File too large"));
    CHECK(again == text);
    CHECK(test::get(path) == "old");
    CHECK(scratch.names() == std::vector<std::string>{"data.bin"});
}

TEST_CASE("places that cannot be written are named with the reason") {
    const Scratch scratch;
    test::put(scratch / "file", "");
    const auto write = [&](const std::string& name) {
        return test::error_of([&] { write_file(scratch / name, "x"); });
    };

    CHECK_THAT(write("missing/data.bin"), Contains("missing/data.bin") && Contains("No such file or directory"));
    CHECK_THAT(write("file/data.bin"), Contains("Not a directory"));
    CHECK_THAT(write("."), Contains("it is a folder"));
    CHECK_THAT(write(std::string(300, 'x')), Contains("too long"));
    CHECK(scratch.names() == std::vector<std::string>{"file"});
}

TEST_CASE("a folder without permission is an error") {
    const Scratch scratch;
    const auto locked = scratch / "locked";
    fs::create_directory(locked);
    fs::permissions(locked, fs::perms::owner_read | fs::perms::owner_exec);

    const auto text = test::error_of([&] { write_file(locked / "data.bin", "x"); });

    // The superuser may write anyway, and then it must have worked.
    if (geteuid() == 0) {
        CHECK(test::get(locked / "data.bin") == "x");
    } else {
        CHECK_THAT(text, Contains("data.bin") && Contains("Permission denied"));
    }
    fs::permissions(locked, fs::perms::owner_all);
}

TEST_CASE("a symbolic link stays one and its file is replaced") {
    const Scratch scratch;
    test::put(scratch / "real", "old");
    fs::create_symlink(scratch / "real", scratch / "link");

    write_file(scratch / "link", "new");

    CHECK(fs::is_symlink(scratch / "link"));
    CHECK(test::get(scratch / "real") == "new");
}

TEST_CASE("what cannot be read is named with the reason") {
    const Scratch scratch;

    CHECK_THAT(test::error_of([&] { read_file(scratch / "none"); }), Contains("none") && Contains("No such file"));
    CHECK_THAT(test::error_of([&] { read_file(scratch.folder()); }), Contains("not a plain file"));
    CHECK_THAT(test::error_of([&] { read_file("/dev/zero"); }), Contains("not a plain file"));
}
