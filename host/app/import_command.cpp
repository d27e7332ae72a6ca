// `pelage import FILE`: makes an experiment of another program's file.
#include "app/commands.hpp"
#include "app/named_files.hpp"
#include "app/say.hpp"
#include "core/error.hpp"
#include "import/import.hpp"
#include "io/file_bytes.hpp"

#include <fmt/format.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

namespace pelage::app {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largest_import = std::uintmax_t{1} << 29;  // bytes of a file

struct ImportOptions {
    std::string file;
    std::string out;
    bool quiet = false;
};

bool is_address(const std::string& text) { return text.starts_with("https://") || text.starts_with("http://"); }

std::string bytes_to_import(const std::string& file) {
    if (is_address(file)) return file;
    std::error_code ignored;
    const std::uintmax_t size = fs::file_size(file, ignored);
    if (!ignored && size > largest_import)
        throw Error(fmt::format("{}: is longer than the {} bytes allowed", file, largest_import));
    return read_file(file);
}

// Beside the file, under its name; never over a file that is there.
fs::path place_of_result(const ImportOptions& options) {
    if (!options.out.empty()) {
        keep_inputs("-o", options.out, {options.file}, "what is imported");
        return options.out;
    }
    const fs::path place =
        is_address(options.file) ? fs::path("visualpde.pex") : fs::path(options.file).replace_extension(".pex");
    std::error_code ignored;
    if (fs::exists(place, ignored))
        throw Error(fmt::format("'{}' is there already; name the result with -o FILE", place.string()));
    return place;
}

void import_file(const ImportOptions& options) {
    const fs::path place = place_of_result(options);
    const std::string name = is_address(options.file) ? "the address" : options.file;
    const imports::Import made = imports::import_text(bytes_to_import(options.file), name, place.stem().string());
    for (const imports::Import::Picture& picture : made.pictures)
        keep_inputs("the array", place.parent_path() / picture.name, {options.file}, "what is imported");
    imports::write_import(made, place);
    if (options.quiet) return;
    say("{}\n", place.string());
    for (const imports::Import::Picture& picture : made.pictures)
        say("{}\n", (place.parent_path() / picture.name).string());
    send();
    for (const std::string& note : made.notes) say(stderr, "pelage: note: {}\n", note);
}

}  // namespace

void add_import(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<ImportOptions>();
    CLI::App* command =
        app.add_subcommand("import", "Make an experiment of a pattern of Ready or a preset of VisualPDE");
    command
        ->add_option("FILE", options->file, "A .vti of Ready, a .json of VisualPDE, or VisualPDE's address in quotes")
        ->required()
        ->type_name("");
    command->add_option("-o,--out", options->out, "The experiment [the file's name with .pex]")->type_name("FILE");
    command->add_flag("--quiet", options->quiet, "Say nothing but errors");
    command->callback([options, &exit_code] {
        import_file(*options);
        exit_code = success;
    });
}

}  // namespace pelage::app
