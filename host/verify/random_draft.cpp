// See random_draft.hpp.
#include "verify/random_draft.hpp"

#include <algorithm>

namespace pelage::verify {

std::string words(std::initializer_list<std::string> parts) {
    std::string joined;
    for (const std::string& part : parts) {
        if (!joined.empty() && !part.empty()) joined += ' ';
        joined += part;
    }
    return joined;
}

double Draft::largest_rate() const { return std::min(20.0, 2.0 / (stiffness * time_step)); }

std::string Draft::value(double low, double high) {
    if (limits.extremes && dice.below(150) == 0) {
        return dice.pick({"0", "-0", "1e-45", "-1e-40", "1.17549435e-38", "16777217", "1e30", "-3.4028234e38"});
    }
    return dice.number(low, high);
}

std::string Draft::deviated(double value_, double deviation) {
    const std::string middle = dice.number(value_);
    return deviation > 0.0 && dice.chance(70) ? words({middle, "dev", dice.number(deviation)}) : middle;
}

std::string Draft::shuffled(std::vector<std::string> options) {
    std::string joined;
    while (!options.empty()) {
        const auto next = options.begin() + static_cast<std::ptrdiff_t>(dice.below(options.size()));
        joined = words({joined, *next});
        options.erase(next);
    }
    return joined;
}

void Draft::line(const std::string& statement) {
    switch (dice.weighted({90, 3, 3, 2, 2})) {
        case 1:
            text += statement + "  // " + (dice.chance(50) ? "a remark" : "caf\xc3\xa9 \"quoted");
            break;
        case 2:
            text += "\n" + statement;
            break;
        case 3:
            text += "\t " + statement + " \t";
            break;
        case 4:
            text += statement + "\r";
            break;
        default:
            text += statement;
    }
    text += "\n";
}

}  // namespace pelage::verify
