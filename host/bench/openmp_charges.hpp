// The inner loops of the C++ baseline for aggregates: as openmp_rows.hpp, for charges and candidates.
#pragma once

#include <cstddef>
#include <cstdint>

namespace pelage::bench {

// Candidates in places; one that is nobody's has a column below 0.
struct CandidateArrays {
    const std::int32_t* x = nullptr;
    const std::int32_t* y = nullptr;
    std::int64_t* sums = nullptr;  // of 1 / r over the charges, in parts of 2^30
};

struct SumRange {
    std::int64_t least = INT64_MAX;
    std::int64_t most = INT64_MIN;
};

struct WeightNumbers {
    std::int64_t most = 0;  // the greatest sum, whose candidate weighs nothing
    std::int64_t down = 0;  // bits by which what is below it is shifted
    float scale = 0;        // 1 / of the whole range, shifted alike
    float eta = 0;
};

// Adds a charge to the sums of the places begin .. end - 1.
SumRange add_charge(const CandidateArrays&, std::size_t begin, std::size_t end, std::int32_t x, std::int32_t y);

// The sum at a place over `count` charges.
std::int64_t sum_of_charges(const std::int32_t* xs, const std::int32_t* ys, std::size_t count, std::int32_t x,
                            std::int32_t y);

// Weights of the places begin .. end - 1, and their sum.
std::uint64_t weigh(const CandidateArrays&, std::size_t begin, std::size_t end, const WeightNumbers&,
                    std::uint64_t* weights);

}  // namespace pelage::bench
