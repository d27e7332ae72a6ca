// See training_files.hpp.
#include "app/training_files.hpp"

#include "app/draw_report.hpp"
#include "app/last_will.hpp"
#include "app/named_files.hpp"
#include "app/prepare.hpp"
#include "app/say.hpp"
#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/network.hpp"
#include "io/picture.hpp"
#include "learn/results.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <string>

namespace pelage::app {

namespace {

namespace fs = std::filesystem;

fs::path model_file(const LearnOptions& options) {
    const fs::path file = options.out.empty() ? options.picture.filename().replace_extension(".npz") : options.out;
    if (file.extension() != ".npz") throw Error(fmt::format("'{}': the model's file must end in .npz", file.string()));
    if (fs::is_directory(file)) throw Error(fmt::format("'{}' is a folder; name a file for the model", file.string()));
    return file;
}

}  // namespace

TrainingFiles::TrainingFiles(const LearnOptions& options) : model_(model_file(options)) {
    for (const char* ending : {".npz", ".loss.csv", ".loss.png", ".preview.png", ".checkpoint"})
        keep_inputs("beside the model,", beside(ending), {options.picture}, "the picture that is learned");
}

TrainingFiles::~TrainingFiles() { when_killed_remove(nullptr); }

fs::path TrainingFiles::beside(const char* ending) const {
    return model_.parent_path() / (model_.stem().string() + ending);
}

fs::path TrainingFiles::checkpoint() const { return beside(".checkpoint"); }

void TrainingFiles::claim(bool resume) {
    const fs::path saved = checkpoint();
    if (resume && !fs::exists(saved))
        throw Error(fmt::format("'{}' is not there: there is no training to go on from", saved.string()));
    const fs::path folder = model_.parent_path().empty() ? fs::path(".") : model_.parent_path();
    prepare_folder(folder);
    lock_file_ = folder / fmt::format(".{}.pelage-learn", model_.stem().string());
    lock_.emplace(lock_file_, fmt::format("trains to '{}'", model_.string()));
    when_killed_remove(lock_file_.c_str());
    if (!resume && fs::exists(saved))
        throw Error(fmt::format("'{}' is there already: go on from it with --resume, or remove it", saved.string()));
    if (!resume && fs::exists(model_))
        throw Error(fmt::format("'{}' is there already: name another file with --out, or remove it", model_.string()));
}

void TrainingFiles::save(const learn::Identity& identity, const learn::Course& course) const {
    learn::write_saved(checkpoint(), identity, course.state(), course.pool());
}

void TrainingFiles::preview(const learn::Settings& settings, const learn::Window& window,
                            const learn::Course& course) const {
    write_png(beside(".preview.png"), learn::preview(window, settings.shape, course.samples()));
}

void TrainingFiles::results(const learn::Settings& settings, const learn::Window& window,
                            const learn::Course& course) const {
    write_network(model_, learn::network_of(settings.shape, course.learned()));
    write_file(beside(".loss.csv"), learn::curve_text(course.records()));
    preview(settings, window, course);
}

void TrainingFiles::draw_curve(const learn::Course& course, bool quiet) const {
    if (!plotter_is_there()) return;
    nlohmann::json steps = nlohmann::json::array(), losses = nlohmann::json::array();
    for (const learn::StepRecord& one : course.records()) {
        if (!std::isfinite(one.loss) || one.loss <= 0) continue;
        steps.push_back(one.step);
        losses.push_back(one.loss);
    }
    if (steps.empty()) {
        if (!quiet) say(stderr, "note: no picture of the losses: none of them is a finite number above 0\n");
        return;
    }
    const PrivateFolder work(fs::temp_directory_path(), "pelage-learn-");
    const nlohmann::json curve{{"curve", {{"title", model_.filename().string()}, {"x", steps}, {"y", losses}}}};
    write_file(work.path() / "curve.json", curve.dump() + "\n");
    draw_report(work.path() / "curve.json", beside(".loss.png"));
}

}  // namespace pelage::app
