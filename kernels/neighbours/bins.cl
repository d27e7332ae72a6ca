// Bins for the neighbour search: a grid over the bounding box of all points, row-major, each bin wider than the reach
// of the search, so that whatever is within reach of a point lies in the 3 x 3 bins around its own: three runs of the
// sorted order.

struct pelage_grid {
    scalar x, y;          // lower left corner of bin 0
    scalar per_x, per_y;  // bins per unit length
    int columns, rows;
    int bins;  // columns * rows
};

// Smallest and largest of elements begin to end. One that is not a number does not take part.
static inline void pelage_extent(__global const scalar* v, int begin, int end, __global scalar* least,
                                 __global scalar* most) {
    real low = R(INFINITY), high = R(-INFINITY);
    int i = begin;
    for (; i + PELAGE_WIDTH <= end; i += PELAGE_WIDTH) {
        const real here = LOAD(v + i);
        low = SELECT(here < low, here, low);
        high = SELECT(here > high, here, high);
    }
    scalar lows[PELAGE_WIDTH], highs[PELAGE_WIDTH];
    STORE(low, lows);
    STORE(high, highs);
    scalar lowest = INFINITY, highest = -INFINITY;
    for (int lane = 0; lane < PELAGE_WIDTH; ++lane) {
        lowest = fmin(lowest, lows[lane]);
        highest = fmax(highest, highs[lane]);
    }
    for (; i < end; ++i) {
        lowest = v[i] < lowest ? v[i] : lowest;
        highest = v[i] > highest ? v[i] : highest;
    }
    *least = lowest;
    *most = highest;
}

// The box around the points of each chunk: left, right, bottom, top.
__kernel void pelage_bins_box(__global const scalar* restrict positions, int pitch, int n, int chunks,
                              __global scalar* restrict boxes) {
    const int chunk = (int)get_global_id(0);
    if (chunk >= chunks) return;
    const int begin = pelage_chunk_begin(n, chunk, chunks);
    const int end = pelage_chunk_begin(n, chunk + 1, chunks);
    pelage_extent(positions, begin, end, boxes + 4 * chunk, boxes + 4 * chunk + 1);
    pelage_extent(positions + pitch, begin, end, boxes + 4 * chunk + 2, boxes + 4 * chunk + 3);
}

// Bins per unit length along an extent. The bin of a coordinate carries a rounding error that grows with the number
// of bins from the corner; widening the bins by more than that keeps points within reach in adjacent bins.
static inline scalar pelage_bins_per_length(scalar extent, scalar reach) {
    const scalar bins = extent / reach;
    const scalar per = 1 / (reach * ((scalar)1.001 + bins * (scalar)0x1p-21));
    return extent > 0 && extent < INFINITY && per > 0 ? per : 0;  // one bin for no extent and for one beyond measure
}

static inline scalar pelage_bins_along(scalar extent, scalar per) {
    return per > 0 ? extent * per + 1 : 1;
}

// One work-item. Bins past the allowed number are made wider, the more numerous direction first.
__kernel void pelage_bins_grid(__global const scalar* restrict boxes, int chunks, scalar reach, int most_bins,
                               __global struct pelage_grid* restrict grid, __global int* restrict bins) {
    if (get_global_id(0) != 0) return;
    scalar left = INFINITY, right = -INFINITY, bottom = INFINITY, top = -INFINITY;
    for (int chunk = 0; chunk < chunks; ++chunk) {
        left = fmin(left, boxes[4 * chunk]);
        right = fmax(right, boxes[4 * chunk + 1]);
        bottom = fmin(bottom, boxes[4 * chunk + 2]);
        top = fmax(top, boxes[4 * chunk + 3]);
    }
    const scalar width = right - left;
    const scalar height = top - bottom;
    scalar per_x = pelage_bins_per_length(width, reach);
    scalar per_y = pelage_bins_per_length(height, reach);
    while (pelage_bins_along(width, per_x) * pelage_bins_along(height, per_y) > (scalar)most_bins) {
        if (pelage_bins_along(width, per_x) > pelage_bins_along(height, per_y)) {
            per_x *= (scalar)0.5;
        } else {
            per_y *= (scalar)0.5;
        }
    }
    grid->x = left;
    grid->y = bottom;
    grid->per_x = per_x;
    grid->per_y = per_y;
    grid->columns = (int)pelage_bins_along(width, per_x);
    grid->rows = (int)pelage_bins_along(height, per_y);
    grid->bins = grid->columns * grid->rows;
    bins[0] = grid->bins;
}

// Which of `bins` bins along one axis; what is not a number goes to the first.
static inline int pelage_bin_along(scalar coordinate, scalar corner, scalar per, int bins) {
    const scalar place = (coordinate - corner) * per;
    return place >= 0 ? (place < (scalar)bins ? (int)place : bins - 1) : 0;
}

__kernel void pelage_bins_keys(__global const scalar* restrict positions, int pitch, int n, int chunks,
                               __global const struct pelage_grid* restrict grid_in, __global int* restrict keys) {
    const int chunk = (int)get_global_id(0);
    if (chunk >= chunks) return;
    __global const scalar* restrict x = positions;
    __global const scalar* restrict y = positions + pitch;
    const struct pelage_grid grid = *grid_in;
    const int end = pelage_chunk_begin(n, chunk + 1, chunks);
    for (int i = pelage_chunk_begin(n, chunk, chunks); i < end; ++i) {
        const int column = pelage_bin_along(x[i], grid.x, grid.per_x, grid.columns);
        const int row = pelage_bin_along(y[i], grid.y, grid.per_y, grid.rows);
        keys[i] = row * grid.columns + column;
    }
}

__kernel void pelage_bins_gather(__global const int* restrict order, int n, int pitch,
                                 __global const scalar* restrict positions, __global scalar* restrict sorted) {
    const int place = (int)get_global_id(0);
    if (place >= n) return;
    sorted[place] = positions[order[place]];
    sorted[pitch + place] = positions[pitch + order[place]];
}
