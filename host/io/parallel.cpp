// See parallel.hpp.
#include "io/parallel.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

namespace pelage {
namespace {

class Queue {
public:
    explicit Queue(const std::vector<std::function<void()>>& work) : work_(work), problems_(work.size()) {}

    void take_all() {
        while (const auto* piece = next()) {
            const auto index = static_cast<std::size_t>(piece - work_.data());
            try {
                (*piece)();
            } catch (...) {
                const std::lock_guard guard(lock_);
                problems_[index] = std::current_exception();
                next_ = work_.size();
            }
        }
    }

    void complain() const {
        for (const auto& problem : problems_) {
            if (problem) std::rethrow_exception(problem);
        }
    }

private:
    const std::function<void()>* next() {
        const std::lock_guard guard(lock_);
        return next_ < work_.size() ? &work_[next_++] : nullptr;
    }

    const std::vector<std::function<void()>>& work_;
    std::vector<std::exception_ptr> problems_;
    std::size_t next_ = 0;
    std::mutex lock_;
};

}  // namespace

void run_together(const std::vector<std::function<void()>>& work, std::size_t threads) {
    Queue queue(work);
    std::vector<std::jthread> helpers;
    try {
        for (std::size_t i = 1; i < std::min(threads, work.size()); ++i) {
            helpers.emplace_back([&] { queue.take_all(); });
        }
    } catch (const std::system_error&) {  // the system grants no more threads; those that are there do the work
    }
    queue.take_all();
    helpers.clear();
    queue.complain();
}

}  // namespace pelage
