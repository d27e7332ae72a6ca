// What rules see of the space around the cells: fields, and how a chemical changes from a cell to its neighbours.
#pragma once

#include "core/error.hpp"
#include "core/experiment.hpp"

#include <vector>

namespace pelage::reference {

// That of free cells: none of it.
template <class T>
class Ground {
public:
    virtual ~Ground() = default;

    std::vector<std::vector<T>> fields;  // [field][cell]; those that are not there are computed where they are read
    std::vector<T> z;                    // [cell], of a mesh

    // For each cell, of values of all cells: the sum over its neighbours, each with its share of the stencil, of theirs
    // less the cell's own.
    virtual std::vector<T> laplacian(const std::vector<T>&) const { throw Error("free cells have no laplacian"); }
    // Half of what lies between the values on either side along that axis, where a neighbour that is not there has the
    // cell's own.
    virtual std::vector<T> gradient(const std::vector<T>&, Axis) const {
        throw Error("free cells have no gradient along rows and columns");
    }
    // For each cell the sum of the weights times the values of the cells around, from the lower left on; weights of 0
    // are left out, and an edge that lets nothing through repeats its cells outward.
    virtual std::vector<T> stencil(const NamedStencil&, const std::vector<T>&) const {
        throw Error("free cells have no stencil");
    }
};

}  // namespace pelage::reference
