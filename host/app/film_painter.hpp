// Draws the frames of a film.
#pragma once

#include "app/film_plan.hpp"
#include "core/snapshot.hpp"
#include "core/tissue.hpp"
#include "io/draw_cells.hpp"
#include "io/drawn.hpp"
#include "io/quick_colours.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pelage::app {

// What one frame is drawn from: the values of a plain output alone, or the whole state.
struct Shot {
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<float> values;
    Snapshot state;  // where more is needed

    void take(const FilmPlan&, const Tissue&);  // memory is kept from shot to shot
    static double bytes(const FilmPlan&, const Experiment&, double cells);
};

class FilmPainter {
public:
    // The first shot says how large frames are, where the plan does not.
    FilmPainter(const FilmPlan&, const Experiment&, const CellDrawing&, const Shot& first);

    const FrameSize& frame() const { return frame_; }

    // The frame as ffmpeg takes it. Ranges of colours, and what is seen of free cells, only widen from call to call.
    void paint(const Shot&, std::string& to);

private:
    void lattice(const Shot&, const Colours&, std::string& to);  // of the frame's own size
    void halved(const Shot&, const Colours&, std::string& to);   // twice as large
    Picture picture_of(const Shot&);
    Picture lattice(const Shot&, const Colours&);
    Picture map(const Shot&);
    Picture of_state(const Snapshot&);
    Picture texture(const Snapshot&, const Drawn&);
    Picture projection(const Snapshot&, const Drawn&, const ValueRange& found);  // of a volume
    Picture cells(const Snapshot&, const Brush&);
    Picture in_frame(Picture) const;
    const QuickColours& quick(bool yuv);
    const QuickColours& quick_parts();
    template <class Value>
    ValueRange seen(std::span<const Value> now);  // of the values so far, or as the output says

    const FilmPlan& plan_;
    const Experiment& experiment_;
    std::optional<QuickColours> yuv_, rgb_, parts_;  // made when needed
    ValueRange range_;
    CellDrawing drawing_;
    FrameSize frame_;
};

}  // namespace pelage::app
