// See loss.hpp. On a torus every pixel is the lower left corner of a patch.
#include "reference/learn/loss.hpp"

#include "reference/common/with_fma.hpp"
#include "reference/functions/numbers.hpp"
#include "reference/learn/sums.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace pelage::reference {

namespace {

template <class T>
using Planes = std::vector<T>;  // [colour][pixel] of a level

// Each pixel is the mean of four.
template <class T>
Planes<T> halved(const Planes<T>& picture, std::size_t side) {
    const std::size_t half = side / 2;
    Planes<T> smaller(picture_colours * half * half);
    for (std::size_t pixel = 0; pixel < smaller.size(); ++pixel) {
        const std::size_t colour = pixel / (half * half), row = pixel / half % half, column = pixel % half;
        const T* four = picture.data() + colour * side * side + 2 * row * side + 2 * column;
        smaller[pixel] = T(0.25) * ((four[0] + four[1]) + (four[side] + four[side + 1]));
    }
    return smaller;
}

// One level of one sample, seen along the directions of a set.
template <class T>
class View {
public:
    View(const LearningTask& task, std::size_t set, std::size_t level, Planes<T> picture)
        : shape_(task.shape),
          level_(level),
          side_(task.shape.level_side(level)),
          pixels_(side_ * side_),
          set_(set),
          ranked_(task.ranked.data()),
          directions_(
              task.directions.begin() + static_cast<std::ptrdiff_t>((set * pyramid_levels + level) * numbers),
              task.directions.begin() + static_cast<std::ptrdiff_t>((set * pyramid_levels + level + 1) * numbers)) {
        look(picture);
        sort();
    }

    // The mean square distance to a rotation of the target along one direction, without the division.
    T distance(std::size_t rotation, std::size_t direction) const {
        std::array<T, sum_lanes> lanes{};
        for (std::size_t rank = 0; rank < pixels_; ++rank) {
            const T apart = apart_at(rotation, direction, rank);
            lanes[rank % sum_lanes] = std::fma(apart, apart, lanes[rank % sum_lanes]);
        }
        return folded(lanes.data(), sum_lanes);
    }

    // Of `factor` times half the squares, along each pixel.
    Planes<T> slopes(std::size_t rotation, T factor) const {
        std::vector<T> along(pixels_ * patch_directions);
        for (std::size_t direction = 0; direction < patch_directions; ++direction) {
            for (std::size_t rank = 0; rank < pixels_; ++rank)
                along[order_[direction][rank] * patch_directions + direction] =
                    factor * apart_at(rotation, direction, rank);
        }
        Planes<T> result(picture_colours * pixels_);
        for (std::size_t pixel = 0; pixel < result.size(); ++pixel)
            result[pixel] = slope_at(along, pixel / pixels_, pixel / side_ % side_, pixel % side_);
        return result;
    }

private:
    static constexpr std::size_t numbers = patch_numbers * patch_directions;

    std::size_t beyond(std::size_t place, std::size_t offset) const { return (place + offset) % side_; }

    T apart_at(std::size_t rotation, std::size_t direction, std::size_t rank) const {
        const std::size_t all = shape_.level_begin(pyramid_levels);
        const std::size_t place =
            ((set_ * shape_.rotations + rotation) * all + shape_.level_begin(level_)) * patch_directions +
            direction * pixels_ + rank;
        return seen_[direction * pixels_ + order_[direction][rank]] - static_cast<T>(ranked_[place]);
    }

    void look(const Planes<T>& picture) {
        seen_.resize(patch_directions * pixels_);
        for (std::size_t pixel = 0; pixel < pixels_; ++pixel) {
            std::array<T, patch_directions> sums{};
            for (std::size_t number = 0; number < patch_numbers; ++number) {
                const std::size_t colour = number / (patch_side * patch_side);
                const std::size_t row = beyond(pixel / side_, number / patch_side % patch_side);
                const T value = picture[colour * pixels_ + row * side_ + beyond(pixel % side_, number % patch_side)];
                const T* along = directions_.data() + number * patch_directions;
                for (std::size_t n = 0; n < patch_directions; ++n) sums[n] = std::fma(value, along[n], sums[n]);
            }
            for (std::size_t n = 0; n < patch_directions; ++n) seen_[n * pixels_ + pixel] = sums[n];
        }
    }

    // Bits of a number as a whole number that is larger where the number is; of equal numbers the first pixel is first.
    static functions::Bits<T> key(T value) {
        const auto bits = functions::bits_of(value);
        return (bits & functions::sign_bit<T>) != 0 ? ~bits : bits | functions::sign_bit<T>;
    }
    void sort() {
        order_.assign(patch_directions, std::vector<std::size_t>(pixels_));
        for (std::size_t direction = 0; direction < patch_directions; ++direction) {
            std::iota(order_[direction].begin(), order_[direction].end(), std::size_t{0});
            const T* seen = seen_.data() + direction * pixels_;
            std::ranges::stable_sort(order_[direction], {}, [seen](std::size_t pixel) { return key(seen[pixel]); });
        }
    }

    // A pixel is a part of all patches that begin up to six rows below it and up to six columns before it.
    T slope_at(const std::vector<T>& along, std::size_t colour, std::size_t row, std::size_t column) const {
        std::array<T, patch_directions> lanes{};
        for (std::size_t place = 0; place < patch_side * patch_side; ++place) {
            const std::size_t from = beyond(row, side_ - place / patch_side) * side_;
            const std::size_t patch = from + beyond(column, side_ - place % patch_side);
            const T* direction = directions_.data() + (colour * patch_side * patch_side + place) * patch_directions;
            for (std::size_t n = 0; n < patch_directions; ++n)
                lanes[n] = std::fma(direction[n], along[patch * patch_directions + n], lanes[n]);
        }
        return folded(lanes.data(), patch_directions);
    }

    const LearningShape& shape_;
    std::size_t level_, side_, pixels_, set_;
    const float* ranked_;
    std::vector<T> directions_;
    std::vector<T> seen_;  // [direction][pixel]
    std::vector<std::vector<std::size_t>> order_;
};

template <class T>
std::vector<View<T>> views_of(const LearningTask& task, std::size_t set, const T* state) {
    std::vector<View<T>> views;
    Planes<T> picture(state, state + picture_colours * task.shape.cells());
    for (std::size_t level = 0; level < pyramid_levels; ++level) {
        if (level > 0) picture = halved(picture, task.shape.level_side(level - 1));
        views.emplace_back(task, set, level, picture);
    }
    return views;
}

double share_of_one(const LearningShape& shape, std::size_t level) {
    return 1.0 / static_cast<double>(shape.level_cells(level) * patch_directions);
}

template <class T>
SampleLoss<T> nearest_target(const LearningShape& shape, const std::vector<View<T>>& views) {
    SampleLoss<T> best;
    for (std::size_t rotation = 0; rotation < shape.rotations; ++rotation) {
        T value = 0;
        for (std::size_t level = 0; level < pyramid_levels; ++level) {
            const T share = static_cast<T>(share_of_one(shape, level));
            for (std::size_t direction = 0; direction < patch_directions; ++direction)
                value = std::fma(share, views[level].distance(rotation, direction), value);
        }
        if (rotation == 0 || value < best.value) best = {value, rotation};
    }
    return best;
}

// From the smallest level to the picture itself.
template <class T>
Planes<T> picture_slopes(const LearningShape& shape, const std::vector<View<T>>& views, std::size_t rotation) {
    Planes<T> slopes;
    for (std::size_t level = pyramid_levels; level-- > 0;) {
        const double factor = 2 * share_of_one(shape, level) / static_cast<double>(shape.batch);
        Planes<T> own = views[level].slopes(rotation, static_cast<T>(factor));
        const std::size_t side = shape.level_side(level), half = side / 2;
        for (std::size_t pixel = 0; pixel < own.size() && !slopes.empty(); ++pixel) {
            const std::size_t row = pixel / side / 2, column = pixel % side / 2;  // rows count on through the colours
            own[pixel] = std::fma(T(0.25), slopes[row * half + column], own[pixel]);
        }
        slopes = std::move(own);
    }
    return slopes;
}

// What all chemicals have beyond -1 and 1.
template <class T>
T excess(const LearningShape& shape, const T* state) {
    T total = 0;
    for (std::size_t run = 0; run < cell_runs; ++run) {
        const std::size_t begin = std::min(run * shape.run_cells(), shape.cells());
        const std::size_t end = std::min(begin + shape.run_cells(), shape.cells());
        std::array<T, sum_lanes> lanes{};
        for (std::size_t i = 0; i < shape.chemicals; ++i) {
            for (std::size_t cell = begin; cell < end; ++cell) {
                const T over = std::fabs(state[i * shape.cells() + cell]) - T(1);
                T& lane = lanes[(cell - begin) % sum_lanes];
                lane = lane + (over > T(0) ? over : T(0));
            }
        }
        total = total + folded(lanes.data(), sum_lanes);
    }
    return total;
}

template <class T>
PELAGE_INLINE SampleLoss<T> loss_here(const LearningTask& task, std::size_t set, const T* state, T* slopes) {
    const LearningShape& shape = task.shape;
    const std::vector<View<T>> views = views_of(task, set, state);
    SampleLoss<T> loss = nearest_target(shape, views);
    const Planes<T> of_picture = picture_slopes(shape, views, loss.rotation);
    const double weight = task.overflow / static_cast<double>(shape.cells());
    loss.value = std::fma(static_cast<T>(weight), excess(shape, state), loss.value);
    const T push = static_cast<T>(weight / static_cast<double>(shape.batch));
    for (std::size_t place = 0; place < shape.sample(); ++place) {
        const T over = state[place] > T(1) ? push : state[place] < T(-1) ? -push : T(0);
        slopes[place] = place < of_picture.size() ? of_picture[place] + over : over;
    }
    return loss;
}

#ifdef PELAGE_WITH_FMA
template <class T>
PELAGE_WITH_FMA SampleLoss<T> loss_with_fma(const LearningTask& task, std::size_t set, const T* state, T* slopes) {
    return loss_here(task, set, state, slopes);
}
#endif

}  // namespace

template <class T>
SampleLoss<T> sample_loss(const LearningTask& task, std::size_t set, const T* state, T* slopes) {
#ifdef PELAGE_WITH_FMA
    if (runs_with_fma()) return loss_with_fma(task, set, state, slopes);
#endif
    return loss_here(task, set, state, slopes);
}

template SampleLoss<float> sample_loss(const LearningTask&, std::size_t, const float*, float*);
template SampleLoss<double> sample_loss(const LearningTask&, std::size_t, const double*, double*);

}  // namespace pelage::reference
