// The waist: all that the layers above know of a running simulation and of the machine that runs it.
#pragma once

#include "core/events.hpp"
#include "core/experiment.hpp"
#include "core/growth.hpp"
#include "core/neighbours.hpp"
#include "core/precision.hpp"
#include "core/resampling.hpp"
#include "core/snapshot.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pelage {

struct NonFinite {  // a concentration that is NaN or infinite
    std::size_t chemical = 0;
    std::size_t cell = 0;
};

struct ProgramCounts {         // for a device
    std::size_t compiled = 0;  // anew
    std::size_t cached = 0;    // compiled by an earlier run, and kept
};

// One running simulation. advance(a); advance(b) gives the bits of advance(a + b), on every backend.
// What only some tissues can do is an interface of its own: core/growable.hpp, core/searching.hpp.
// Public calls check their arguments once for all backends; the virtual calls below them do the work.
class Tissue {
public:
    virtual ~Tissue() = default;
    Tissue(const Tissue&) = delete;
    Tissue& operator=(const Tissue&) = delete;

    const Experiment& experiment() const { return *experiment_; }
    std::uint64_t iteration() const { return iteration_; }
    std::size_t cells() const { return do_cells(); }
    std::size_t columns() const { return columns_; }  // 0 for free cells
    std::size_t rows() const { return rows_; }
    std::size_t layers() const { return layers_; }  // 0 but for a volume

    // After advance() or write() has failed half-way the state is lost: every call but write() throws Error.

    // Carries out `iterations` whole iterations, with the events that fall into them (core/events.hpp).
    void advance(std::uint64_t iterations);

    Snapshot read() const;
    // The amounts of one chemical alone, in single precision; `to` keeps its memory from call to call. Throws Error
    // when there is no such chemical.
    void read_conc(std::size_t chemical, std::vector<float>& to) const;
    // Throws Error when the arrays do not fit the experiment, or hold what no run can come to: an iteration that is too
    // large, a cell born after it, a mirror pair of cells that are not there, on a lattice a rate below 0.
    void write(const Snapshot&);

    // The first cell, in order of chemical and id, that holds a NaN or an infinity.
    std::optional<NonFinite> non_finite() const;

    // How iterations have been carried out so far, a sentence each; empty where there is nothing to tell.
    virtual std::vector<std::string> report() const { return {}; }
    // The programs that its device runs; empty where there are none.
    virtual std::optional<ProgramCounts> programs() const { return {}; }

protected:
    // Takes iteration and shape from `initial`; the derived class takes the arrays.
    Tissue(std::shared_ptr<const Experiment>, const Snapshot& initial);

    // Throws Error when the state is lost.
    void check_whole() const;
    // Carries out `change`, by which the lattice takes that shape. Throws Error when it would have too many cells.
    void reshape(std::size_t columns, std::size_t rows, const std::function<void()>& change);

private:
    virtual std::size_t do_cells() const = 0;
    // Iterations first .. first + count - 1; no event comes between them.
    virtual void do_advance(std::uint64_t first, std::uint64_t count) = 0;
    virtual void do_set_rate(std::size_t chemical, double rate) = 0;  // of every cell
    virtual Snapshot do_read() const = 0;                             // iteration is filled in by read()
    virtual void do_read_conc(std::size_t chemical, std::vector<float>& to) const;
    virtual void do_write(const Snapshot&) = 0;
    virtual std::optional<NonFinite> do_non_finite() const = 0;

    void take_place(const NewPhase&);
    virtual void take_place(const Expansion&);  // see growable.hpp

    std::shared_ptr<const Experiment> experiment_;
    std::uint64_t iteration_ = 0;
    std::size_t columns_ = 0;
    std::size_t rows_ = 0;
    std::size_t layers_ = 0;
    bool lost_ = false;  // from the beginning of a change until it has succeeded
};

// Somewhere to run tissues: the reference, or one OpenCL device.
class Backend {
public:
    virtual ~Backend() = default;
    virtual std::string name() const = 0;  // "reference", "opencl: NAME OF DEVICE"
    virtual Precision precision() const = 0;
    virtual std::string why_not(const Experiment&) const = 0;  // empty: supported
    virtual std::unique_ptr<Tissue> make_tissue(const Experiment&, const Snapshot& initial) = 0;

    // From the experiment's own prepattern; a seed left to the clock is settled in the tissue's experiment.
    std::unique_ptr<Tissue> make_tissue(const Experiment&);
};

}  // namespace pelage
