// react all|NAME ... neural "MODEL" [rate PAR] [diffusion PAR]: a reaction that a network computes.
#include "io/network.hpp"
#include "io/sha256.hpp"
#include "language/statements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>

namespace pelage::language {

namespace {

constexpr std::string_view neural_word = "neural";

// The chemicals before the word `neural`; `all` is every one that is defined.
std::vector<std::size_t> parse_reacting(Script& script, Cursor& cursor) {
    std::vector<std::size_t> species;
    if (!script.find_chemical("all") && cursor.take("all")) {
        for (std::size_t i = 0; i < script.experiment.chemicals.size(); ++i) species.push_back(i);
        return species;
    }
    while (cursor.peek().text != neural_word) {
        const Token& name = cursor.peek();
        const std::size_t chemical = script.chemical(cursor);
        if (std::ranges::find(species, chemical) != species.end())
            cursor.fail(name, fmt::format("'{}' is given twice; a network takes different chemicals", name.text));
        species.push_back(chemical);
    }
    return species;
}

std::shared_ptr<const Network> load_network(Script& script, const Cursor& cursor, const Token& file) {
    try {
        FoundNetwork found = read_network(script.resolve(file.text));
        for (const NetworkFile& part : found.files) {
            const std::filesystem::path name(file.text);
            script.experiment.inputs.push_back(
                {part.name.empty() ? name.string() : (name / part.name).string(), sha256(part.bytes), true});
        }
        return std::make_shared<const Network>(std::move(found.network));
    } catch (const Error& error) {
        cursor.fail(file, error.what());
    }
}

}  // namespace

bool is_neural(Cursor cursor) {
    while (!cursor.done()) {
        const Token& word = cursor.next();
        if (!word.quoted && word.text == neural_word && cursor.peek().quoted) return true;
    }
    return false;
}

Action parse_neural(Script& script, Cursor& cursor) {
    static constexpr std::array<std::string_view, 2> words{"rate", "diffusion"};
    const Token& first = cursor.peek();
    Neural neural;
    neural.species = parse_reacting(script, cursor);
    cursor.expect(neural_word);
    const Token& file = cursor.text("the network's name");
    neural.network = load_network(script, cursor, file);
    if (neural.species.size() != neural.network->chemicals)
        cursor.fail(first, fmt::format("the network takes {} chemicals; found {}", neural.network->chemicals,
                                       neural.species.size()));
    Options options(words);
    while (const auto option = options.next(cursor)) {
        Operand& operand = *option == 0 ? neural.rate : neural.diffusion;
        const Token& value = cursor.peek();
        operand = parse_operand(script, cursor, *option == 0 ? "the rate of the reaction" : "the rate of diffusion");
        if (*option == 1 && operand.quantity == Quantity::number && operand.value < 0.0)
            cursor.fail(value, fmt::format("the diffusion {} is below 0; every difference would grow without end",
                                           operand.value));
    }
    script.needs_places(cursor, file);
    return neural;
}

}  // namespace pelage::language
