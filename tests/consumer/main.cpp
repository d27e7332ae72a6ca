// An experiment built by hand, run on the reference and on OpenCL through the installed library, and compared.
#include <pelage/pelage.hpp>

#include <cstdio>
#include <set>

namespace {

// Turing's reaction on a torus of 37 x 23 cells.
pelage::Experiment spots() {
    pelage::Experiment experiment;
    experiment.chemicals = {{"U", {0.0, 10.0}, false, nullptr}, {"V", {0.0, 10.0}, false, nullptr}};
    experiment.prepattern = {
        pelage::UseChemical{0, pelage::Spread{4.0, 0.5}, pelage::Spread{10.0, 0.0}},
        pelage::UseChemical{1, pelage::Spread{4.0, 0.5}, pelage::Spread{2.0, 0.0}},
        pelage::CreateMatrix{37, 23, pelage::Boundary::wrap, 0.0, 0.0},
    };
    pelage::React react{pelage::model_named("turing"), {0, 1}, pelage::Operand::number(1.0), {}};
    react.parameters = {pelage::Operand::number(16.0), pelage::Operand::number(12.0)};
    pelage::Rule rule;
    rule.action = react;
    experiment.rules = {rule};
    experiment.phases = {{"", 0, 0.01, {{0.0, 10.0}, {0.0, 10.0}}, {std::nullopt, std::nullopt}}};
    experiment.outputs = {{0, {}, std::nullopt}};
    pelage::validate(experiment);
    return experiment;
}

pelage::Snapshot grown_on(pelage::Backend& backend, const pelage::Experiment& experiment) {
    const auto tissue = backend.make_tissue(experiment);
    tissue->advance(200);
    return tissue->read();
}

int compare() {
    const pelage::Experiment experiment = spots();
    const auto reference = pelage::reference_backend(pelage::Precision::single_);
    const auto opencl = pelage::opencl_backend();
    const pelage::Snapshot expected = grown_on(*reference, experiment);
    const pelage::Snapshot found = grown_on(*opencl, experiment);
    const std::set<double> values(expected.conc[0].begin(), expected.conc[0].end());
    std::printf("%zu cells, %zu different values, %s: %s\n", expected.cells(), values.size(), opencl->name().c_str(),
                found.conc == expected.conc ? "equal" : "different");
    return found.conc == expected.conc && values.size() > 100 ? 0 : 1;
}

}  // namespace

int main() {
    try {
        return compare();
    } catch (const pelage::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
