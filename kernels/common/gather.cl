// GATHER(a, j): the numbers of a at the places j, one a lane.

#define PELAGE_AT_2(a, j) (a)[j.s0], (a)[j.s1]
#define PELAGE_AT_4(a, j) PELAGE_AT_2(a, j), (a)[j.s2], (a)[j.s3]
#define PELAGE_AT_8(a, j) PELAGE_AT_4(a, j), (a)[j.s4], (a)[j.s5], (a)[j.s6], (a)[j.s7]
#define PELAGE_AT_16(a, j) \
    PELAGE_AT_8(a, j), (a)[j.s8], (a)[j.s9], (a)[j.sa], (a)[j.sb], (a)[j.sc], (a)[j.sd], (a)[j.se], (a)[j.sf]
#if PELAGE_WIDTH == 1
#define GATHER(a, j) ((a)[j])
#else
#define GATHER(a, j) ((real)(PELAGE_PASTE(PELAGE_AT_, PELAGE_WIDTH)(a, j)))
#endif
