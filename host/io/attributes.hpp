// Words that travel with results: seed, iteration, experiment text, device, driver, build options, version.
#pragma once

#include <map>
#include <string>

namespace pelage {

using Attributes = std::map<std::string, std::string>;

}  // namespace pelage
