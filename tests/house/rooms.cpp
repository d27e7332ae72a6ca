// The rooms of the house: which folder may include from which. No two of them include from each other, by whatever way
// round; what is common to a kernel file and the host's part of it has one name.
#include "house/circle.hpp"
#include "house/source.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

using test::read_all;

namespace {

namespace fs = std::filesystem;

using Rooms = test::Includes;  // a room, and those that it includes from

// The folder of what `name` names in an #include, relative to the sources; empty for what is not ours.
std::string room_of(const std::string& name) {
    for (const fs::path& place : {fs::path("host") / name, fs::path(name)}) {
        if (fs::exists(source / place)) return place.parent_path().string();
    }
    return "";
}

Rooms rooms() {
    Rooms found;
    const std::regex line("#include \"([^\"]+)\"");
    for (const char* part : {"host", "reference"}) {
        for (const auto& entry : fs::recursive_directory_iterator(source / part)) {
            if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
            const std::string room = entry.path().parent_path().lexically_relative(source).string();
            const std::string text = read_all(entry.path());
            for (auto at = std::sregex_iterator(text.begin(), text.end(), line); at != std::sregex_iterator(); ++at) {
                const std::string other = room_of((*at)[1].str());
                if (!other.empty() && other != room) found[room].insert(other);
            }
        }
    }
    return found;
}

}  // namespace

TEST_CASE("no room includes from itself by way of others") {
    const Rooms all = rooms();
    REQUIRE(all.size() > 15);

    for (const auto& [room, unused] : all) {
        INFO(room);
        CHECK(test::circle(all, room) == std::vector<std::string>{});
    }
}

TEST_CASE("neither backend includes the other, and the core includes nobody") {
    const Rooms all = rooms();

    CHECK(all.count("host/core") == 0);
    for (const auto& [room, others] : all) {
        for (const std::string& other : others) {
            INFO(room << " includes from " << other);
            CHECK_FALSE((room.starts_with("reference") && other.starts_with("host/opencl")));
            CHECK_FALSE((room.starts_with("host/opencl") && other.starts_with("reference")));
        }
    }
}

TEST_CASE("kernels, OpenCL and reference have rooms of the same names") {
    for (const char* room : {"lattice", "volume", "cells", "mesh", "neighbours", "rules"}) {
        INFO(room);
        CHECK(fs::is_directory(source / "kernels" / room));
        CHECK(fs::is_directory(source / "host/opencl" / room));
        CHECK(fs::is_directory(source / "reference" / room));
    }
}

TEST_CASE("a kernel and what launches it have one name") {
    const std::set<std::string> others{"cells/alone",       // the frame around cells/step.cl, as cells/together.cl is
                                       "neighbours/lists",  // the second half of neighbours/bins.cl
                                       "learn/loss_lanes",  // what learn/loss.cl does, shared among work-items
                                       "learn/reverse_lanes"};  // the same of learn/iteration.cl
    std::size_t seen = 0;
    for (const auto& entry : fs::recursive_directory_iterator(source / "kernels")) {
        const std::string name = entry.path().lexically_relative(source / "kernels").replace_extension().string();
        if (name.starts_with("common/") || others.contains(name)) continue;
        if (!std::regex_search(read_all(entry.path()), std::regex("(^|\n)(__)?kernel "))) continue;
        INFO(name);
        CHECK(fs::exists(source / "host/opencl" / (name + ".cpp")));
        ++seen;
    }
    CHECK(seen > 10);
}
