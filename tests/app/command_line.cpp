// What may be typed, what is said to what was mistyped, and the texts that are made from the command's definition.
#include "app/command_line.hpp"
#include "app/completion.hpp"
#include "app/manual.hpp"
#include "app/options_of.hpp"
#include "app/tune_table.hpp"
#include "app/validators.hpp"
#include "support/process.hpp"
#include "texts.hpp"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using Catch::Contains;
using test::command;
using test::Folder;
using test::Outcome;

namespace {

std::string refusal(const std::vector<std::string>& words) {
    const Outcome outcome = command(words);
    INFO(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    return outcome.err;
}

// The whole command line, as the command defines it.
struct Definition {
    Definition() { pelage::app::define(app, exit_code); }
    CLI::App app;
    int exit_code = 0;
};

// What bash offers after `words`, the last of which is being typed.
std::vector<std::string> offered(const std::vector<std::string>& words) {
    const Folder folder;
    Definition definition;
    const std::string script = folder.write("completion", pelage::app::bash_completion(definition.app));
    std::string line =
        "compopt() { :; }; source '" + script + "'; COMP_WORDS=(";  // compopt works only while completing
    for (const std::string& word : words) line += "'" + word + "' ";
    line += "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _pelage; printf '%s\\n' \"${COMPREPLY[@]}\"";
    const Outcome outcome = test::Child({"bash", "-c", line}).wait();
    INFO(outcome.err);
    CHECK(outcome.err.empty());
    std::istringstream lines(outcome.out);
    std::vector<std::string> list;
    for (std::string one; std::getline(lines, one);) {
        if (!one.empty()) list.push_back(one);
    }
    return list;
}

std::string brought(const CLI::Validator& validator, std::string word) {
    const std::string failure = validator(word);
    return failure.empty() ? word : failure;
}

}  // namespace

TEST_CASE("a mistyped option is named with the one that was meant, and nothing else is blamed") {
    CHECK(refusal({"run", "x.pex", "--itertions", "5"}) ==
          "pelage: `pelage run` has no option '--itertions'; did you mean '--iterations'? (see `pelage run --help`)\n");
    CHECK(refusal({"run", "--itertions=5", "x.pex"}) ==
          "pelage: `pelage run` has no option '--itertions'; did you mean '--iterations'? (see `pelage run --help`)\n");
    CHECK_THAT(refusal({"run", "--bakend", "opencl"}), Contains("did you mean '--backend'?"));
    CHECK_THAT(refusal({"check", "--srict", "x.pex"}), Contains("`pelage check`") && Contains("'--strict'?"));
    CHECK_THAT(refusal({"run", "x.pex", "--xyzzy"}), Contains("'--xyzzy' (see") && !Contains("did you mean"));
    CHECK(refusal({"--fast", "run", "x.pex"}) ==
          "pelage: the option '--fast' comes after its command, as in `pelage run --fast`\n");
    CHECK_THAT(refusal({"--hlep"}), Contains("`pelage` has no option '--hlep'; did you mean '--help'?"));
    CHECK_THAT(refusal({"run", "x.pex", "y.pex"}), Contains("does not know what to do with 'y.pex'"));
    CHECK_THAT(refusal({"rum", "x.pex"}), Contains("there is no command 'rum'; there are: run, check"));
}

TEST_CASE("what is missing, too much or no choice is told in a sentence, with the word that was meant") {
    using Words = std::vector<std::string>;
    const auto said = [](const Words& words) {
        const std::string text = refusal(words);
        return text.substr(8, text.find(" (see") - 8);  // without "pelage: "
    };
    CHECK(said({"run"}) == "`pelage run` needs a FILE");
    CHECK(said({"completion"}) == "`pelage completion` needs a SHELL");
    CHECK(said({"run", "x", "--seed"}) == "the option '--seed' needs a value, N");
    CHECK(said({"run", "x", "--precision="}) == "the option '--precision' needs a value, float|double");
    CHECK(said({"run", "x", "--seed", "1", "--seed", "2"}) == "the option '--seed' is given more than once");
    CHECK(said({"run", "x", "--quiet=3"}) == "the option '--quiet' takes no value");
    CHECK(said({"check", "--strict=5", "x"}) == "the option '--strict' takes no value");
    CHECK(said({"--version=3"}) == "the option '--version' takes no value");
    CHECK(said({"run", "x", "--backend", "openc"}) ==
          "--backend: 'openc' is none of reference, opencl; did you mean 'opencl'?");
    CHECK(said({"run", "x", "--precision", "duoble"}) ==
          "--precision: 'duoble' is none of float, double; did you mean 'double'?");
    CHECK(said({"tune", "x", "--precision", "half"}) == "--precision: 'half' is none of float, double");
    CHECK(said({"tune", "x", "--limit", "0"}) == "--limit: '0' is not a number from 0.1 to 86400");
    CHECK(said({"completion", "bsh"}) == "SHELL: 'bsh' is none of bash, zsh; did you mean 'bash'?");
    CHECK_THAT(said({"run", "x", "--format", "npy,pgn"}), Contains("unknown format 'pgn'") && Contains("mean 'png'?"));
    CHECK_THAT(refusal({"bench", "--suite", "latice"}), Contains("did you mean 'lattice'?"));
    CHECK_THAT(refusal({"verify", "--quick", "--full"}), Contains("--quick and --full exclude each other"));
    CHECK(said({"--", "run", "x"}) == "a command comes first");
    CHECK(said({"check", "--"}) == "`pelage check` needs a FILE");
    CHECK(said({"run", "--", "x", "--fast"}) ==
          "`pelage run` does not know what to do with '--fast'; after '--' all words are files");
}

TEST_CASE("after -- a file may have any name") {
    const Folder folder;
    (void)folder.write("--spots.pex", test::spots);
    test::Surroundings there;
    there.folder = folder.path();

    CHECK(command({"check", "--strict", "--", "--spots.pex"}, there).exit_code == 0);
    CHECK(command({"run", "--backend", "reference", "-o", "out", "--", "--spots.pex"}, there).exit_code == 0);
}

TEST_CASE("help holds our own words alone, and the page of the command every option") {
    Definition definition;
    const std::string page = test::read_all(std::filesystem::path(PELAGE_SOURCE) / "docs" / "command.md");
    for (const CLI::App* one : pelage::app::commands_of(definition.app)) {
        const std::string name = one->get_name();
        const std::string help = pelage::app::help_of(definition.app, name);
        for (const char* raw : {"Excludes", "UINT", "TEXT=", "=1", "=300", "FLOAT", " INT"}) {
            INFO(name << " has " << raw);
            CHECK(help.find(raw) == std::string::npos);
        }
        // The commands that have a chapter of their own tell their options there.
        const std::size_t usage = page.find("\n    pelage " + name + " ", page.find("## Devices"));
        const std::size_t start = usage == std::string::npos ? 0 : usage;
        const std::string part = page.substr(start, page.find("\n## ", start) - start);
        for (const std::string& option : pelage::app::option_names(*one)) {
            if (option == "--help" || option == "-h") continue;
            const auto is_there = [&](char after) { return part.find(option + after) != std::string::npos; };
            INFO(name << " " << option);
            CHECK((is_there(' ') || is_there('`') || is_there(']') || is_there('|')));
        }
    }
}

TEST_CASE("whole numbers may be written as people write them") {
    using pelage::app::whole_number;
    const auto some = whole_number(1, 4'294'967'295);
    const auto any = whole_number(std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max());

    CHECK(brought(some, "1e3") == "1000");
    CHECK(brought(some, "2.5E2") == "250");
    CHECK(brought(some, "+7") == "7");
    CHECK(brought(some, "4294967295") == "4294967295");
    CHECK(brought(any, "-3") == "-3");
    CHECK(brought(any, "-1e3") == "-1000");
    CHECK(brought(any, "-9223372036854775808") == "-9223372036854775808");
    CHECK(brought(any, "9223372036854775807") == "9223372036854775807");
    for (const char* wrong :
         {"0", "4294967296", "1.5", "1e-3", "many", "", "-", "+-1", "--1", "1e3x", "nan", "inf", "1e300"}) {
        INFO(wrong);
        CHECK(brought(some, wrong) == "'" + std::string(wrong) + "' is not a whole number from 1 to 4294967295");
    }
    const auto sixteens = whole_number(32, 512, 16);
    CHECK(brought(sixteens, "4.8e1") == "48");
    for (const char* wrong : {"16", "40", "528"})
        CHECK(brought(sixteens, wrong) == "'" + std::string(wrong) + "' is not a multiple of 16 from 32 to 512");
    const auto some_number = pelage::app::number(0.5, 2);
    for (const char* right : {"0.5", "2", "+1", "1e0"}) CHECK(brought(some_number, right) == right);
    for (const char* wrong : {"0.4", "3", "nan", "", "+-1", "+", "1x"})
        CHECK(brought(some_number, wrong) == "'" + std::string(wrong) + "' is not a number from 0.5 to 2");
    for (const char* wrong : {"9223372036854775808", "-9223372036854775809", "99999999999999999999"}) {
        CHECK_THAT(brought(any, wrong), Contains("is not a whole number"));
    }
}

TEST_CASE("a run takes 1e1 iterations, formats with blanks between, and -o") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);

    const Outcome outcome = command({"run", file, "--backend", "reference", "--iterations", "1e1", "--seed", "1e3",
                                     "--format", "png, npy", "-o", folder / "here"});

    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const auto manifest = nlohmann::json::parse(test::read_all(folder / "here/manifest.json"));
    CHECK(manifest.at("iterations") == 10);
    CHECK(manifest.at("seed") == 1000);
    CHECK(std::filesystem::exists(folder / "here/final.png"));
    CHECK(std::filesystem::exists(folder / "here/final.U.npy"));
    CHECK_THAT(refusal({"run", file, "--iterations", "1.5"}), Contains("--iterations: '1.5' is not a whole number"));
    CHECK_THAT(refusal({"run", file, "--format", "png,,npy"}), Contains("unknown format ''"));
}

TEST_CASE("pelage alone shows what there is, help tells more") {
    const Outcome alone = command({});
    const Outcome help = command({"help"});
    const Outcome of_run = command({"help", "run"});

    CHECK(alone.exit_code == 2);
    for (const char* text : {"run", "check", "sweep", "measure", "devices", "verify", "bench", "tune",
                             "pelage run experiments/leopard.pex"})
        CHECK_THAT(alone.err, Contains(text));
    CHECK(help.exit_code == 0);
    CHECK(help.out == alone.err);
    CHECK(help.out == command({"--help"}).out);
    CHECK(of_run.exit_code == 0);
    CHECK(of_run.out == command({"run", "--help"}).out);
    CHECK_THAT(refusal({"help", "rnu"}),
               Contains("there is no command 'rnu'; there are: ") && Contains("; did you mean 'run'?"));
}

TEST_CASE("the manual and both completions hold every command and every option") {
    Definition definition;
    const std::string manual = pelage::app::manual(definition.app);
    const std::string bash = pelage::app::bash_completion(definition.app);
    const std::string zsh = pelage::app::zsh_completion(definition.app);
    std::size_t options = 0;

    for (const CLI::App* one : pelage::app::commands_of(definition.app)) {
        CHECK_THAT(manual, Contains(one->get_name()));
        CHECK_THAT(zsh, Contains("'" + one->get_name() + "'':'"));
        for (const pelage::app::OptionText& option : pelage::app::options_of(*one)) {
            for (const std::string& name : option.names) {
                std::string escaped;
                for (const char c : name) escaped += c == '-' ? "\\-" : std::string(1, c);
                CHECK_THAT(manual, Contains("\\fB" + escaped + "\\fR"));
                CHECK_THAT(zsh, Contains("'" + name + "['"));
                const std::vector<std::string> list = offered({"pelage", one->get_name(), name});
                CHECK(std::count(list.begin(), list.end(), name) == 1);
                ++options;
            }
        }
    }
    CHECK(options > 60);
    CHECK_THAT(manual, !Contains("worker"));
    CHECK_THAT(bash, !Contains("worker"));
    CHECK(command({"help", "--man"}).out == manual);
    CHECK(command({"completion", "bash"}).out == bash);
    CHECK(command({"completion", "zsh"}).out == zsh);
    CHECK_THAT(refusal({"completion", "fish"}), Contains("fish"));
}

TEST_CASE("bash offers commands, options and values") {
    using List = std::vector<std::string>;
    CHECK(offered({"pelage", "ch"}) == List{"check"});
    CHECK(offered({"pelage", "run", "--it"}) == List{"--iterations"});
    CHECK(offered({"pelage", "run", "x.pex", "--backend", ""}) == List{"reference", "opencl"});
    CHECK(offered({"pelage", "run", "--precision", "d"}) == List{"double"});
    CHECK(offered({"pelage", "help", "b"}) == List{"bench"});
    CHECK(offered({"pelage", "completion", ""}) == List{"bash", "zsh"});
    CHECK(offered({"pelage", "run", "--out", ""}).empty());  // bash itself offers files
    CHECK(offered({"pelage", "run", "--seed", ""}).empty());
}

TEST_CASE("the environment variable that names a device is told of where it is the cause") {
    const Folder folder;
    test::Surroundings surroundings;
    surroundings.environment["PELAGE_DEVICE"] = "quantum";

    const Outcome run = command({"run", folder.write("spots.pex", test::spots)}, surroundings);
    const Outcome verify = command({"verify"}, surroundings);

    for (const Outcome& outcome : {run, verify}) {
        CHECK(outcome.exit_code == 2);
        CHECK_THAT(outcome.err,
                   Contains("the environment variable PELAGE_DEVICE asks for 'quantum': no usable OpenCL"));
    }
}

TEST_CASE("a search without time for anything says so instead of an empty table") {
    pelage::app::Tuning tuning;
    tuning.seconds = 5.2;
    pelage::DeviceInfo device;
    device.name = "Radiant 9000";

    const std::string text = pelage::app::tuning_table(tuning, device);

    CHECK_THAT(text, Contains("Radiant 9000") && Contains("no time even for the defaults in 5.2 s") &&
                         Contains("Try again when the machine is less busy"));
    CHECK_THAT(text, !Contains("RANK"));
}

TEST_CASE("an empty value is refused, not taken for an option that was left out") {
    const test::Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    for (const char* option : {"--resume", "--out", "-o", "--json", "--device", "--format", "--seed"}) {
        const Outcome outcome = command({"run", file, option, ""});

        INFO(option << ": " << outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK_FALSE(outcome.err.empty());
    }
    CHECK(command({"verify", "--device", ""}).exit_code == 2);
    CHECK(command({"check", ""}).exit_code == 2);
    CHECK(test::names_in(folder.path()).size() == 1);
}

TEST_CASE("what the run reads is not replaced by --json") {
    const test::Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);

    const Outcome outcome =
        command({"run", file, "--backend", "reference", "--iterations", "2", "--json", file, "--out", folder / "out"});

    CHECK(outcome.exit_code == 2);
    CHECK_THAT(outcome.err, Contains("is what the run reads"));
    CHECK(test::read_all(file) == test::spots);
}

TEST_CASE("a run keeps what it includes and starts from: from --json, --video and its own results") {
    const test::Folder folder;
    std::filesystem::create_directories(folder / "out");
    std::filesystem::create_directories(folder / "parts/more");
    const std::string start = folder.write("parts/more/start.pex", "use chemical U conc 1\n");
    const std::string parts = folder.write("parts/all.pex", "include \"more/start.pex\"\n");
    const std::string shape = folder.write("out/final.txt", "oo\noo\n");
    const std::string file = folder.write(
        "a.pex", "define chemical U\ninclude \"parts/all.pex\"\ncreate shape \"out/final.txt\"\nstop at 2\n");
    const auto refused = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"run", file, "--backend", "reference", "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = command(words);
        CHECK(outcome.exit_code == 2);
        return outcome.err;
    };
    const std::string out = folder / "out", other = folder / "other";

    for (const std::string& read : {start, parts, shape, file, (folder / "parts/../a.pex").string()})
        CHECK(refused({"--out", other, "--json", read}) ==
              "pelage: --json " + read + " is what the run reads; name another file\n");
    CHECK_THAT(refused({"--out", out}), Contains("final.txt' is what the run reads, and its results would replace it"));
    CHECK_FALSE(std::filesystem::exists(other));
    CHECK(command({"run", file, "--backend", "reference", "--quiet", "--out", other}).exit_code == 0);

    std::filesystem::create_directories(folder / "again");
    const std::string drawn =
        folder.write("again/drawn.pex",
                     "define parameter p 1 from 0 to 2\ndefine chemical U\nuse chemical U conc p\ncreate cell 0 0\n");
    CHECK_THAT(command({"run", drawn, "--random", "3", "--out", folder / "again"}).err,
               Contains("choose another --out"));
}

TEST_CASE("no command writes over what it reads") {
    const test::Folder folder;
    std::filesystem::create_directories(folder / "out");
    const std::string spots = folder.write("spots.pex", test::spots);
    const std::string points = folder.write("out/sweep.csv", "p\n1\n2\n");
    const std::string sheet = folder.write("out/sheet.svg", "p\n1\n2\n");
    const std::string ratios = folder.write("ratios.json", "{}");
    const auto refused = [&](const std::vector<std::string>& words, const std::string& read) {
        const std::string before = test::read_all(read);
        const Outcome outcome = command(words);
        INFO(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK_THAT(outcome.err, Contains(read + " is ") && Contains("name another file"));
        CHECK(test::read_all(read) == before);
    };
    const std::string out = folder / "out";

    refused({"tune", spots, "--json", spots}, spots);
    refused({"bench", "--guard", ratios, "--json", ratios}, ratios);
    refused({"sweep", spots, "--points", points, "--out", out}, points);
    refused({"sweep", spots, "--points", sheet, "--sheet", "svg", "--out", out}, sheet);
}
