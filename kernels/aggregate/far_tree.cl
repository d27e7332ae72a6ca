// An aggregate with a far field: what it is kept in. Blocks and their levels are told by core/far_grid.hpp. A leaf has
// its candidates and its charges in chains of chunks; the first chunk of a chain is the one that is being filled.
// One group grows it: all its items walk the same way, and the first one writes.
//   PELAGE_LEAF    sites in a row of a leaf

#define CHUNK 32
#define NODES 6
#define COEFFICIENTS 36
#define NOTHING (-(1l << 62))  // the highest sum where there is no candidate

struct pelage_level {  // struct DeviceLevel of opencl/aggregate/far_layout.hpp
    int columns, rows, first;
    int shift;  // of a site's column, which makes that of its block
};

struct pelage_leaf {  // struct DeviceLeaf
    long lowest;     // of what is known of its candidates' sums
    long highest;    // of their sums, when they were last looked at
    int candidates;
    int chunk;       // the first one of candidates
    int charges;
    int charge_chunk;
};

struct pelage_far_front {  // struct DeviceFarFront
    long lowest;  // of all candidates since the last renewal
    long lower, upper;  // what the totals are made for
    float eta;
    int grain;
    int whole;  // totals hold but for the blocks near `last`
    uint last;  // NO_SITE: totals hold there, too
    int charges, candidates;
    int chunks, left;  // of candidates: used so far; the first one that was left
    int charge_chunks;
    int unused;
};

struct pelage_far {
    global const struct pelage_level* levels;
    global const float* tables;  // see TABLE_
    global struct pelage_far_front* front;
    global struct pelage_leaf* leaves;
    global long* coefficients;  // of blocks
    global long* added;         // to each sum in a block, at most, since sums were looked at
    global long* best;          // no sum in a block is above it and what is added to larger blocks
    global ulong* totals;       // of bounds of weights in a block
    global uint* states;        // of sites, two bits each
    global uint* sites;         // of candidates
    global long* near;          // what charges near it add to a candidate's sum
    global long* known;         // its sum, but for what far charges added since the last renewal
    global int* next;           // chunk of the chain
    global uint* charges;
    global float* sizes;
    global int* charge_next;
    global int* looked_at;  // leaves
    int level_count;
    int columns, rows;
};

#define TABLE_NODES 0                   // in each block, from 0 to 1: of coefficients, x and then y
#define TABLE_HALVES (2 * COEFFICIENTS)  // the basis at the nodes of the lower and of the upper half
#define TABLE_PLACES (4 * COEFFICIENTS)  // the basis at a leaf's columns

#define FREE 0u
#define CANDIDATE 1u
#define TAKEN 2u
#define CLOSED 3u

static inline uint pelage_state(const struct pelage_far far, int x, int y) {
    const ulong at = (ulong)y * (ulong)far.columns + (ulong)x;
    return far.states[at / 16ul] >> (uint)(at % 16ul * 2ul) & 3u;
}

static inline void pelage_set_state(const struct pelage_far far, int x, int y, uint state) {
    const ulong at = (ulong)y * (ulong)far.columns + (ulong)x;
    const uint up = (uint)(at % 16ul * 2ul);
    far.states[at / 16ul] = (far.states[at / 16ul] & ~(3u << up)) | state << up;
}

static inline int pelage_block(const struct pelage_level level, int x, int y) {
    return level.first + y * level.columns + x;
}

static inline int pelage_leaf_of(const struct pelage_far far, uint site) {
    return pelage_block(far.levels[0], SITE_X(site) / PELAGE_LEAF, SITE_Y(site) / PELAGE_LEAF);
}

// How many of `count` lie in the first chunk of a chain.
static inline int pelage_in_first(int count) { return count == 0 ? 0 : (count - 1) % CHUNK + 1; }

// Where the candidate `index` of a leaf is kept.
static inline int pelage_slot(const struct pelage_far far, const struct pelage_leaf leaf, int index) {
    int chunk = leaf.chunk;
    for (int turn = (leaf.candidates - 1) / CHUNK; turn > index / CHUNK; --turn) chunk = far.next[chunk];
    return chunk * CHUNK + index % CHUNK;
}

// A candidate is added to a leaf.
static inline void pelage_push(const struct pelage_far far, int number, uint site, long near, long known) {
    struct pelage_leaf leaf = far.leaves[number];
    if (leaf.candidates % CHUNK == 0) {
        const int chunk = far.front->left >= 0 ? far.front->left : far.front->chunks++;
        if (chunk == far.front->left) far.front->left = far.next[chunk];
        far.next[chunk] = leaf.chunk;
        leaf.chunk = chunk;
    }
    const int slot = leaf.chunk * CHUNK + leaf.candidates % CHUNK;
    far.sites[slot] = site;
    far.near[slot] = near;
    far.known[slot] = known;
    ++leaf.candidates;
    leaf.lowest = min(leaf.lowest, known);
    far.leaves[number] = leaf;
    ++far.front->candidates;
}

// The last candidate of a leaf takes the place of another.
static inline void pelage_remove(const struct pelage_far far, int number, uint site) {
    struct pelage_leaf leaf = far.leaves[number];
    const int last = leaf.chunk * CHUNK + pelage_in_first(leaf.candidates) - 1;
    int chunk = leaf.chunk, count = pelage_in_first(leaf.candidates), slot = -1;
    for (int left = leaf.candidates; left > 0 && slot < 0; left -= count, count = CHUNK) {
        if (left < leaf.candidates) chunk = far.next[chunk];
        for (int i = 0; i < count; ++i) slot = far.sites[chunk * CHUNK + i] == site ? chunk * CHUNK + i : slot;
    }
    far.sites[slot] = far.sites[last];
    far.near[slot] = far.near[last];
    far.known[slot] = far.known[last];
    --leaf.candidates;
    --far.front->candidates;
    if (leaf.candidates % CHUNK == 0) {
        const int empty = leaf.chunk;
        leaf.chunk = far.next[empty];
        far.next[empty] = far.front->left;
        far.front->left = empty;
    }
    far.leaves[number] = leaf;
}

static inline void pelage_push_charge(const struct pelage_far far, int number, uint site, float size) {
    struct pelage_leaf leaf = far.leaves[number];
    if (leaf.charges % CHUNK == 0) {
        far.charge_next[far.front->charge_chunks] = leaf.charge_chunk;
        leaf.charge_chunk = far.front->charge_chunks++;
    }
    const int slot = leaf.charge_chunk * CHUNK + leaf.charges % CHUNK;
    far.charges[slot] = site;
#if PELAGE_SIZES
    far.sizes[slot] = size;
#endif
    ++leaf.charges;
    ++far.front->charges;
    far.leaves[number] = leaf;
}
