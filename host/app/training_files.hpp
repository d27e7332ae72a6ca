// What a training writes: the names of its files, the lock on them, and what each of them holds.
#pragma once

#include "app/training.hpp"
#include "io/locked.hpp"
#include "learn/checkpoint.hpp"
#include "learn/course.hpp"
#include "learn/picture.hpp"
#include "learn/settings.hpp"

#include <filesystem>
#include <optional>

namespace pelage::app {

class TrainingFiles {
public:
    // Throws Error where the model's name cannot be one, or a file would replace the picture.
    explicit TrainingFiles(const LearnOptions&);
    ~TrainingFiles();
    TrainingFiles(const TrainingFiles&) = delete;
    TrainingFiles& operator=(const TrainingFiles&) = delete;

    const std::filesystem::path& model() const { return model_; }
    std::filesystem::path checkpoint() const;

    // Makes the folder and keeps every other training from these files for as long as the object lives. Throws Error
    // where another one has them, where a checkpoint lies there that is not resumed, or none that could be.
    void claim(bool resume);

    void save(const learn::Identity&, const learn::Course&) const;
    void preview(const learn::Settings&, const learn::Window&, const learn::Course&) const;
    void results(const learn::Settings&, const learn::Window&, const learn::Course&) const;  // model, curve, preview

    // A picture of the losses, where pelage-plot is there and a loss can be shown on its scale; says why not.
    void draw_curve(const learn::Course&, bool quiet) const;

private:
    std::filesystem::path beside(const char* ending) const;

    std::filesystem::path model_, lock_file_;
    std::optional<FileLock> lock_;
};

}  // namespace pelage::app
