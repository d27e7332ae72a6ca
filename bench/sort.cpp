// Micro benchmarks: the sort of keys, step by step; counting, scanning and scattering are timed apart.
#include "micro.hpp"
#include "opencl/device/program.hpp"

#include <random>

namespace {

using namespace pelage;

// Keys as bins give them: about one for every two and a half points.
class Sort {
public:
    explicit Sort(std::int64_t points)
        : session_(micro::session()), points_(micro::as_int(points)), chunks_(static_cast<cl_int>(units())) {
        Source source;
        source.file("common/prelude.cl").file("common/scan.cl").file("common/sort.cl");
        const cl::Program program = session_->build(source.str());
        count_ = cl::Kernel(program, "pelage_sort_count");
        sum_ = cl::Kernel(program, "pelage_sort_sum");
        scan_ = cl::Kernel(program, "pelage_sort_scan");
        scatter_ = cl::Kernel(program, "pelage_sort_scatter");
        const cl_int bins = std::max(1, points_ * 2 / 5);
        std::mt19937 random(1);
        std::vector<cl_int> keys(static_cast<std::size_t>(points_));
        for (cl_int& key : keys) key = static_cast<cl_int>(random() % static_cast<unsigned>(bins));
        const auto table = static_cast<std::size_t>(bins) * static_cast<std::size_t>(chunks_);
        keys_ = micro::filled(*session_, keys);
        bins_ = micro::filled(*session_, std::vector<cl_int>{bins});
        counts_ = micro::filled(*session_, std::vector<cl_int>(table));
        sums_ = micro::filled(*session_, std::vector<cl_int>(static_cast<std::size_t>(chunks_)));
        starts_ = micro::filled(*session_, std::vector<cl_int>(static_cast<std::size_t>(bins) + 1));
        sorted_ = micro::filled(*session_, keys);
        order_ = micro::filled(*session_, keys);
        order_before_ = micro::filled(*session_, keys);
    }

    void count() { run(count_, keys_, points_, chunks_, 0, 0, bins_, counts_); }
    void scan() {
        run(sum_, counts_, chunks_, 0, bins_, chunks_, sums_);
        run(scan_, counts_, points_, chunks_, 0, bins_, chunks_, sums_, starts_);
    }
    void scatter() { run(scatter_, keys_, order_before_, 1, points_, chunks_, 0, 0, bins_, counts_, sorted_, order_); }
    void finish() { session_->queue().finish(); }

private:
    std::size_t units() const { return std::max<std::size_t>(1, session_->info().compute_units); }

    template <class... Values>
    void run(cl::Kernel& kernel, const Values&... values) {
        cl_uint place = 0;
        (kernel.setArg(place++, values), ...);
        session_->queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(static_cast<std::size_t>(chunks_)),
                                               cl::NDRange(1));
    }

    std::shared_ptr<const Session> session_;
    cl_int points_, chunks_;
    cl::Kernel count_, sum_, scan_, scatter_;
    cl::Buffer keys_, bins_, counts_, sums_, starts_, sorted_, order_, order_before_;
};

void sort_whole(benchmark::State& state) {
    Sort sort(state.range(0));
    for (auto _ : state) {
        sort.count();
        sort.scan();
        sort.scatter();
        sort.finish();
    }
    micro::count_items(state, static_cast<double>(state.range(0)));
}

void sort_count(benchmark::State& state) {
    Sort sort(state.range(0));
    for (auto _ : state) {
        sort.count();
        sort.finish();
    }
    micro::count_items(state, static_cast<double>(state.range(0)));
}

// The counts are made anew each time, untimed: a scan consumes them.
void sort_scan(benchmark::State& state) {
    Sort sort(state.range(0));
    for (auto _ : state) {
        state.PauseTiming();
        sort.count();
        sort.finish();
        state.ResumeTiming();
        sort.scan();
        sort.finish();
    }
    micro::count_items(state, static_cast<double>(state.range(0)));
}

}  // namespace

BENCHMARK(sort_whole)->Arg(20'000)->Arg(1'000'000)->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK(sort_count)->Arg(20'000)->Arg(1'000'000)->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK(sort_scan)->Arg(20'000)->Arg(1'000'000)->Unit(benchmark::kMicrosecond)->UseRealTime();
