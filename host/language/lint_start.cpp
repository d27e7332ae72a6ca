// Lints of how the tissue starts: statements that come too late, cells outside the domain, shapes that are none.
#include "core/counted.hpp"
#include "core/prepattern.hpp"
#include "core/space.hpp"
#include "core/starts.hpp"
#include "core/surface.hpp"
#include "language/lints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace pelage::language {

namespace {

bool creates(const Statement& statement) {
    return std::holds_alternative<CreateCell>(statement) || std::holds_alternative<CreateGrid>(statement) ||
           std::holds_alternative<CreateMatrix>(statement) || std::holds_alternative<CreateVolume>(statement) ||
           std::holds_alternative<CreateMesh>(statement) || std::holds_alternative<CreateShape>(statement);
}

bool uses(const Statement& statement) {
    return std::holds_alternative<UseChemical>(statement) || std::holds_alternative<UsePolarity>(statement);
}

// Half of the domain's width and height.
std::array<double, 2> half_domain(const Experiment& experiment) {
    const Domain& domain = experiment.domain;
    if (!domain.packed) return {domain.width / 2, domain.height / 2};
    const double side = std::sqrt(static_cast<double>(count_cells(experiment)) * domain.area) - 2;
    return {side / 2, side / 2};
}

// Cells that one `create` puts beyond the domain, its jitter drawn once.
std::size_t cells_outside(const Statement& create, const std::array<double, 2>& half) {
    Experiment alone;
    alone.prepattern = {create};
    const Snapshot state = initial_state(alone);
    std::size_t outside = 0;
    for (std::size_t i = 0; i < state.cells(); ++i) {
        if (std::fabs(state.x[i]) > half[0] || std::fabs(state.y[i]) > half[1]) ++outside;
    }
    return outside;
}

// A drawing holds letters; models and pictures hold numbers, or have a name that tells.
bool looks_like_data(const CreateShape& shape, const std::string& name) {
    static constexpr std::array<std::string_view, 12> foreign{".obj", ".ply", ".stl", ".off",  ".svg", ".png",
                                                              ".exr", ".npy", ".csv", ".json", ".xml", ".pex"};
    std::string ending = std::filesystem::path(name).extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (std::ranges::find(foreign, ending) != foreign.end()) return true;
    std::size_t letters = 0, digits = 0;
    for (const std::string& line : shape.lines) {
        for (const char c : line) {
            if (std::isdigit(static_cast<unsigned char>(c)) != 0) ++digits;
            if (std::isalpha(static_cast<unsigned char>(c)) != 0) ++letters;
        }
    }
    return digits > letters;
}

}  // namespace

void find_late_uses(const Sheet& sheet, Reporter& report) {
    const std::vector<Statement>& statements = sheet.experiment.prepattern;
    for (std::size_t i = statements.size(); i > 0 && !creates(statements[i - 1]); --i) {
        const Statement& statement = statements[i - 1];
        if (!uses(statement)) continue;
        std::string text = "no cells are created after this line, so it changes nothing";
        if (const auto* use = std::get_if<UseChemical>(&statement)) {
            const bool earlier = std::any_of(statements.begin(), statements.end() - 1, [&](const Statement& other) {
                const auto* before = std::get_if<UseChemical>(&other);
                return &other < &statement && before != nullptr && before->chemical == use->chemical;
            });
            if (!earlier) {
                text += fmt::format("; '{}' starts at 0 and does not diffuse",
                                    sheet.experiment.chemicals[use->chemical].name);
            }
        }
        report(sheet.place(sheet.outline.prepattern[i - 1]), text);
    }
}

void find_cells_outside(const Sheet& sheet, Reporter& report) {
    constexpr std::size_t most = 2'000'000;  // so that reading an experiment stays quick
    if (!std::holds_alternative<FreeCells>(space_of(sheet.experiment)) || count_cells(sheet.experiment) > most) return;
    const std::array<double, 2> half = half_domain(sheet.experiment);
    for (std::size_t i = 0; i < sheet.experiment.prepattern.size(); ++i) {
        const Statement& statement = sheet.experiment.prepattern[i];
        if (!creates(statement)) continue;
        const std::size_t outside = cells_outside(statement, half);
        if (outside == 0) continue;
        report(sheet.place(sheet.outline.prepattern[i]),
               fmt::format("{} outside the domain of {:.6g} x {:.6g} around (0, 0)",
                           counted(outside, "cell lies", "cells lie"), 2 * half[0], 2 * half[1]));
    }
}

void find_odd_starts(const Sheet& sheet, Reporter& report) {
    for (const StartFault& fault : start_faults(sheet.experiment)) {
        if (fault.refused || !fault.statement) continue;
        report(sheet.place(sheet.outline.prepattern[*fault.statement], fault.rate ? "diff" : "conc"), fault.text);
    }
}

void find_shapes_that_are_none(const Sheet& sheet, Reporter& report) {
    for (std::size_t i = 0; i < sheet.experiment.prepattern.size(); ++i) {
        const auto* shape = std::get_if<CreateShape>(&sheet.experiment.prepattern[i]);
        if (shape == nullptr) continue;
        Cursor words = sheet.read(sheet.outline.prepattern[i]);
        while (!words.done() && !words.peek().quoted) words.next();
        const Token& file = words.peek();
        if (!looks_like_data(*shape, std::string(file.text))) continue;
        report(words.place(file),
               fmt::format("\"{}\" does not look like a drawing; every letter in it becomes a cell", file.text));
    }
}

void find_mended_meshes(const Sheet& sheet, Reporter& report) {
    for (std::size_t i = 0; i < sheet.experiment.prepattern.size(); ++i) {
        const auto* mesh = std::get_if<CreateMesh>(&sheet.experiment.prepattern[i]);
        if (mesh == nullptr) continue;
        for (const std::string& note : mesh->surface->notes)
            report(sheet.place(sheet.outline.prepattern[i], "mesh"), "of the mesh, " + note);
    }
}

}  // namespace pelage::language
