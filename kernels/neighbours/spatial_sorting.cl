// The approximate neighbour search of Malheiros & Walter: cells in a square matrix, brought into order by odd-even
// transposition along rows by x and along columns by y; see SpatialSorting in host/core/neighbours.hpp.

#ifdef PELAGE_DOUBLE
#define PELAGE_BEYOND DBL_MAX
#else
#define PELAGE_BEYOND FLT_MAX
#endif

// Places below `placed` keep their cells; those from there to `n` get the new ones, the rest none.
__kernel void pelage_matrix_load(__global const scalar* restrict positions, int pitch, int placed, int n, int places,
                                 __global scalar* restrict x, __global scalar* restrict y,
                                 __global int* restrict cell) {
    const int place = (int)get_global_id(0);
    if (place >= places) return;
    if (place >= placed) cell[place] = place < n ? place : -1;
    const int at = cell[place];
    x[place] = at >= 0 ? positions[at] : PELAGE_BEYOND;
    y[place] = at >= 0 ? positions[pitch + at] : PELAGE_BEYOND;
}

static inline void pelage_matrix_swap(__global scalar* x, __global scalar* y, __global int* cell, int a, int b) {
    const scalar x_a = x[a];
    const scalar y_a = y[a];
    const int cell_a = cell[a];
    x[a] = x[b];
    y[a] = y[b];
    cell[a] = cell[b];
    x[b] = x_a;
    y[b] = y_a;
    cell[b] = cell_a;
}

// One work-item a row.
__kernel void pelage_matrix_rows(__global scalar* x, __global scalar* y, __global int* cell, int side,
                                 __global int* restrict moved, int round) {
    const int row = (int)get_global_id(0);
    if (row >= side) return;
    int any = 0;
    for (int start = 1; start >= 0; --start) {
        for (int column = start; column + 1 < side; column += 2) {
            const int place = row * side + column;
            if (!(x[place] > x[place + 1])) continue;
            pelage_matrix_swap(x, y, cell, place, place + 1);
            any = 1;
        }
    }
    if (any) moved[round] = 1;
}

// One work-item a band of columns.
__kernel void pelage_matrix_columns(__global scalar* x, __global scalar* y, __global int* cell, int side, int band,
                                    __global int* restrict moved, int round) {
    const int begin = (int)get_global_id(0) * band;
    const int end = min(begin + band, side);
    int any = 0;
    for (int start = 1; start >= 0; --start) {
        for (int row = start; row + 1 < side; row += 2) {
            for (int place = row * side + begin; place < row * side + end; ++place) {
                if (!(y[place] > y[place + side])) continue;
                pelage_matrix_swap(x, y, cell, place, place + side);
                any = 1;
            }
        }
    }
    if (any) moved[round] = 1;
}

// The cells of the window within the radius, as lists of common/list.cl, ascending.
__kernel void pelage_matrix_lists(__global const scalar* restrict x, __global const scalar* restrict y,
                                  __global const int* restrict cell, int n, int side, int reach, scalar square,
                                  __global const int* restrict ids, int capacity, __global int* restrict lengths,
                                  __global int* restrict lists, __global int* restrict longest) {
    const int place = (int)get_global_id(0);
    if (place >= n) {  // lanes of the last block without a cell
        if (place / PELAGE_BLOCK == (n - 1) / PELAGE_BLOCK) lengths[place] = 0;
        return;
    }
    const int row = place / side;
    const int column = place - row * side;
    __global int* restrict list = lists + pelage_list_begin(cell[place], capacity);
    int length = 0;
    for (int r = max(row - reach, 0); r <= min(row + reach, side - 1); ++r) {
        for (int c = max(column - reach, 0); c <= min(column + reach, side - 1); ++c) {
            const int other = r * side + c;
            if (other == place || other >= n) continue;  // behind the cells there are none
            const scalar dx = x[other] - x[place];
            const scalar dy = y[other] - y[place];
            if (dx * dx + dy * dy <= square) length = pelage_list_append(list, length, capacity, cell[other]);
        }
    }
    pelage_list_sort(list, min(length, capacity), ids);
    lengths[cell[place]] = length;
    if (length > capacity) atomic_max(longest, length);
}
