// See files.hpp.
#include "import/files.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

namespace test {

using namespace pelage;

namespace {

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
    return result;
}

}  // namespace

std::string text_of(const Pattern& pattern) {
    std::string parameters;
    for (const auto& [name, value] : pattern.parameters)
        parameters += fmt::format("      <param name=\"{}\"> {} </param>\n", name, value);
    return fmt::format(R"(<?xml version="1.0"?>
<VTKFile type="ImageData" version="0.1" {}>
  <RD format_version="4">
    <rule {}>
{}      <formula number_of_chemicals="{}">
{}
      </formula>
    </rule>
    {}
  </RD>
  <ImageData WholeExtent="{}" Origin="0 0 0" Spacing="1 1 1">
    <Piece Extent="{}">
      <PointData>{}</PointData>
    </Piece>
  </ImageData>{}
</VTKFile>
)",
                       pattern.file, pattern.rule, parameters, pattern.chemicals, escaped(pattern.formula),
                       pattern.generator, pattern.extent, pattern.extent, pattern.data, pattern.appended);
}

std::string overlay(const std::string& chemical, const std::string& inside) {
    const bool operation =
        inside.find("<add") == 0 || inside.find("<sub") == 0 || inside.find("<mul") == 0 || inside.find("<div") == 0;
    return fmt::format("<overlay chemical=\"{}\">{}{}</overlay>", chemical, operation ? "" : "<overwrite/>", inside);
}

imports::Import imported(const std::string& bytes) { return imports::import_text(bytes, "test.file", "test"); }

imports::Import imported(const Pattern& pattern) { return imported(text_of(pattern)); }

std::string refusal(const std::string& bytes) {
    try {
        (void)imported(bytes);
        return {};
    } catch (const Error& error) {
        return error.what();
    }
}

Snapshot run(const imports::Import& made, std::uint64_t iterations) {
    const Folder folder;
    imports::write_import(made, folder / "test.pex");
    const Experiment experiment = parse_experiment_file(folder / "test.pex");
    const auto tissue =
        reference_backend(Precision::double_)->make_tissue(experiment, initial_state(experiment, Precision::double_));
    tissue->advance(iterations);
    return tissue->read();
}

}  // namespace test
