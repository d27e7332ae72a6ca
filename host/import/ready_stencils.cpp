// See ready_stencils.hpp. The weights are those that Ready takes; its Laplacian and bi-Laplacian are of Patra &
// Karttunen (2006), and its tri-Laplacian is the product of the two.
#include "import/ready_stencils.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdlib>
#include <string>

namespace pelage::imports {

namespace {

struct Known {
    std::string_view keyword;
    ReadyStencil stencil;
};

// A row of weights as a square, its other rows being 0.
ReadyStencil of_row(const std::vector<int>& row, int divisor, int powers_of_dx) {
    const std::size_t side = row.size();
    ReadyStencil stencil{std::vector<int>(side * side, 0), divisor, powers_of_dx};
    std::ranges::copy(row, stencil.weights.begin() + static_cast<std::ptrdiff_t>(side / 2 * side));
    return stencil;
}

const std::vector<Known>& of_lines() {
    static const std::vector<Known> all{{"laplacian", of_row({1, -2, 1}, 1, 2)},
                                        {"bilaplacian", of_row({1, -4, 6, -4, 1}, 1, 4)},
                                        {"trilaplacian", of_row({1, -6, 15, -20, 15, -6, 1}, 1, 6)},
                                        {"gaussian", of_row({1, 4, 6, 4, 1}, 16, 0)}};
    return all;
}

const std::vector<Known>& of_planes() {
    static const std::vector<Known> all{
        {"laplacian", {{1, 4, 1, 4, -20, 4, 1, 4, 1}, 6, 2}},
        {"bilaplacian",
         {{0, 1, 1, 1, 0, 1, -2, -10, -2, 1, 1, -10, 36, -10, 1, 1, -2, -10, -2, 1, 0, 1, 1, 1, 0}, 3, 4}},
        {"trilaplacian",
         {{0,   1,   5, 6, 5,   1, 0,   1, 6,   -33, -56, -33, 6,   1,   5,   -33, 6, 314, 6, -33, 5, 6, -56, 314, -888,
           314, -56, 6, 5, -33, 6, 314, 6, -33, 5,   1,   6,   -33, -56, -33, 6,   1, 0,   1, 5,   6, 5, 1,   0},
          18,
          6}},
        {"gaussian", {{1, 4, 7, 4, 1, 4, 16, 26, 16, 4, 7, 26, 41, 26, 7, 4, 16, 26, 16, 4, 1, 4, 7, 4, 1}, 273, 0}}};
    return all;
}

// Alike in lines and planes.
const std::vector<Known>& of_both() {
    static const std::vector<Known> all{{"x_gradient", of_row({-1, 0, 1}, 2, 1)},
                                        {"y_gradient", {{0, 1, 0, 0, 0, 0, 0, -1, 0}, 2, 1}},
                                        {"x_deriv3", of_row({-1, 2, 0, -2, 1}, 2, 3)},
                                        {"sobelN", {{1, 2, 1, 0, 0, 0, -1, -2, -1}, 1, 0}},
                                        {"sobelS", {{-1, -2, -1, 0, 0, 0, 1, 2, 1}, 1, 0}},
                                        {"sobelE", {{-1, 0, 1, -2, 0, 2, -1, 0, 1}, 1, 0}},
                                        {"sobelW", {{1, 0, -1, 2, 0, -2, 1, 0, -1}, 1, 0}},
                                        {"sobelNW", {{2, 1, 0, 1, 0, -1, 0, -1, -2}, 1, 0}},
                                        {"sobelNE", {{0, 1, 2, -1, 0, 1, -2, -1, 0}, 1, 0}},
                                        {"sobelSW", {{0, -1, -2, 1, 0, -1, 2, 1, 0}, 1, 0}},
                                        {"sobelSE", {{-2, -1, 0, -1, 0, 1, 0, 1, 2}, 1, 0}}};
    return all;
}

// Takes "n", "n2", ... off the front: how far along, 0 where it begins with neither letter.
int taken(std::string_view& text, char onward, char back) {
    if (text.empty() || (text[0] != onward && text[0] != back)) return 0;
    const int sign = text[0] == onward ? 1 : -1;
    text.remove_prefix(1);
    int far = 0;
    for (; !text.empty() && std::isdigit(static_cast<unsigned char>(text[0])) != 0 && far < 100; text.remove_prefix(1))
        far = 10 * far + (text[0] - '0');
    return sign * (far == 0 ? 1 : far);
}

}  // namespace

std::optional<ReadyStencil> ready_stencil(std::string_view keyword, bool one_dimensional) {
    std::string today(keyword);  // "sobel_ne" was "sobelNE", too
    if (today.starts_with("sobel_")) {
        today.erase(5, 1);
        std::transform(today.begin() + 5, today.end(), today.begin() + 5,
                       [](char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); });
    }
    for (const auto* table : {one_dimensional ? &of_lines() : &of_planes(), &of_both()}) {
        const auto found = std::ranges::find(*table, today, &Known::keyword);
        if (found != table->end()) return found->stencil;
    }
    return std::nullopt;
}

std::optional<ReadyOffset> ready_offset(std::string_view directions) {
    if (directions.empty()) return std::nullopt;
    (void)taken(directions, 'u', 'd');
    ReadyOffset offset;
    offset.up = taken(directions, 'n', 's');
    offset.right = taken(directions, 'e', 'w');
    if (!directions.empty()) return std::nullopt;
    return offset;
}

std::optional<ReadyStencil> ready_cell(ReadyOffset offset, bool one_dimensional) {
    if (one_dimensional) offset.up = 0;
    const int reach = std::max({1, std::abs(offset.up), std::abs(offset.right)});
    if (reach > 3) return std::nullopt;
    const int side = 2 * reach + 1;
    ReadyStencil stencil{std::vector<int>(static_cast<std::size_t>(side * side), 0), 1, 0};
    stencil.weights[static_cast<std::size_t>(side * (reach - offset.up) + reach + offset.right)] = 1;
    return stencil;
}

}  // namespace pelage::imports
