// PoCL, which makes a device of the CPU: what it must be told before it starts. It reads the environment once.
#pragma once

#include <filesystem>
#include <string>

namespace pelage {

inline constexpr const char* pocl_platform = "Portable Computing Language";

// To be called before the first OpenCL call of the process; later calls do nothing, nor does it change what an
// application has started itself. Sets in the environment:
//   POCL_MAX_PTHREAD_COUNT  unless set to a sensible number: where this process may use fewer processors than there
//                           are, that many
//   POCL_AFFINITY           0 where PoCL would bind its threads to processors that this process may not use, which ends
//                           the process; 1, unless set, where all the machine's processors are ours, and no other rank
//                           of an MPI run is here
//   POCL_CACHE_DIR          a private folder, gone with the process, in the one that was set or else in one for
//                           temporary files: what PoCL finds damaged in a folder of long life ends the process, too.
//                           Compiled programs are kept in our own cache; see pocl_programs.hpp.
void prepare_pocl();

// The processes that this one starts from now on work beside each other: they leave POCL_AFFINITY 0, unless it was set.
// Otherwise threads of several that compile wait for one processor while another idles.
void share_processors();

// The private folder; empty when there is none.
std::filesystem::path pocl_folder();
const char* pocl_folder_name();  // the same, null when there is none; a signal handler may ask

// Why PoCL cannot work here, though it may be installed; empty: nothing is known.
std::string pocl_trouble();

}  // namespace pelage
