// Experiments, shapes and pictures as files.
#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "io/npy.hpp"
#include "io/sha256.hpp"
#include "language/parse.hpp"

#include <catch2/catch.hpp>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace pelage;
namespace fs = std::filesystem;

namespace {

class Folder {
public:
    Folder() : path_(fs::temp_directory_path() / ("pelage-language-" + std::to_string(::getpid()))) {
        fs::create_directories(path_);
    }
    ~Folder() { fs::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    fs::path write(const std::string& name, const std::string& bytes) const {
        fs::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name, std::ios::binary) << bytes;
        return path_ / name;
    }
    fs::path operator/(const std::string& name) const { return path_ / name; }

private:
    fs::path path_;
};

// A .npy file of 3 columns and 2 rows of double: 0, 0.25, 0.5 below 0.75, 1, 0.
std::string small_array() {
    std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }";
    header.resize(117, ' ');
    header += '\n';
    const double values[] = {0.0, 0.25, 0.5, 0.75, 1.0, 0.0};
    return std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(header.size()) + '\0' + header +
           std::string(reinterpret_cast<const char*>(values), sizeof values);
}

std::string message_of_file(const fs::path& file) {
    try {
        parse_experiment_file(file);
    } catch (const Error& error) {
        return error.what();
    }
    return "(none)";
}

}  // namespace

TEST_CASE("a shape stands beside its experiment, letters are cells") {
    const Folder folder;
    folder.write("deep/body.shp", "AoB\r\n. x\r\n\r\n1+b\r\n");
    const fs::path file =
        folder.write("deep/one.pex", "define chemical U\ncreate shape \"body.shp\" at 1 -2 fixed\nset cell 4 fixed\n");

    const Experiment e = parse_experiment_file(file);

    const auto shape = std::get<CreateShape>(e.prepattern.at(0));
    CHECK(shape.lines == std::vector<std::string>{"AoB", ". x", "", "1+b"});
    CHECK(shape.x == 1.0);
    CHECK(shape.y == -2.0);
    CHECK(shape.fixed);
    CHECK(count_cells(e) == 5);
    CHECK(e.source == file.string());
}

TEST_CASE("a shape may be named by its whole path") {
    const Folder folder;
    const fs::path shape = folder.write("body.shp", "oo\n");

    CHECK(count_cells(parse_experiment("define chemical U\ncreate shape \"" + shape.string() + "\"\n", "t.pex",
                                       "/nowhere")) == 2);
}

TEST_CASE("shapes that cannot be read") {
    const Folder folder;
    folder.write("empty.shp", "...\n");
    const auto message = [&](const std::string& name) {
        return message_of_file(folder.write("one.pex", "define chemical U\ncreate shape \"" + name + "\"\n"));
    };
    const std::string place = (folder / "one.pex").string() + ":2:14: ";

    CHECK(message("none.shp") == place + "shape '" + (folder / "none.shp").string() + "' is not a file");
    CHECK(message(".") == place + "shape '" + (folder / ".").string() + "' is not a file");
    CHECK(message("empty.shp") ==
          place + "shape '" + (folder / "empty.shp").string() + "' has no letter; each letter is a cell");
}

TEST_CASE("a chemical starts from an array, scaled between two values") {
    const Folder folder;
    folder.write("start.npy", small_array());
    const fs::path file = folder.write("one.pex",
                                       "define chemical U limit 9 conc \"start.npy\"\n"
                                       "define chemical V from 10 to 2 conc \"start.npy\" floor none\n"
                                       "create matrix 3 2\n");

    const Experiment e = parse_experiment_file(file);

    REQUIRE(e.chemicals.at(0).initial != nullptr);
    CHECK(e.chemicals[0].initial->columns == 3);
    CHECK(e.chemicals[0].initial->rows == 2);
    CHECK(e.chemicals[0].initial->values == std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0, 0.0});
    CHECK(e.chemicals.at(1).initial->values == std::vector<double>{10.0, 8.0, 6.0, 4.0, 2.0, 10.0});
    CHECK(initial_state(e).conc.at(1) == e.chemicals[1].initial->values);
}

TEST_CASE("pictures that do not fit or cannot be read say where they are named") {
    const Folder folder;
    folder.write("start.npy", small_array());
    const auto message = [&](const std::string& picture, const std::string& create) {
        return message_of_file(
            folder.write("one.pex", "define chemical U\ndefine chemical V conc \"" + picture + "\"\n" + create + "\n"));
    };
    const std::string place = (folder / "one.pex").string() + ":2:24: ";

    CHECK(message("start.npy", "create matrix 2 3") == place + "the picture is 3 x 2; the lattice is 2 x 3");
    CHECK(message("start.npy", "create hex_grid 3 2") ==
          place + "the picture is 3 x 2; only lattices start from pictures");
    CHECK(message("start.npy", "create sqr_grid 3 2") == "(none)");
    CHECK_THAT(message("none.npy", "create matrix 3 2"), Catch::StartsWith(place) && Catch::Contains("none.npy"));
    CHECK_THAT(message("one.pex", "create matrix 3 2"), Catch::StartsWith(place) && Catch::Contains("one.pex"));
}

TEST_CASE("numbers of arrays that no float can hold are refused, of starts and of fields") {
    const Folder folder;
    folder.write("one.pex", "");
    write_npy(folder / "large.npy", {2, 3}, std::vector<double>{0, 0, 0, 0, 1e300, 0});
    const auto message = [&](const std::string& line) {
        return message_of_file(folder.write("one.pex", line + "\ncreate matrix 3 2\n"));
    };
    const std::string told = "gives 1e+300 at row 1, column 1, which is beyond what a float can hold";

    CHECK_THAT(message("define chemical U conc \"large.npy\""), Catch::Contains(":1:24:") && Catch::Contains(told));
    CHECK_THAT(message("define chemical U\ndefine field f \"large.npy\""),
               Catch::Contains(":2:16:") && Catch::Contains(told));
}

TEST_CASE("an experiment names the files it starts from with their sums, pictures only where they are read") {
    const Folder folder;
    folder.write("start.npy", small_array());
    folder.write("body.shp", "oo\n");
    const std::string picture = "define chemical U conc \"start.npy\"\ncreate matrix 3 2\n";
    const fs::path lattice = folder.write("one.pex", picture);
    const fs::path cells = folder.write("two.pex", "define chemical U\ncreate shape \"body.shp\"\n");

    const Experiment read = parse_experiment_file(lattice);
    const Experiment shape = parse_experiment_file(cells);
    fs::remove(folder / "start.npy");
    const Experiment left_out = parse_experiment_file(lattice, nullptr, StartPictures::left_out);

    REQUIRE(read.inputs.size() == 1);
    CHECK(read.inputs[0].name == "start.npy");
    CHECK(read.inputs[0].sha256 == sha256(small_array()));
    REQUIRE(shape.inputs.size() == 1);
    CHECK(shape.inputs[0].name == "body.shp");
    CHECK(shape.inputs[0].sha256 == sha256("oo\n"));
    REQUIRE(left_out.inputs.size() == 1);
    CHECK(left_out.inputs[0].sha256.empty());
    CHECK(left_out.chemicals[0].initial == nullptr);
    CHECK(message_of_file(lattice).find("start.npy") != std::string::npos);
}

TEST_CASE("experiments that cannot be read") {
    const Folder folder;
    const std::string none = (folder / "none.pex").string();

    CHECK(message_of_file(none) == none + ": cannot be opened; give the name of an experiment file");
    CHECK(message_of_file(folder / ".") == (folder / ".").string() + ": is a folder; an experiment is a text file");
}
