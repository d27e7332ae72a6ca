// Numbers in VTK's XML files: as text, in base64, appended, and compressed by zlib.
#pragma once

#include "import/xml.hpp"

#include <cstddef>
#include <vector>

namespace pelage::imports {

// Exactly `count` numbers of a DataArray. Throws Error where the data are not as the headers say, before room is made
// for numbers that cannot be there.
std::vector<double> vtk_numbers(const XmlDocument&, const XmlElement& array, std::size_t count);

}  // namespace pelage::imports
