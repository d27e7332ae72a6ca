// Growth of a lattice: one column or row more, by duplicating one element of every row (column) in place.
//   ELEMENT    type of the elements moved
// Whole planes are written, with their zeros; see lattice/rows.cl. picks[i] is the element of row i (column i) that is
// duplicated; its successors shift by one. columns, rows and pitch are those before, new_... those after. Where
// `newborn` is true the planes hold births, and the duplicates' is `iteration`.

kernel void pelage_lattice_expand(global const ELEMENT* restrict old, global ELEMENT* restrict grown,
                                  global const int* restrict picks, const int by_column, const int columns,
                                  const int rows, const int pitch, const int new_pitch, const int planes,
                                  const int newborn, const int iteration) {
    const int new_columns = columns + (by_column ? 1 : 0);
    const int new_rows = rows + (by_column ? 0 : 1);
    for (int plane = 0; plane < planes; ++plane) {
        global const ELEMENT* const from = old + 16 + (long)plane * pitch * (rows + 1) + pitch;
        global ELEMENT* const to = grown + 16 + (long)plane * new_pitch * (new_rows + 1) + new_pitch;
        for (int row = (int)get_global_id(1) - 1; row < new_rows; row += (int)get_global_size(1)) {
            global ELEMENT* const place = to + (long)row * new_pitch;
            for (int x = (int)get_global_id(0); x < new_pitch; x += (int)get_global_size(0)) {
                ELEMENT value = 0;
                if (row >= 0 && x < new_columns) {
                    const int pick = picks[by_column ? row : x];
                    const int old_x = by_column && x > pick ? x - 1 : x;
                    const int old_row = !by_column && row > pick ? row - 1 : row;
                    value = from[(long)old_row * pitch + old_x];
                    if (newborn && (by_column ? x : row) == pick + 1) value = (ELEMENT)iteration;
                }
                place[x] = value;
            }
        }
    }
}
