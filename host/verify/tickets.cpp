// See sorting.hpp: points that took tickets of their bins, put in order.
#include "opencl/neighbours/tickets.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/device/launch.hpp"
#include "opencl/device/program.hpp"
#include "verify/sorting.hpp"

namespace pelage::verify {

std::vector<std::uint32_t> tidied_on_device(const Session& session, const std::vector<std::uint32_t>& starts,
                                            const std::vector<std::uint32_t>& order) {
    return with_device(session.info().name, [&] {
        Source source;
        for (const char* file : {"common/prelude.cl", "common/scan.cl", "common/sort.cl", "neighbours/bins.cl"})
            source.file(file);
        source.text(TicketSort::settings(session)).file("neighbours/tickets.cl");
        cl::Kernel tidy(session.build(source.str()), "pelage_tickets_tidy");
        const auto upload = [&](const std::vector<std::uint32_t>& words) {
            const cl::Buffer buffer = session.buffer(words.size() * sizeof words[0], "bins");
            session.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, words.size() * sizeof words[0], words.data());
            return buffer;
        };
        const auto bins = static_cast<std::uint32_t>(starts.size() - 1);
        const cl::Buffer of_starts = upload(starts), of_bins = upload({bins}), of_order = upload(order);
        pelage::Arguments(session, tidy).add(of_starts, of_bins, of_order);
        launch(session, tidy, bins, 3);
        std::vector<std::uint32_t> tidied(order.size());
        session.queue().enqueueReadBuffer(of_order, CL_TRUE, 0, tidied.size() * sizeof tidied[0], tidied.data());
        return tidied;
    });
}

}  // namespace pelage::verify
