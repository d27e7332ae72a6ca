// Ranks by MPI, as a module: see mpi_module.hpp.
#include "cluster/mpi_module.hpp"

#include <mpi.h>

#include <chrono>
#include <numeric>
#include <thread>

namespace pelage::cluster {

namespace {

class MpiRanks : public Ranks {
public:
    MpiRanks() {
        int provided = 0;
        MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
        MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
        MPI_Comm_size(MPI_COMM_WORLD, &count_);
        MPI_Comm here;
        MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &here);
        MPI_Comm_rank(here, &rank_here_);
        MPI_Comm_size(here, &count_here_);
        MPI_Comm_free(&here);
    }

    ~MpiRanks() override { MPI_Finalize(); }

    int rank() const override { return rank_; }
    int count() const override { return count_; }
    int rank_here() const override { return rank_here_; }
    int count_here() const override { return count_here_; }

    void send(int rank, const std::string& text) override {
        MPI_Send(text.data(), static_cast<int>(text.size()), MPI_BYTE, rank, 0, MPI_COMM_WORLD);
    }

    std::optional<Message> receive() override {
        MPI_Status status;
        if (!arrived(status)) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            if (!arrived(status)) return std::nullopt;
        }
        int size = 0;
        MPI_Get_count(&status, MPI_BYTE, &size);
        Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')};
        MPI_Recv(message.text.data(), size, MPI_BYTE, message.from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        return message;
    }

    std::vector<std::string> gather(const std::string& text) override {
        const int size = static_cast<int>(text.size());
        std::vector<int> sizes(static_cast<std::size_t>(count_)), starts(sizes.size());
        MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, MPI_COMM_WORLD);
        std::exclusive_scan(sizes.begin(), sizes.end(), starts.begin(), 0);
        std::string all(static_cast<std::size_t>(starts.back() + sizes.back()), '\0');
        MPI_Allgatherv(text.data(), size, MPI_BYTE, all.data(), sizes.data(), starts.data(), MPI_BYTE, MPI_COMM_WORLD);
        std::vector<std::string> texts;
        for (std::size_t i = 0; i < sizes.size(); ++i)
            texts.push_back(all.substr(static_cast<std::size_t>(starts[i]), static_cast<std::size_t>(sizes[i])));
        return texts;
    }

private:
    static bool arrived(MPI_Status& status) {
        int there = 0;
        MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &there, &status);
        return there != 0;
    }

    int rank_ = 0, count_ = 1, rank_here_ = 0, count_here_ = 1;
};

}  // namespace

}  // namespace pelage::cluster

extern "C" pelage::cluster::Ranks* pelage_make_mpi_ranks() { return new pelage::cluster::MpiRanks; }
