// See settings.hpp.
#include "opencl/learn/settings.hpp"

#include "opencl/rules/functions.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage {

std::size_t learning_group(const Session& session) {
    if (session.options().work_group != 0) return session.options().work_group;
    return session.info().processor() ? 1 : 64;
}

std::size_t learning_width(const Session& session) {
    if (session.options().width != 0) return session.options().width;
    if (shared_learning(session)) return 1;
    std::size_t width = 1;
    while (width < sum_lanes && 2 * width <= session.info().vector_width_float) width *= 2;
    return width;
}

Source learning_source(const Session& session, const LearningShape& shape, std::size_t width) {
    // Registers for blocks of partial sums: 16 vectors of 16 lanes, or 8 and 16 of fewer.
    const std::size_t block = width == sum_lanes ? 4 : width > 1 ? 2 : 1;
    Source source;
    source.text(fmt::format(
        "#define PELAGE_WIDTH {}\n#define PELAGE_SIDE {}\n#define PELAGE_BATCH {}\n#define PELAGE_CHEMICALS {}\n"
        "#define PELAGE_HIDDEN {}\n#define PELAGE_RUN_CELLS {}\n#define PELAGE_RUNS {}\n#define PELAGE_TILE {}\n"
        "#define PELAGE_BLOCK {}\n#define PELAGE_ROTATIONS {}\n#define PELAGE_SET_NUMBERS {}L\n",
        width, shape.side, shape.batch, shape.chemicals, shape.hidden, shape.run_cells(), cell_runs,
        shared_learning(session) ? shape.cells() : learning_tile, block, shape.rotations,
        shape.rotations * shape.level_begin(pyramid_levels) * patch_directions));
    source.file("common/prelude.cl").file("common/four.cl");
    for (const std::string& file : function_files({}, {"quick_sigmoid"})) source.file(file);
    return source.file("learn/sums.cl");
}

cl::Buffer filled_buffer(const Session& session, const std::vector<float>& numbers, const char* what) {
    cl::Buffer buffer = float_buffer(session, numbers.size(), what);
    session.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, numbers.size() * sizeof(float), numbers.data());
    return buffer;
}

cl::Buffer float_buffer(const Session& session, std::size_t count, const char* what) {
    return session.buffer(count * sizeof(float), what);
}

}  // namespace pelage
