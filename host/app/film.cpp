// See film.hpp.
#include "app/film.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <new>
#include <system_error>
#include <utility>

namespace pelage::app {

namespace {

constexpr double waiting_bytes = 64.0 * (1 << 20);
constexpr std::size_t fewest_waiting = 2;
constexpr std::size_t most_waiting = 16;

std::size_t shots_that_wait(const FilmPlan& plan, const Experiment& experiment, double cells) {
    const double fitting = waiting_bytes / std::max(1.0, Shot::bytes(plan, experiment, cells));
    return std::clamp(static_cast<std::size_t>(fitting), fewest_waiting, most_waiting);
}

}  // namespace

double Film::bytes(const FilmPlan& plan, const Experiment& experiment, double cells) {
    constexpr double frame_bytes = 3 + 3 + 3;  // of a pixel: the picture, the frame, and what ffmpeg takes
    const FrameSize frame = plan.frame.value_or(FrameSize{800, 800});
    const auto shots = static_cast<double>(shots_that_wait(plan, experiment, cells) + 2);
    return shots * Shot::bytes(plan, experiment, cells) + frame_bytes * static_cast<double>(frame.columns * frame.rows);
}

Film::Film(FilmPlan plan, const Tissue& tissue, const CellDrawing& drawing)
    : plan_(std::move(plan)),
      experiment_(tissue.experiment()),
      most_(shots_that_wait(plan_, experiment_, static_cast<double>(tissue.cells()))),
      file_(plan_.file) {
    Shot first;
    first.take(plan_, tissue);
    painter_.emplace(plan_, experiment_, drawing, first);
    ffmpeg_.emplace(plan_.arguments(painter_->frame(), file_.aside()));
    waiting_.push_back(std::move(first));
    frames_ = 1;
    try {
        thread_ = std::thread([this] { draw_all(); });
    } catch (const std::system_error&) {
        throw Error("the system grants no thread to draw a film in");
    }
}

Film::~Film() {
    fail("it was given up");
    if (ffmpeg_) ffmpeg_->stop();
    close();
}

void Film::take(const Tissue& tissue) {
    Shot shot;
    {
        const auto start = std::chrono::steady_clock::now();
        std::unique_lock guard(lock_);
        changed_.wait(guard, [this] { return waiting_.size() < most_ || !failure_.empty(); });
        waited_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        if (!failure_.empty()) return;
        if (!used_.empty()) {
            shot = std::move(used_.back());
            used_.pop_back();
        }
    }
    shot.take(plan_, tissue);
    const std::lock_guard guard(lock_);
    waiting_.push_back(std::move(shot));
    ++frames_;
    changed_.notify_all();
}

std::optional<Shot> Film::next_shot() {
    std::unique_lock guard(lock_);
    changed_.wait(guard, [this] { return !waiting_.empty() || closed_ || !failure_.empty(); });
    if (waiting_.empty() || !failure_.empty()) return std::nullopt;
    Shot shot = std::move(waiting_.front());
    waiting_.erase(waiting_.begin());
    changed_.notify_all();
    return shot;
}

void Film::draw_all() {
    try {
        while (auto shot = next_shot()) {
            painter_->paint(*shot, bytes_);
            ffmpeg_->write(bytes_.data(), bytes_.size());
            const std::lock_guard guard(lock_);
            used_.push_back(std::move(*shot));
        }
        if (failure().empty()) ffmpeg_->finish();
    } catch (const std::bad_alloc&) {
        fail("there is not enough memory to draw it");
    } catch (const std::exception& error) {
        fail(error.what());
    }
}

void Film::fail(const std::string& reason) {
    const std::lock_guard guard(lock_);
    if (failure_.empty()) failure_ = fmt::format("the film '{}' could not be made: {}", plan_.file.string(), reason);
    changed_.notify_all();
}

std::string Film::failure() const {
    const std::lock_guard guard(lock_);
    return failure_;
}

void Film::close() {
    {
        const std::lock_guard guard(lock_);
        closed_ = true;
        changed_.notify_all();
    }
    if (thread_.joinable()) thread_.join();
}

void Film::end() {
    close();
    const std::string reason = failure();
    if (!reason.empty()) throw Error(reason);
    std::error_code ignored;
    if (std::filesystem::file_size(file_.aside(), ignored) == 0)
        throw Error(fmt::format("the film '{}' could not be made: ffmpeg wrote nothing", plan_.file.string()));
    file_.commit();
}

}  // namespace pelage::app
