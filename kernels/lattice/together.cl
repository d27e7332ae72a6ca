// How work-groups of one work-item share the steps of a small lattice: each has a strip of rows of its own, takes one
// step (level) of it at a time, and before each waits until the strips beside it are as far. So nobody is launched anew
// for a step, and what a strip holds stays near its processor.
// A device need not run all groups at once. Until everybody has arrived, those that are there do the others' strips
// too: one group alone finishes. Groups that have arrived run, so their neighbours may wait for them.
// Who has waited long does the same, for a group that has arrived may have lost its processor to somebody else.
// Where a level is a pass of several steps (lattice/stream.cl) no strip may be lower than those are many.
// Levels count on from launch to launch: `begin` is the first one of this launch, `end` the one after the last.

// How often a group looks at its own strip before it does others': much shorter than a time slice, and longer than
// groups wait that all run.
#ifndef PATIENCE
#define PATIENCE 2048
#endif

// Places of flags, each in a cache line of its own.
#define ARRIVED 0
#define CLAIMED(strip) (32 * (1 + 2 * (strip)))  // levels of the strip that somebody has begun
#define DONE(strip) (32 * (2 + 2 * (strip)))     // and finished

// Truth if all that a level of the strip reads has been written, and nobody still reads what it overwrites.
static inline int pelage_ready(volatile global int* flags, int strips, int strip, int level) {
    const int below = strip > 0 ? strip - 1 : strips - 1;
    const int above = strip + 1 < strips ? strip + 1 : 0;
    return flags[DONE(strip)] >= level && flags[DONE(below)] >= level && flags[DONE(above)] >= level;
}

// A strip whose next level is this group's to do, and that level; -1 when nothing is left to do. `everybody`: value
// of flags[ARRIVED] when all groups of this launch have come.
static inline int pelage_claim(volatile global int* flags, int strips, int home, int end, int everybody, int* level) {
    for (int turns = 0;; turns += turns < PATIENCE) {
        const int reach = (flags[ARRIVED] < everybody || turns == PATIENCE) ? strips : 1;
        int left = 0;
        for (int k = 0; k < reach; ++k) {
            const int strip = home + k < strips ? home + k : home + k - strips;
            const int next = flags[CLAIMED(strip)];
            if (next >= end) continue;
            left = 1;
            if (!pelage_ready(flags, strips, strip, next)) continue;
            if (atomic_cmpxchg(&flags[CLAIMED(strip)], next, next + 1) != next) continue;
            mem_fence(CLK_GLOBAL_MEM_FENCE);
            *level = next;
            return strip;
        }
        if (!left) return -1;
    }
}

static inline void pelage_done(volatile global int* flags, int strip, int level) {
    mem_fence(CLK_GLOBAL_MEM_FENCE);
    atomic_xchg(&flags[DONE(strip)], level + 1);
}
