// Networks as we write them.
#include "core/error.hpp"
#include "io/archive.hpp"
#include "io/network.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

using namespace pelage;

TEST_CASE("a network that is written is read again, by others too") {
    const test::Folder folder;
    std::vector<double> first, second;
    for (int n = 0; n < 32; ++n) first.push_back(0.25 * n), second.push_back(-0.5 * n);
    const Network network = make_network(4, 8, first, {1, 2, 3, 4, 5, 6, 7, 8}, second, "x");
    write_network(folder / "a.npz", network);
    const Network found = read_network(folder / "a.npz").network;
    CHECK(found.first == network.first);
    CHECK(found.bias == network.bias);
    CHECK(found.second == network.second);
    const auto checked = test::shell("unzip -tq '" + (folder / "a.npz").string() + "' || python3 -m zipfile -t '" +
                                     (folder / "a.npz").string() + "'");
    if (checked.exit_code != 127) CHECK(checked.exit_code == 0);
    CHECK_THROWS_AS(write_network(folder / "none" / "a.npz", network), Error);
}

TEST_CASE("files that are put into a zip come out of it") {
    const std::string bytes = zip_of({{"a", ""}, {"b/c", std::string(1000, '\0')}});
    CHECK(parse_zip(bytes, "x", 1u << 20) ==
          std::map<std::string, std::string>{{"a", ""}, {"b/c", std::string(1000, '\0')}});
}
