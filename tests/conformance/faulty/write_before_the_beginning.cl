// The first work-item writes one element too early.
kernel void faulty(global const int* given, global int* result, global const int* unknown) {
    const int i = (int)get_global_id(0);
    result[i - 1] = given[i];
}
