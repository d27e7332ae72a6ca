// What charges far away add to a sum: kept at the nodes of blocks, and interpolated. As
// reference/aggregate/far_field.cpp, bit for bit: no operation here is a fused one.

// A charge adds to the coefficients of a block, whose first site lies (x, y) from it.
static inline void pelage_add_to(global long* coefficients, global const float* nodes, float x,
                                 float y, float side, float size) {
    for (int i = ITEM; i < COEFFICIENTS; i += PELAGE_ITEMS) {
        const float over = x + (side * nodes[i] - 0.5f);
        const float up = y + (side * nodes[COEFFICIENTS + i] - 0.5f);
        coefficients[i] += (long)pelage_term_at(over * over + up * up, size);
    }
}

// More than a charge adds to any sum in a block of which the first site lies (x, y) from it.
static inline long pelage_at_most(int x, int y, int side, float size) {
    const float over = convert_float(max(max(x, 0), 1 - x - side));
    const float up = convert_float(max(max(y, 0), 1 - y - side));
    const long term = (long)pelage_term_at(over * over + up * up, size);
    return term + (term >> 10) + 1l;
}

// What there is of the blocks of a level from (x, y) to (z, w). Not a struct of one's own: Oclgrind 21.10 cannot inline
// a function that returns one.
static inline int4 pelage_part_of(const struct pelage_level level, int x, int y, int to_x, int to_y) {
    return (int4)(max(x, 0), max(y, 0), min(to_x, level.columns - 1), min(to_y, level.rows - 1));
}

static inline int4 pelage_beside(const struct pelage_level level, int x, int y) {
    return pelage_part_of(level, x - 1, y - 1, x + 1, y + 1);
}

// A charge is taken in by all blocks of a level that are to keep it.
static inline void pelage_spread(const struct pelage_far far, int number, uint site, float size) {
    const struct pelage_level level = far.levels[number];
    const int side = PELAGE_LEAF << number;
    const int x = SITE_X(site) >> level.shift, y = SITE_Y(site) >> level.shift;
    const int4 part =
        pelage_part_of(level, (x / 2 - 1) * 2, (y / 2 - 1) * 2, (x / 2 + 1) * 2 + 1, (y / 2 + 1) * 2 + 1);
    for (int row = part.y; row <= part.w; ++row) {
        for (int column = part.x; column <= part.z; ++column) {
            if (max(abs(column - x), abs(row - y)) <= 1u) continue;
            const int block = pelage_block(level, column, row);
            const int over = column * side - SITE_X(site), up = row * side - SITE_Y(site);
            pelage_add_to(far.coefficients + block * COEFFICIENTS, far.tables + TABLE_NODES, convert_float(over),
                          convert_float(up), convert_float(side), size);
            if (ITEM != 0) continue;
            const long most = pelage_at_most(over, up, side, size);
            far.added[block] += most;
            far.best[block] += most;
        }
    }
}

// A level's values at the nodes of one of the four blocks within: across rows, then along columns.
static inline void pelage_narrow(float* values, global const float* across,
                                 global const float* along) {
    float inner[COEFFICIENTS];
    for (int row = 0; row < NODES; ++row) {
        for (int i = 0; i < NODES; ++i) {
            float sum = 0.0f;
            for (int j = 0; j < NODES; ++j) sum += across[i * NODES + j] * values[row * NODES + j];
            inner[row * NODES + i] = sum;
        }
    }
    for (int i = 0; i < NODES; ++i) {
        for (int column = 0; column < NODES; ++column) {
            float sum = 0.0f;
            for (int j = 0; j < NODES; ++j) sum += along[i * NODES + j] * inner[j * NODES + column];
            values[i * NODES + column] = sum;
        }
    }
}

// What all levels together have at the nodes of a leaf.
static inline void pelage_at_nodes(const struct pelage_far far, int leaf, float* values) {
    const int x = leaf % far.levels[0].columns, y = leaf / far.levels[0].columns;
    for (int i = 0; i < COEFFICIENTS; ++i) values[i] = 0.0f;
    for (int number = far.level_count - 1; number >= 0; --number) {
        const int column = x >> number, row = y >> number;
        global const float* const halves = far.tables + TABLE_HALVES;
        pelage_narrow(values, halves + (column & 1) * COEFFICIENTS, halves + (row & 1) * COEFFICIENTS);
        global const long* const own = far.coefficients + pelage_block(far.levels[number], column, row) * COEFFICIENTS;
        for (int i = 0; i < COEFFICIENTS; ++i) values[i] += convert_float(own[i]);
    }
}

// Of one row of nodes, at a column of the leaf.
static inline float pelage_of_row(global const float* basis, const float* values) {
    float sum = 0.0f;
    for (int j = 0; j < NODES; ++j) sum += basis[j] * values[j];
    return sum;
}

// What far charges add at a site.
static inline long pelage_far_sum(const struct pelage_far far, const float* values, uint site) {
    global const float* const across = far.tables + TABLE_PLACES + SITE_X(site) % PELAGE_LEAF * NODES;
    global const float* const along = far.tables + TABLE_PLACES + SITE_Y(site) % PELAGE_LEAF * NODES;
    float sum = 0.0f;
    for (int k = 0; k < NODES; ++k) sum += along[k] * pelage_of_row(across, values + k * NODES);
    return convert_long(sum);
}

// The values of a leaf at each of its columns, for rows of nodes, when many candidates are asked for.
static inline void pelage_at_columns(const struct pelage_far far, const float* values, float* columns) {
    for (int column = 0; column < PELAGE_LEAF; ++column) {
        for (int k = 0; k < NODES; ++k)
            columns[column * NODES + k] =
                pelage_of_row(far.tables + TABLE_PLACES + column * NODES, values + k * NODES);
    }
}

static inline long pelage_far_sum_in(const struct pelage_far far, const float* columns, uint site) {
    global const float* const along = far.tables + TABLE_PLACES + SITE_Y(site) % PELAGE_LEAF * NODES;
    const float* const own = columns + SITE_X(site) % PELAGE_LEAF * NODES;
    float sum = 0.0f;
    for (int k = 0; k < NODES; ++k) sum += along[k] * own[k];
    return convert_long(sum);
}
