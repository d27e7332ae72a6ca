// See scratch.hpp.
#include "scratch.hpp"

#include "core/error.hpp"

#include <sys/resource.h>
#include <unistd.h>
#include <algorithm>
#include <atomic>
#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace test {

namespace fs = std::filesystem;

Scratch::Scratch() {
    static std::atomic<int> serial{0};
    folder_ = fs::temp_directory_path() / ("pelage-io-" + std::to_string(getpid()) + "-" + std::to_string(serial++));
    fs::create_directories(folder_);
}

Scratch::~Scratch() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

std::vector<std::string> Scratch::names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

FileSizeLimit::FileSizeLimit(std::size_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    before_ = limit.rlim_cur;
    limit.rlim_cur = bytes;
    if (setrlimit(RLIMIT_FSIZE, &limit) != 0) throw std::runtime_error("the size of files cannot be limited");
}

FileSizeLimit::~FileSizeLimit() {
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = before_;
    setrlimit(RLIMIT_FSIZE, &limit);
}

void put(const fs::path& path, std::string_view bytes) {
    std::ofstream file(path, std::ios::binary);
    file << bytes;
    if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

std::string get(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read " + path.string());
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string error_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const pelage::Error& error) {
        return error.what();
    }
    return {};
}

std::size_t accepted_beginnings(std::string_view bytes, const std::function<void(std::string_view)>& parse) {
    std::size_t accepted = 0;
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        const std::string beginning(bytes.substr(0, length));  // a copy: reading past its end is seen by sanitizers
        accepted += error_of([&] { parse(beginning); }).empty();
    }
    return accepted;
}

std::size_t accepted_changes(std::string_view bytes, const std::function<void(std::string_view)>& parse) {
    std::size_t accepted = 0;
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        for (const char flip : {'\x01', '\x80', '\xff'}) {
            std::string changed(bytes);
            changed[at] = static_cast<char>(changed[at] ^ flip);
            accepted += error_of([&] { parse(changed); }).empty();
        }
    }
    return accepted;
}

pelage::Experiment experiment() {
    pelage::Experiment experiment;
    experiment.source = "spots.pex";
    experiment.text = "define chemical U\ndefine chemical V\n";
    experiment.chemicals = {{"U", {}, false, nullptr}, {"V", {}, false, nullptr}};
    experiment.phases = {{"development", 0, 1.0, {{}, {}}, {{}, {}}}, {"maintenance", 100, 1.0, {{}, {}}, {{}, {}}}};
    experiment.outputs = {{0, {}, {}}};
    return experiment;
}

namespace {

void fill(pelage::Snapshot& snapshot) {
    const auto count = snapshot.cells();
    snapshot.iteration = 42;
    snapshot.polarity_x.assign(count, 0.0);
    snapshot.polarity_y.assign(count, 0.0);
    snapshot.birth.assign(count, 0);
    snapshot.neighbours.assign(count, 8);
    snapshot.fixed.assign(count, 0);
    snapshot.conc.resize(2);
    snapshot.diff.resize(2);
    for (std::size_t i = 0; i < count; ++i) {
        snapshot.conc[0].push_back(0.5 + static_cast<double>(i));
        snapshot.conc[1].push_back(-0.25 * static_cast<double>(i));
        snapshot.diff[0].push_back(0.125);
        snapshot.diff[1].push_back(0.03125);
    }
}

}  // namespace

pelage::Snapshot lattice(std::size_t columns, std::size_t rows) {
    pelage::Snapshot snapshot;
    snapshot.columns = columns;
    snapshot.rows = rows;
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            snapshot.x.push_back((static_cast<double>(column) - static_cast<double>(columns) / 2.0) * 2 + 1);
            snapshot.y.push_back((static_cast<double>(row) - static_cast<double>(rows) / 2.0) * 2 + 1);
        }
    }
    fill(snapshot);
    return snapshot;
}

pelage::Snapshot cells(const std::vector<double>& x, const std::vector<double>& y) {
    pelage::Snapshot snapshot;
    snapshot.x = x;
    snapshot.y = y;
    fill(snapshot);
    return snapshot;
}

}  // namespace test
