// All that the cells of a lattice or a volume hold: on the device what kernels read or write, on the host what only has
// to be kept.
#pragma once

#include "core/fields.hpp"
#include "core/lattice.hpp"
#include "core/snapshot.hpp"
#include "opencl/lattice/expand.hpp"
#include "opencl/lattice/kept_field.hpp"
#include "opencl/lattice/planes.hpp"
#include "opencl/lattice/resample.hpp"
#include "opencl/rules/emit_rules.hpp"

#include <cstdint>
#include <vector>

namespace pelage {

class LatticeState {
public:
    // `use`: what any rule may need, at any time.
    LatticeState(const Session&, const Experiment&, const LatticePlan&, const RuleUse& use, const Snapshot&);

    const Grid& grid() const { return grid_; }  // the rows of a volume are those of all its layers, one after another
    std::size_t rows() const;                   // of a lattice, or of one layer
    std::size_t layers() const { return plan_.layers; }

    Planes& conc() { return conc_; }
    const Planes& conc() const { return conc_; }
    Planes& rates() { return rates_; }        // of chemicals with rates of their own
    Planes& polarity() { return polarity_; }  // x, y; empty unless the plan has polarity
    Planes& mappings() { return mappings_; }
    Planes& birth() { return birth_; }                    // empty unless rules read it
    Planes& neighbours() { return neighbours_; }          // empty unless rules read it
    Planes& fields();                                     // Experiment::fields, of the present size
    const cl::Buffer& places() const { return places_; }  // x of columns, padded to a pitch, then y of rows

    double uniform_rate(std::size_t chemical) const { return uniform_rates_[chemical]; }
    void set_rate(std::size_t chemical, double rate);  // of every cell

    // Another one whenever rates or polarity have been changed other than by rules; never 0.
    std::uint64_t rates_version() const { return rates_version_; }

    // To be called when an iteration has been carried out: from then on each cell's count of neighbours is that of
    // its place.
    void counted();

    void expand(const Insertion&, std::uint64_t iteration);
    void stretch(const Resampling&, const std::vector<Bounds>&);  // bounds: one a chemical
    Snapshot read() const;

private:
    Extent extent() const;
    void forget_counts();  // before a change of size
    void lay_out(const Grid&);
    void upload_places();
    std::vector<std::int32_t> count_neighbours() const;

    const Session& session_;
    const Experiment& experiment_;
    LatticePlan plan_;
    std::vector<std::size_t> rate_planes_;
    Grid grid_;
    Planes conc_;
    Planes rates_;
    Planes polarity_;
    Planes mappings_;
    Planes birth_;
    Planes neighbours_;
    Planes fields_;
    bool fields_stale_ = true;  // they are of another size
    PlaneExpander expander_;
    PlaneResampler resampler_;
    cl::Buffer places_;
    std::size_t places_capacity_ = 0;
    std::vector<double> uniform_rates_;
    bool counted_ = false;
    std::uint64_t rates_version_ = 1;
    // What is not on the device; of x and y the first row and column.
    std::vector<double> x_, y_;
    double origin_x_, origin_y_;
    KeptField<double> kept_polarity_x_, kept_polarity_y_;
    KeptField<std::uint32_t> kept_birth_;
    KeptField<std::int32_t> kept_neighbours_;
    KeptField<std::uint8_t> kept_fixed_;
    decltype(Snapshot::mirrors) mirrors_;
};

}  // namespace pelage
