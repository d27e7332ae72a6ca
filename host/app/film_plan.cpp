// See film_plan.hpp.
#include "app/film_plan.hpp"

#include "app/ffmpeg.hpp"
#include "app/validators.hpp"
#include "core/error.hpp"
#include "core/forecast.hpp"
#include "core/space.hpp"
#include "io/projection.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>
#include <variant>

namespace pelage::app {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t smallest_side = 16;
constexpr std::size_t largest_side = 16384;       // of the codecs
constexpr std::size_t largest_usual_side = 2048;  // without --size
constexpr std::uint64_t usual_length = 20;        // seconds
constexpr std::uint64_t fastest_gif = 50;         // its times are hundredths, and viewers slow down those below two

struct Form {
    std::string_view ending;
    std::string_view muxer;
    bool rgb;                // what ffmpeg is given
    std::string_view words;  // that tell it how to encode
};

// Fast ones: a film is made beside the run. Of a constant quantiser (18 is one that eyes see nothing of) x264 needs to
// know no frame beforehand, which -crf costs a third more time; threads of its own would wait for each other, and for
// us. Colours are marked as what yuv_word() makes.
constexpr std::string_view bt709 = "-colorspace bt709 -color_primaries bt709 -color_trc bt709 -color_range tv";
constexpr std::array forms{
    Form{".mp4", "mp4", false, "-c:v libx264 -preset ultrafast -qp 18 -threads 1 -movflags +faststart"},
    Form{".webm", "webm", false, "-c:v libvpx-vp9 -deadline realtime -cpu-used 8 -row-mt 1 -b:v 0 -crf 30"},
    Form{".gif", "gif", true,
         "-filter_complex split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=none"}};

void add_words(std::vector<std::string>& words, const std::string& line) {
    std::istringstream text(line);
    for (std::string word; text >> word;) words.push_back(word);
}

const Form& form_of(const fs::path& file) {
    const std::string ending = file.extension().string();
    for (const Form& form : forms) {
        if (form.ending == ending) return form;
    }
    throw Error(fmt::format("--video {} ends in {}; allowed are .mp4, .webm and .gif", file.string(),
                            ending.empty() ? "nothing" : "'" + ending + "'"));
}

// As in the names of pictures: final.NAME.png.
std::string picture_word(const Output& output, const Experiment& experiment) {
    const std::string name = output_name(experiment, output);
    if (output.drawing == Drawing::height) return name + ".height";
    if (output.drawing == Drawing::normal) return name + ".normal";
    return name;
}

void take_output(FilmPlan& plan, const Experiment& experiment, std::size_t place) {
    plan.place = place;
    plan.output = place < experiment.outputs.size() ? experiment.outputs[place] : Output{};
}

void choose_output(FilmPlan& plan, const std::string& of, const Experiment& experiment, bool lattice) {
    const auto& outputs = experiment.outputs;
    const auto first = std::ranges::find(outputs, Drawing::colours, &Output::drawing);
    take_output(plan, experiment, static_cast<std::size_t>(first - outputs.begin()));
    if (of.empty()) return;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        if (!lattice && outputs[i].drawing != Drawing::colours) continue;
        names.push_back(picture_word(outputs[i], experiment));
        if (names.back() == of) return take_output(plan, experiment, i);
    }
    if (experiment.texture) names.emplace_back("texture");
    plan.texture = experiment.texture && of == "texture";
    if (plan.texture) return;
    throw Error(fmt::format("--video-of {}: {} has no such output; it has {}{}", of, experiment.source,
                            fmt::join(names, ", "), meant(of, names)));
}

std::size_t even_side(double length) {
    const double pixels = std::clamp(std::ceil(length / 2) * 2, static_cast<double>(smallest_side), 1e9);
    return static_cast<std::size_t>(pixels);
}

// Whole factors alone, so that all cells are of one size.
Scale usual_scale(double columns, double rows, bool as_it_is) {
    const double longer = std::max(columns, rows);
    const auto most = static_cast<double>(largest_usual_side);
    if (longer > most) return {1, static_cast<std::size_t>(std::ceil(longer / most))};
    if (as_it_is) return {};
    const std::size_t factor = enlargement(static_cast<std::size_t>(columns), static_cast<std::size_t>(rows));
    return {std::clamp<std::size_t>(static_cast<std::size_t>(most / longer), 1, factor), 1};
}

// Of the largest lattice, or the texture, as many pixels.
void choose_frame(FilmPlan& plan, const std::string& size, double columns, double rows) {
    if (!size.empty()) {
        plan.frame = parse_frame_size(size);
        plan.scale = fitting_scale(static_cast<std::size_t>(columns), static_cast<std::size_t>(rows),
                                   plan.frame->columns, plan.frame->rows);
        return;
    }
    plan.scale = usual_scale(columns, rows, plan.texture);
    const auto of = [&](double length) {
        return even_side(
            std::floor(length * static_cast<double>(plan.scale->to) / static_cast<double>(plan.scale->from)));
    };
    plan.frame = FrameSize{of(columns), of(rows)};
}

// Of the largest picture of a lattice or a texture, an element a pixel.
std::optional<LatticeSize> size_drawn(const FilmPlan& plan, const Experiment& experiment, const Space& space) {
    if (const auto* volume = std::get_if<Volume>(&space)) {
        const auto size = projected_size(projection_of(plan.output), {volume->columns, volume->rows, volume->layers});
        return LatticeSize{static_cast<double>(size[0]), static_cast<double>(size[1])};
    }
    const auto* lattice = std::get_if<Lattice>(&space);
    if (plan.texture) {
        const auto [columns, rows] = *experiment.texture;
        return LatticeSize{static_cast<double>(columns), static_cast<double>(rows)};
    }
    if (lattice == nullptr) return std::nullopt;
    if (const auto grown = final_size(experiment, plan.last)) return grown;
    return LatticeSize{static_cast<double>(lattice->columns), static_cast<double>(lattice->rows)};
}

void check_film_file(const VideoOptions& video) {
    const fs::path& file = video.file;
    if (form_of(file).muxer == "gif" && video.fps > fastest_gif) {
        throw Error(fmt::format("--fps {} is too fast for a .gif, which shows up to {} frames a second", video.fps,
                                fastest_gif));
    }
    std::error_code ignored;
    const auto there = fs::status(file, ignored);
    if (fs::is_directory(there)) throw Error(fmt::format("--video {} is a folder; name a file", file.string()));
    if (fs::exists(there) && !fs::is_regular_file(there)) {
        throw Error(fmt::format("--video {} is a device or a pipe; a film needs a file", file.string()));
    }
    if (!on_path("ffmpeg")) throw Error(no_ffmpeg);
}

}  // namespace

FrameSize parse_frame_size(const std::string& word) {
    std::array<std::size_t, 2> sides{};
    const char* at = word.data();
    const char* const end = at + word.size();
    for (std::size_t i = 0; i < 2; ++i) {
        const auto [rest, failure] = std::from_chars(at, end, sides[i]);
        const bool good = failure == std::errc{} && sides[i] >= smallest_side && sides[i] <= largest_side &&
                          sides[i] % 2 == 0 && (i == 0 ? rest != end && *rest == 'x' : rest == end);
        if (!good) {
            throw Error(fmt::format("'{}' is not WIDTHxHEIGHT in pixels, both even and from {} to {}", word,
                                    smallest_side, largest_side));
        }
        at = rest + 1;
    }
    return {sides[0], sides[1]};
}

std::uint64_t FilmPlan::next(std::uint64_t iteration) const {
    const std::uint64_t following = (iteration / every + 1) * every;
    return iteration < last ? std::min(following, last) : following;
}

bool FilmPlan::rgb() const { return form_of(file).rgb; }

std::vector<std::string> FilmPlan::arguments(const FrameSize& size, const fs::path& to) const {
    const Form& form = form_of(file);
    std::vector<std::string> words;
    add_words(words, "-nostdin -hide_banner -loglevel error");
    add_words(words, fmt::format("-f rawvideo -pix_fmt {} -video_size {}x{} -framerate {} -i pipe:0",
                                 form.rgb ? "rgb24" : "yuv420p", size.columns, size.rows, fps));
    add_words(words, std::string(form.words));
    if (!form.rgb) add_words(words, std::string(bt709));
    add_words(words, fmt::format("-f {} -y", form.muxer));
    words.push_back("file:" + to.string());
    return words;
}

std::optional<FilmPlan> plan_film(const RunOptions& options, const Experiment& experiment, std::uint64_t last) {
    const VideoOptions& video = options.video;
    if (video.file.empty()) return std::nullopt;
    check_film_file(video);
    const std::uint64_t frames = usual_length * video.fps;
    FilmPlan plan;
    plan.file = video.file;
    plan.fps = video.fps;
    plan.last = last;
    plan.every = video.every != 0 ? video.every : std::max<std::uint64_t>(1, (last + frames - 1) / frames);
    const Space space = space_of(experiment);
    const auto* lattice = std::get_if<Lattice>(&space);
    choose_output(plan, video.of, experiment, on_grid(space));
    plan.plain = lattice != nullptr && !plan.texture && plan.output.expressions.empty();
    if (const auto size = size_drawn(plan, experiment, space)) {
        choose_frame(plan, video.size, size->columns, size->rows);
    } else if (!video.size.empty()) {
        plan.frame = parse_frame_size(video.size);
    }
    return plan;
}

}  // namespace pelage::app
