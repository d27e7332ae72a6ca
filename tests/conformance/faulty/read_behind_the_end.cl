// The last work-item reads one element too far.
kernel void faulty(global const int* given, global int* result, global const int* unknown) {
    const int i = (int)get_global_id(0);
    result[i] = given[i + 1];
}
