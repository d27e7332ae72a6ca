// The processes that `mpirun` (or Slurm's srun) started together to share one task.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pelage::cluster {

struct Message {
    int from = 0;
    std::string text;
};

// One thread at a time calls what sends, receives and gathers.
class Ranks {
public:
    Ranks() = default;
    virtual ~Ranks() = default;
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    virtual int rank() const = 0;  // of this process, from 0
    virtual int count() const = 0;
    virtual int rank_here() const = 0;  // among those on this machine
    virtual int count_here() const = 0;

    virtual void send(int rank, const std::string& text) = 0;
    // What has arrived; waits up to a millisecond for it.
    virtual std::optional<Message> receive() = 0;
    // What each of them gives, in the order of ranks. Ends when all have called it.
    virtual std::vector<std::string> gather(const std::string& text) = 0;
};

// Null for a process that was started alone. Throws Error where several were started together and this build cannot
// speak to the others.
std::unique_ptr<Ranks> join_ranks();

}  // namespace pelage::cluster
