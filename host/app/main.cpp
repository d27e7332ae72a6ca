// The `pelage` command: picks the subcommand and turns every error into one sentence and an exit code.
#include "app/last_will.hpp"
#include "app/obey.hpp"
#include "app/say.hpp"
#include "opencl/device/kernel_sources.hpp"
#include "opencl/device/schedule.hpp"

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <string_view>

namespace {

using pelage::app::complain;

// Children are silent: their parent has said it.
void tell_of_other_kernels(std::span<char*> arguments) {
    const std::string folder = pelage::kernels_folder();
    (void)pelage::scheduled("");  // says so where there is no such schedule
    for (const std::string_view argument : arguments) {
        if (argument == "--worker") return;
    }
    if (!folder.empty()) {
        (void)pelage::kernel_sources();  // says so where one of them is not there
        pelage::app::say(stderr, "note: kernels come from PELAGE_KERNELS, '{}', not from this program\n", folder);
    }
    if (!pelage::schedule().empty()) {
        pelage::app::say(stderr, "note: work is done in the order of PELAGE_SCHEDULE, '{}', and slowly\n",
                         pelage::schedule());
    }
}

}  // namespace

int main(int argc, char** argv) {
    pelage::app::prepare_printing();
    pelage::app::keep_ignored();
    pelage::app::tidy_when_killed();
    try {
        tell_of_other_kernels({argv, static_cast<std::size_t>(argc)});
        return pelage::app::obey(argc, argv);
    } catch (const std::bad_alloc&) {
        return complain("out of memory");
    } catch (const std::exception& error) {
        return complain(error.what());
    }
}
