// Two work-items write unlike values to one place.
kernel void faulty(global const int* given, global int* result, global const int* unknown) {
    const int i = (int)get_global_id(0);
    result[i / 2] = given[i];
}
