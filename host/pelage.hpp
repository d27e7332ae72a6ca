// All of Pelage for programs that use it: #include <pelage/pelage.hpp>. An experiment is parsed or made by hand, a
// backend makes a tissue of it, the tissue advances and is read, and what was read is written to files.
#pragma once

#include "core/error.hpp"
#include "core/experiment.hpp"
#include "core/growable.hpp"
#include "core/prepattern.hpp"
#include "core/snapshot.hpp"
#include "core/space.hpp"
#include "core/stability.hpp"
#include "core/tissue.hpp"
#include "io/checkpoint.hpp"
#include "io/csv.hpp"
#include "io/npy.hpp"
#include "io/picture.hpp"
#include "io/results.hpp"
#include "io/vtk.hpp"
#include "language/lint.hpp"
#include "language/parse.hpp"
#include "opencl/backend.hpp"
#include "opencl/device/device.hpp"
#include "reference/backend.hpp"
