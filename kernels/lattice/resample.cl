// Growth of a lattice by interpolation; see core/resampling.hpp for the sums and their order.
//   ELEMENT    type of the elements moved
// Whole planes are written, with their zeros; see lattice/rows.cl. Sizes and pitch named new_... are those after.

// The nearest old element: columns_from[x], rows_from[row].
kernel void pelage_lattice_nearest(global const ELEMENT* restrict old, global ELEMENT* restrict grown,
                                   global const int* restrict columns_from, global const int* restrict rows_from,
                                   const int rows, const int pitch, const int new_columns, const int new_rows,
                                   const int new_pitch, const int planes) {
    for (int plane = 0; plane < planes; ++plane) {
        global const ELEMENT* const from = old + 16 + (long)plane * pitch * (rows + 1) + pitch;
        global ELEMENT* const to = grown + 16 + (long)plane * new_pitch * (new_rows + 1) + new_pitch;
        for (int row = (int)get_global_id(1) - 1; row < new_rows; row += (int)get_global_size(1)) {
            for (int x = (int)get_global_id(0); x < new_pitch; x += (int)get_global_size(0)) {
                const int inside = row >= 0 && x < new_columns;
                to[(long)row * new_pitch + x] = inside ? from[(long)rows_from[row] * pitch + columns_from[x]] : 0;
            }
        }
    }
}

scalar pelage_sample_row(global const scalar* row, global const int* source, global const scalar* weight,
                         const int others) {
    const scalar base = row[source[0]];
    scalar sum = base;
    for (int other = 0; other < others; ++other) sum = fma(weight[other], row[source[1 + other]] - base, sum);
    return sum;
}

// Concentrations: bounds[2 * plane] is the floor, bounds[2 * plane + 1] the limit.
kernel void pelage_lattice_interpolate(global const scalar* restrict old, global scalar* restrict grown,
                                       global const int* restrict column_sources,
                                       global const scalar* restrict column_weights,
                                       global const int* restrict row_sources,
                                       global const scalar* restrict row_weights, global const scalar* restrict bounds,
                                       const int others, const int rows, const int pitch, const int new_columns,
                                       const int new_rows, const int new_pitch, const int planes) {
    for (int plane = 0; plane < planes; ++plane) {
        global const scalar* const from = old + 16 + (long)plane * pitch * (rows + 1) + pitch;
        global scalar* const to = grown + 16 + (long)plane * new_pitch * (new_rows + 1) + new_pitch;
        const scalar lowest = bounds[2 * plane];
        const scalar highest = bounds[2 * plane + 1];
        for (int row = (int)get_global_id(1) - 1; row < new_rows; row += (int)get_global_size(1)) {
            for (int x = (int)get_global_id(0); x < new_pitch; x += (int)get_global_size(0)) {
                scalar value = 0;
                if (row >= 0 && x < new_columns) {
                    global const int* const sources = row_sources + row * (1 + others);
                    global const int* const across = column_sources + x * (1 + others);
                    global const scalar* const weights = column_weights + x * others;
                    const scalar base = pelage_sample_row(from + (long)sources[0] * pitch, across, weights, others);
                    scalar sum = base;
                    for (int other = 0; other < others; ++other) {
                        global const scalar* const there = from + (long)sources[1 + other] * pitch;
                        const scalar sample = pelage_sample_row(there, across, weights, others);
                        sum = fma(row_weights[row * others + other], sample - base, sum);
                    }
                    value = sum < lowest ? lowest : sum > highest ? highest : sum;
                }
                to[(long)row * new_pitch + x] = value;
            }
        }
    }
}
