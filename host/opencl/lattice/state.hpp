// All that the cells of a lattice or a volume hold: on the device what kernels read or write, on the host what only has
// to be kept. Or those of several lattices of one structure, the members of a batch (batch.hpp): all planes of the
// first one lie before those of the second, and so on.
#pragma once

#include "core/fields.hpp"
#include "core/lattice.hpp"
#include "core/snapshot.hpp"
#include "opencl/lattice/expand.hpp"
#include "opencl/lattice/kept_cells.hpp"
#include "opencl/lattice/planes.hpp"
#include "opencl/lattice/resample.hpp"
#include "opencl/rules/emit_rules.hpp"

#include <cstdint>
#include <vector>

namespace pelage {

struct LatticeStart {  // of one member
    const Experiment& experiment;
    const Snapshot& state;
};

class LatticeState {
public:
    // `use`: what any rule may need, at any time. The experiments are kept by reference.
    LatticeState(const Session&, const std::vector<LatticeStart>&, const LatticePlan&, const RuleUse& use);

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

    const std::vector<double>& uniform_rates(std::size_t member = 0) const { return members_[member].rates; }
    void set_rate(std::size_t chemical, double rate, std::size_t member = 0);  // of every cell

    std::size_t running() const { return running_.size(); }  // members that are not ended
    const cl::Buffer& running_list();                        // their numbers
    void end(std::size_t member);                            // no step is carried out for it any more

    // Another one whenever rates or polarity have been changed other than by rules; never 0.
    std::uint64_t rates_version() const { return rates_version_; }

    // To be called when an iteration has been carried out: from then on each cell's count of neighbours is that of
    // its place.
    void counted();

    // Of one lattice alone.
    void expand(const Insertion&, std::uint64_t iteration);
    void stretch(const Resampling&, const std::vector<Bounds>&);  // bounds: one a chemical

    Snapshot read(std::size_t member = 0) const;

private:
    struct Member {
        const Experiment* experiment = nullptr;
        std::vector<double> rates;  // one a chemical, where it is that of every cell
        KeptCells kept;
    };

    Planes planes_of(const std::string& what, std::size_t of_a_member, bool integers = false) const;
    void take(std::size_t member, const LatticeStart&);
    void lay_out_places(const Snapshot&);
    void read_planes(std::size_t member, Snapshot&) const;
    Extent extent() const;
    void forget_counts();  // before a change of size
    void lay_out(const Grid&);
    void upload_places();

    const Session& session_;
    std::vector<Member> members_;
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
    std::vector<std::int32_t> running_;
    cl::Buffer running_list_;
    bool running_stale_ = true;
    bool counted_ = false;
    std::uint64_t rates_version_ = 1;
    std::vector<double> x_, y_;  // of the first row and column
    double origin_x_, origin_y_;
};

}  // namespace pelage
