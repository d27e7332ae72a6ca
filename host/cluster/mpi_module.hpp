// What the command and its MPI module, which is opened at run time, agree upon.
#pragma once

#include "cluster/ranks.hpp"

namespace pelage::cluster {

inline constexpr const char* mpi_module_file = "pelage-mpi.so";
inline constexpr const char* mpi_module_entry = "pelage_make_mpi_ranks";

// Starts MPI; the object ends it.
using MakeRanks = Ranks* (*)();

}  // namespace pelage::cluster
