// What is in a run's folder: results of one run and no other, pictures that can be compared, a manifest that says all.
#include "support/process.hpp"
#include "texts.hpp"

#include "io/exr.hpp"
#include "io/field.hpp"
#include "io/sha256.hpp"

#include <sys/stat.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <csignal>

using Catch::Contains;
using test::command;
using test::Folder;
using test::names_in;
using test::Outcome;
using test::read_all;
using Names = std::vector<std::string>;

namespace {

Outcome run_reference(const std::string& file, const std::string& out, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"run", file, "--backend", "reference", "--out", out});
    return command(more);
}

nlohmann::json manifest_in(const std::filesystem::path& folder) {
    return nlohmann::json::parse(read_all(folder / "manifest.json"));
}

// Row 0 of U rises by 1 in each iteration, from 0; everything else stays 0.
const std::string rising =
    "define chemical U\n"
    "use chemical U conc 0\n"
    "create matrix 5 4 no-flux\n"
    "rule if ROW == 0 change U conc 1\n"
    "stop at 40\n"
    "snap at 10 20 40\n"
    "output U colormap gray\n";

// Lower left: the only cell whose colour changes.
double corner(const std::filesystem::path& picture) { return pelage::read_field(picture, "")->values.front(); }

const std::string swarm =
    "define chemical U\nuse chemical U conc 1 dev 0.5\ncreate hex_grid 4 4\nrule always change U conc 0.1\nstop at 5\n";

}  // namespace

TEST_CASE("results of an earlier run go when a new one has its own, the user's files stay") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    REQUIRE(run_reference(file, folder / "out", {"--format", "png,npy", "--snap-every", "10"}).exit_code == 0);
    folder.write("out/notes.txt", "mine");
    folder.write("out/35.png", "mine too");
    folder.write("out/sub.exr", "and mine");

    REQUIRE(run_reference(file, folder / "out", {"--format", "png", "--snap-every", "30"}).exit_code == 0);

    CHECK(names_in(folder / "out") ==
          Names{"0.png", "30.png", "35.png", "60.png", "final.png", "manifest.json", "notes.txt", "sub.exr"});
    CHECK(read_all(folder / "out" / "35.png") == "mine too");
    CHECK(manifest_in(folder / "out").at("files") == Names{"0.png", "30.png", "60.png", "final.png"});
}

TEST_CASE("a run that is refused, or cannot write, leaves earlier results as they were") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    REQUIRE(run_reference(file, folder / "out", {"--format", "png,csv", "--snap-every", "30"}).exit_code == 0);
    const Names before = names_in(folder / "out");
    test::Surroundings cramped;
    cramped.largest_file = 4096;

    CHECK(run_reference(file, folder / "out", {"--iterations", "-1"}).exit_code == 2);
    CHECK(run_reference(folder.write("bad.pex", "define chemical\n"), folder / "out").exit_code == 2);
    CHECK(run_reference(folder.write("unstable.pex", test::unstable), folder / "out").exit_code == 2);
    CHECK(command({"run", file, "--backend", "reference", "--out", folder / "out", "--format", "csv"}, cramped)
              .exit_code == 2);

    CHECK(names_in(folder / "out") == before);
    CHECK(manifest_in(folder / "out").at("end") == "finished");
}

TEST_CASE("a run that meets infinity leaves no picture of an earlier one, and its dump goes with the next") {
    const Folder folder;
    const std::string good = folder.write("spots.pex", test::spots);
    REQUIRE(run_reference(good, folder / "out").exit_code == 0);

    CHECK(run_reference(folder.write("doubling.pex", test::doubling), folder / "out", {"--snap-every", "100"})
              .exit_code == 1);
    CHECK(names_in(folder / "out") ==
          Names{"0.exr", "0.png", "100.exr", "100.png", "manifest.json", "non-finite.pelage"});

    REQUIRE(run_reference(good, folder / "out").exit_code == 0);
    CHECK(names_in(folder / "out") == Names{"final.exr", "final.png", "manifest.json"});
}

TEST_CASE("the results of a run that was killed are known to the next one") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    test::Child child({PELAGE_COMMAND, "run", file, "--backend", "reference", "--out", folder / "out", "--iterations",
                       "4000000", "--snap-every", "50", "--format", "npy"});
    REQUIRE(test::wait_for(folder / "out" / "150.V.npy", child));
    child.signal(SIGKILL);
    child.wait();
    CHECK(std::filesystem::exists(folder / "out" / "50.V.npy"));
    CHECK_FALSE(std::filesystem::exists(folder / "out" / "manifest.json"));

    REQUIRE(run_reference(file, folder / "out").exit_code == 0);

    CHECK_FALSE(std::filesystem::exists(folder / "out" / "50.V.npy"));
    CHECK_FALSE(std::filesystem::exists(folder / "out" / ".pelage-results"));
}

TEST_CASE("a resumed run keeps the snapshots before it, and only those of its own run") {
    const Folder folder;
    const std::string file = folder.write("rising.pex", rising);
    REQUIRE(run_reference(file, folder / "out", {"--format", "png", "--checkpoint-every", "15"}).exit_code == 0);
    const std::string checkpoint = folder / "out" / "checkpoint.pelage";  // at iteration 30
    CHECK(names_in(folder / "out") ==
          Names{"10.png", "20.png", "40.png", "checkpoint.pelage", "final.png", "manifest.json"});

    REQUIRE(run_reference(file, folder / "out", {"--format", "npy", "--resume", checkpoint}).exit_code == 0);
    CHECK(names_in(folder / "out") ==
          Names{"10.png", "20.png", "40.U.npy", "checkpoint.pelage", "final.U.npy", "manifest.json"});
    CHECK(manifest_in(folder / "out").at("files") == Names{"10.png", "20.png", "40.U.npy", "final.U.npy"});

    const std::string other = folder.write("spots.pex", test::spots);
    REQUIRE(run_reference(other, folder / "b", {"--format", "npy", "--checkpoint-every", "40"}).exit_code == 0);
    REQUIRE(run_reference(other, folder / "out", {"--format", "npy", "--resume", folder / "b" / "checkpoint.pelage"})
                .exit_code == 0);
    CHECK(names_in(folder / "out") == Names{"checkpoint.pelage", "final.U.npy", "final.V.npy", "manifest.json"});
}

TEST_CASE("a resumed run reads the pictures of fields again, and takes no other in their place") {
    const Folder folder;
    const auto picture = folder / "feed.npy";
    const std::string rows = folder.write("rising.pex", rising);
    REQUIRE(run_reference(rows, folder / "made", {"--format", "npy"}).exit_code == 0);
    std::filesystem::copy_file(folder / "made" / "final.U.npy", picture);
    const std::string file = folder.write(
        "fed.pex",
        "define chemical U\ndefine field feed \"feed.npy\"\ncreate matrix 5 4\nrule always change U conc feed\n"
        "stop at 10\n");
    for (const std::string backend : {"reference", "opencl"}) {
        const auto run = [&](const std::string& out, std::vector<std::string> more) {
            more.insert(more.begin(), {"run", file, "--backend", backend, "--out", folder / out, "--format", "npy"});
            return command(more);
        };
        REQUIRE(run("whole", {}).exit_code == 0);
        REQUIRE(run("part", {"--checkpoint-every", "4", "--iterations", "6"}).exit_code == 0);
        const std::vector<std::string> resume{"--resume", folder / "part" / "checkpoint.pelage"};
        REQUIRE(run("resumed", resume).exit_code == 0);
        CHECK(read_all(folder / "resumed" / "final.U.npy") == read_all(folder / "whole" / "final.U.npy"));
        CHECK(read_all(folder / "resumed" / "final.U.npy") != read_all(folder / "part" / "final.U.npy"));

        std::filesystem::copy_file(folder / "whole" / "final.U.npy", picture,
                                   std::filesystem::copy_options::overwrite_existing);
        const Outcome refused = run("resumed", resume);
        CHECK(refused.exit_code == 2);
        CHECK_THAT(refused.err, Contains("'feed.npy' is not the file that the run began with"));
        std::filesystem::copy_file(folder / "made" / "final.U.npy", picture,
                                   std::filesystem::copy_options::overwrite_existing);
    }
}

TEST_CASE("a manifest that was tampered with cannot make a run remove anything but results") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    folder.write("precious.png", "outside");
    std::filesystem::create_directories(folder / "out" / "5.png");  // a folder
    folder.write("out/thesis.tex", "mine");
    folder.write("out/manifest.json",
                 R"({"files": ["../precious.png", "thesis.tex", "5.png", ".hidden.png", 7, "", "/etc/hosts.png"]})");

    REQUIRE(run_reference(file, folder / "out").exit_code == 0);

    CHECK(read_all(folder / "precious.png") == "outside");
    CHECK(names_in(folder / "out") == Names{"5.png", "final.exr", "final.png", "manifest.json", "thesis.tex"});
}

TEST_CASE("snapshots of a run share one range of colours, the final picture has its own") {
    const Folder folder;
    const std::string file = folder.write("rising.pex", rising);

    REQUIRE(run_reference(file, folder / "out", {"--format", "png"}).exit_code == 0);

    CHECK(corner(folder / "out" / "10.png") == Approx(0.25).margin(0.003));
    CHECK(corner(folder / "out" / "20.png") == Approx(0.5).margin(0.003));
    CHECK(corner(folder / "out" / "40.png") == 1.0);
    CHECK(corner(folder / "out" / "final.png") == 1.0);
    CHECK(names_in(folder / "out") == Names{"10.png", "20.png", "40.png", "final.png", "manifest.json"});
}

TEST_CASE("pictures with ranges of their own, and normal maps, are not drawn anew") {
    const Folder folder;
    const std::string start =
        "define chemical U\ndefine chemical V\ndefine chemical W\ncreate matrix 5 4\nuse chemical V conc 1\n"
        "rule if COLUMN == 2 change U conc 1\nrule if COLUMN == 2 change V conc 1\nrule if ROW == 1 change W conc 1\n"
        "stop at 20\noutput U\noutput V range 0 40\noutput W normal 2\noutput V height range each\n";
    const std::string file = folder.write("a.pex", start + "snap at 5 20\n");
    const std::string alone = folder.write("b.pex", start + "snap at 5\n");

    REQUIRE(run_reference(file, folder / "a", {"--format", "png"}).exit_code == 0);
    REQUIRE(run_reference(alone, folder / "b", {"--format", "png"}).exit_code == 0);

    for (const char* name : {"5.V.png", "5.W.normal.png", "5.V.height.png"}) {
        INFO(name);
        CHECK(read_all(folder / "a" / name) == read_all(folder / "b" / name));
    }
    CHECK(read_all(folder / "a" / "5.png") != read_all(folder / "b" / "5.png"));
}

TEST_CASE("'range each' gives every picture its own range, a range that is given holds for all") {
    const Folder folder;
    const std::string each = folder.write("each.pex", rising + "output U range each colormap gray\n");
    const std::string given = folder.write("given.pex", rising + "output U range 0 80 colormap gray\n");

    REQUIRE(run_reference(each, folder / "a", {"--format", "png"}).exit_code == 0);
    REQUIRE(run_reference(given, folder / "b", {"--format", "png"}).exit_code == 0);

    for (const char* name : {"10.U.png", "20.U.png", "40.U.png"}) CHECK(corner(folder / "a" / name) == 1.0);
    CHECK(corner(folder / "b" / "20.U.png") == Approx(0.25).margin(0.003));
    CHECK(corner(folder / "b" / "final.U.png") == Approx(0.5).margin(0.003));
}

TEST_CASE("free cells' snapshots share a range too") {
    const Folder folder;
    const std::string file = folder.write("swarm.pex", swarm + "snap at 1 5\noutput U colormap gray\n");
    const std::string each = folder.write("each.pex", swarm + "snap at 1 5\noutput U range each colormap gray\n");

    REQUIRE(run_reference(file, folder / "a", {"--format", "png"}).exit_code == 0);
    REQUIRE(run_reference(each, folder / "b", {"--format", "png"}).exit_code == 0);

    CHECK(read_all(folder / "a" / "1.png") != read_all(folder / "b" / "1.png"));
    CHECK(read_all(folder / "a" / "1.png") != read_all(folder / "a" / "5.png"));
    CHECK(read_all(folder / "b" / "1.png") == read_all(folder / "b" / "5.png"));  // all cells rise alike
}

TEST_CASE("an EXR picture of free cells is refused where it cannot be, and not missed where nobody asked") {
    const Folder folder;
    const std::string file = folder.write("swarm.pex", swarm);
    const std::string texture = folder.write("texture.pex", swarm + "texture size 16 16\n");

    const Outcome refused = run_reference(file, folder / "out", {"--format", "csv,exr"});
    CHECK(refused.exit_code == 2);
    CHECK_THAT(refused.err, Contains("free cells make no EXR picture") && Contains("texture size"));
    CHECK_FALSE(std::filesystem::exists(folder / "out"));
    REQUIRE(run_reference(texture, folder / "a", {"--format", "exr"}).exit_code == 0);
    CHECK(names_in(folder / "a") == Names{"manifest.json", "texture.exr"});
    REQUIRE(run_reference(file, folder / "b").exit_code == 0);
    CHECK(names_in(folder / "b") == Names{"final.png", "manifest.json"});
}

TEST_CASE("options --exr-type and --png-bits choose the size of numbers") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);

    REQUIRE(run_reference(file, folder / "out", {"--exr-type", "half", "--png-bits", "16"}).exit_code == 0);
    REQUIRE(run_reference(file, folder / "usual").exit_code == 0);

    const auto half = pelage::read_exr(folder / "out" / "final.exr");
    const auto whole = pelage::read_exr(folder / "usual" / "final.exr");
    CHECK(half.names == whole.names);
    CHECK(half.values[0] != whole.values[0]);
    CHECK(half.values[0][17] == Approx(whole.values[0][17]).epsilon(1e-3));
    CHECK(read_all(folder / "out" / "final.png")[24] == 16);
    CHECK(read_all(folder / "usual" / "final.png")[24] == 8);
}

TEST_CASE("the manifest holds every option of the command line") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    const std::string help = command({"run", "--help"}).out;

    REQUIRE(run_reference(file, folder / "out", {"--snap-every", "30", "--force", "--format", "png"}).exit_code == 0);
    const auto options = manifest_in(folder / "out").at("options");

    std::size_t named = 0;
    for (auto at = help.find("  --"); at != std::string::npos; at = help.find("  --", at + 4)) {
        const auto name = help.substr(at + 4, help.find_first_of(" ,\n", at + 4) - at - 4);
        INFO(name);
        CHECK((name == "help" || options.contains(name)));
        ++named;
    }
    CHECK(named > 20);
    CHECK(options.at("snap-every") == "30");
    CHECK(options.at("force") == true);
    CHECK(options.at("quiet") == false);
    CHECK(options.at("seed") == nullptr);
    CHECK(options.at("format") == "png");
    CHECK(options.at("FILE") == file);
    CHECK(manifest_in(folder / "out").at("time").get<double>() == Approx(0.6));
}

TEST_CASE("a resumed run needs no start picture, and remembers which one it was") {
    const Folder folder;
    REQUIRE(run_reference(folder.write("spots.pex", test::spots), folder / "source", {"--format", "npy"}).exit_code ==
            0);
    const std::string picture = read_all(folder / "source" / "final.U.npy");
    folder.write("start.npy", picture);
    const std::string file = folder.write("from.pex",
                                          "define chemical U conc \"start.npy\"\ndefine chemical V\n"
                                          "use chemical U diff 0.1\ncreate matrix 24 16 wrap\nstop at 50\n");
    const std::vector<std::string> words{"--format", "npy", "--checkpoint-every", "20"};
    REQUIRE(run_reference(file, folder / "out", words).exit_code == 0);
    const std::string whole = read_all(folder / "out" / "final.U.npy");
    const std::vector<std::string> resume{"--format", "npy", "--resume", folder / "out" / "checkpoint.pelage"};

    std::filesystem::remove(folder / "start.npy");
    CHECK(run_reference(file, folder / "again").exit_code == 2);
    const Outcome gone = run_reference(file, folder / "a", resume);
    folder.write("start.npy", "changed since");
    const Outcome changed = run_reference(file, folder / "out", resume);

    INFO(gone.err << changed.err);
    REQUIRE(gone.exit_code == 0);
    REQUIRE(changed.exit_code == 0);
    CHECK(read_all(folder / "a" / "final.U.npy") == whole);
    CHECK(read_all(folder / "out" / "final.U.npy") == whole);
    for (const char* name : {"a", "out"}) {
        const auto inputs = manifest_in(folder / name).at("inputs");
        CHECK(inputs == nlohmann::json{{{"file", "start.npy"}, {"sha256", pelage::sha256(picture)}}});
    }
}

TEST_CASE("a run with spatial sorting is resumed in the order that it had") {
    const Folder folder;
    const std::string file = folder.write("cells.pex",
                                          "use seed 3\ndefine chemical A\nuse chemical A conc 1 dev 0.5 diff 0.1\n"
                                          "create hex_circle 8\nrule probability 0.01 divide direction 0 dev 180\n"
                                          "stop at 60\n");
    const std::vector<std::string> words{"--format", "npy", "--neighbours", "spatial-sorting", "--checkpoint-every"};
    std::vector<std::string> whole = words, resumed = words;
    whole.emplace_back("25");
    resumed.insert(resumed.end(), {"25", "--resume", folder / "whole" / "checkpoint.pelage"});
    REQUIRE(run_reference(file, folder / "whole", whole).exit_code == 0);

    REQUIRE(run_reference(file, folder / "resumed", resumed).exit_code == 0);

    CHECK(read_all(folder / "resumed" / "final.A.npy") == read_all(folder / "whole" / "final.A.npy"));
}

TEST_CASE("a run with a network is resumed with that network alone") {
    const Folder folder;
    const std::string network = read_all(PELAGE_SOURCE "/experiments/neural/tiny.npz");
    folder.write("net.npz", network);
    const std::string file = folder.write(
        "net.pex",
        "define chemicals x 8 floor none\nuse chemical x0 conc 0 dev 0.25\n"
        "define time_step 0.25\ncreate matrix 9 7 wrap\nrule always react all neural \"net.npz\"\nstop at 20\n");
    const std::vector<std::string> words{"--format", "npy", "--checkpoint-every", "8"};
    REQUIRE(run_reference(file, folder / "out", words).exit_code == 0);
    const nlohmann::json inputs{{{"file", "net.npz"}, {"sha256", pelage::sha256(network)}}};
    CHECK(manifest_in(folder / "out").at("inputs") == inputs);
    const std::string whole = read_all(folder / "out" / "final.x0.npy");
    const std::vector<std::string> resume{"--format", "npy", "--resume", folder / "out" / "checkpoint.pelage"};

    const Outcome again = run_reference(file, folder / "a", resume);
    folder.write("net.npz", read_all(PELAGE_SOURCE "/tests/io/networks/stored.npz"));
    const Outcome small = run_reference(file, folder / "b", resume);
    folder.write("net.npz", network + "a byte more");
    const Outcome changed = run_reference(file, folder / "c", resume);
    std::filesystem::remove(folder / "net.npz");
    const Outcome gone = run_reference(file, folder / "d", resume);

    INFO(again.err);
    REQUIRE(again.exit_code == 0);
    CHECK(read_all(folder / "a" / "final.x0.npy") == whole);
    CHECK(manifest_in(folder / "a").at("inputs") == inputs);
    CHECK(small.exit_code == 2);
    CHECK(changed.exit_code == 2);
    CHECK_THAT(changed.err, Contains("'net.npz' is not the file that the run began with"));
    CHECK(gone.exit_code == 2);
    CHECK_THAT(gone.err, Contains("net.npz"));
}

TEST_CASE("a byte that is not UTF-8 leaves manifest and EXR header readable") {
    const Folder folder;
    const std::string file = folder.write("latin.pex", test::spots + "// caf\xe9\n");

    REQUIRE(run_reference(file, folder / "out").exit_code == 0);

    const std::string mended = test::spots + "// caf\xef\xbf\xbd\n";
    CHECK(manifest_in(folder / "out").at("experiment").at("text") == mended);
    CHECK(pelage::read_exr(folder / "out" / "final.exr").attributes.at("experiment") == mended);
}

TEST_CASE("large results are told as they are begun, small ones are not") {
    const Folder folder;
    const std::string text = "define chemical U\nuse chemical U conc 1 dev 0.5\nstop at 0\n";
    const std::string large = folder.write("large.pex", text + "create matrix 1000 1000\n");
    const std::string small = folder.write("small.pex", text + "create matrix 100 100\n");

    CHECK_THAT(run_reference(large, folder / "a", {"--format", "npy,vti"}).err,
               Contains("writing final.U.npy\n") && Contains("writing final.vti\n"));
    CHECK_THAT(run_reference(small, folder / "b", {"--format", "npy,vti"}).err, !Contains("writing"));
    CHECK(run_reference(large, folder / "c", {"--format", "npy,vti", "--quiet"}).err.empty());
}

TEST_CASE("a link or a pipe in the place of the journal is refused, and what it leads to stays as it is") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    folder.write("precious.txt", "precious");
    std::filesystem::create_directories(folder / "out");
    const bool pipe = GENERATE(false, true);
    const std::string journal = folder / "out/.pelage-results";
    if (pipe) REQUIRE(mkfifo(journal.c_str(), 0600) == 0);
    if (!pipe) std::filesystem::create_symlink("../precious.txt", journal);

    const Outcome outcome =
        command({"run", file, "--backend", "reference", "--iterations", "2", "--out", folder / "out"});

    CHECK(outcome.exit_code == 2);
    CHECK_THAT(outcome.err, Contains(".pelage-results") && Contains("remove it"));
    CHECK(read_all(folder / "precious.txt") == "precious");
}
