// A stable counting sort of keys, one work-item a chunk of them: count, scan, scatter.
// With `bits` == 0 the whole key, below `keys_end[0]`, is the digit and one pass sorts; otherwise each pass sorts by
// `bits` bits from `shift` on. counts[chunk][digit] belong to one work-item each: no atomics, and the same order on
// every device, however many chunks there are.

static inline int pelage_digits(int bits, __global const int* keys_end) {
    return bits == 0 ? keys_end[0] : 1 << bits;
}

static inline int pelage_digit(int key, int bits, int shift) {
    return bits == 0 ? key : (key >> shift) & ((1 << bits) - 1);
}

__kernel void pelage_sort_count(__global const int* restrict keys, int n, int chunks, int bits, int shift,
                                __global const int* restrict keys_end, __global int* restrict counts) {
    const int chunk = (int)get_global_id(0);
    if (chunk >= chunks) return;
    const int digits = pelage_digits(bits, keys_end);
    __global int* restrict mine = counts + (long)chunk * digits;
    for (int digit = 0; digit < digits; ++digit) mine[digit] = 0;
    const int end = pelage_chunk_begin(n, chunk + 1, chunks);
    for (int i = pelage_chunk_begin(n, chunk, chunks); i < end; ++i) mine[pelage_digit(keys[i], bits, shift)] += 1;
}

// The counts in the order in which the sort lays out its keys: by digit, then by chunk. A scanning work-item takes a
// run of digits with all their chunks.
__kernel void pelage_sort_sum(__global const int* restrict counts, int chunks, int bits,
                              __global const int* restrict keys_end, int scanners, __global int* restrict sums) {
    const int scanner = (int)get_global_id(0);
    if (scanner >= scanners) return;
    const int digits = pelage_digits(bits, keys_end);
    const int begin = pelage_chunk_begin(digits, scanner, scanners);
    const int end = pelage_chunk_begin(digits, scanner + 1, scanners);
    int sum = 0;
    for (int chunk = 0; chunk < chunks; ++chunk) {
        __global const int* restrict of_chunk = counts + (long)chunk * digits;
        for (int digit = begin; digit < end; ++digit) sum += of_chunk[digit];
    }
    sums[scanner] = sum;
}

// counts become the place of each chunk's first key with that digit; starts[digit], with starts[digits] == n, the
// place of the first key of any chunk.
__kernel void pelage_sort_scan(__global int* restrict counts, int n, int chunks, int bits,
                               __global const int* restrict keys_end, int scanners,
                               __global const int* restrict sums, __global int* restrict starts) {
    const int scanner = (int)get_global_id(0);
    if (scanner >= scanners) return;
    const int digits = pelage_digits(bits, keys_end);
    const int end = pelage_chunk_begin(digits, scanner + 1, scanners);
    int place = pelage_sum_before(sums, scanner);
    for (int digit = pelage_chunk_begin(digits, scanner, scanners); digit < end; ++digit) {
        starts[digit] = place;
        for (int chunk = 0; chunk < chunks; ++chunk) {
            __global int* count = counts + (long)chunk * digits + digit;
            const int found = *count;
            *count = place;
            place += found;
        }
    }
    if (scanner == scanners - 1) starts[digits] = n;
}

// order[place] = the element that goes there. `order_in` null-like (first pass): the elements are 0, 1, 2, ...
__kernel void pelage_sort_scatter(__global const int* restrict keys, __global const int* restrict order_in,
                                  int first_pass, int n, int chunks, int bits, int shift,
                                  __global const int* restrict keys_end, __global int* restrict counts,
                                  __global int* restrict keys_out, __global int* restrict order_out) {
    const int chunk = (int)get_global_id(0);
    if (chunk >= chunks) return;
    __global int* restrict next = counts + (long)chunk * pelage_digits(bits, keys_end);
    const int end = pelage_chunk_begin(n, chunk + 1, chunks);
    for (int i = pelage_chunk_begin(n, chunk, chunks); i < end; ++i) {
        const int key = keys[i];
        const int place = next[pelage_digit(key, bits, shift)]++;
        keys_out[place] = key;
        order_out[place] = first_pass ? i : order_in[i];
    }
}

// Where each key's run starts among sorted keys, for sorts of several passes; starts[keys_end] == n.
__kernel void pelage_sort_starts(__global const int* restrict keys, int n, __global const int* restrict keys_end,
                                 __global int* restrict starts) {
    for (int key = (int)get_global_id(0); key <= keys_end[0]; key += (int)get_global_size(0)) {
        int low = 0;
        int high = n;
        while (low < high) {
            const int middle = low + (high - low) / 2;
            if (keys[middle] < key) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        starts[key] = low;
    }
}
