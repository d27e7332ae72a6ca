// The ability of a lattice's tissue to take in columns and rows.
#pragma once

#include "core/tissue.hpp"

namespace pelage {

class Growable : public Tissue {
public:
    // Applies one insertion at once. Throws Error when its picks do not fit the matrix.
    void expand(const Insertion&);

protected:
    using Tissue::Tissue;

private:
    virtual void do_expand(const Insertion&) = 0;  // the duplicates are born in iteration()
    virtual void do_resample(const Resampling&) = 0;

    void take_place(const Expansion&) final;
    void insert(const Insertion&);
    void stretch(const Expand&);  // by interpolation
};

// Throws Error for a tissue of free cells.
Growable& growable(Tissue&);

}  // namespace pelage
