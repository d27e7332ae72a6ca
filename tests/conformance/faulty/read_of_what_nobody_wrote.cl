// A sum with what was never written.
kernel void faulty(global const int* given, global int* result, global const int* unknown) {
    const int i = (int)get_global_id(0);
    result[i] = given[i] + unknown[i];
}
