// No fault: neighbours are read from what the group wrote before a barrier.
kernel void faulty(global const int* given, global int* result, global const int* unknown) {
    const int i = (int)get_global_id(0);
    local int here[16];
    here[get_local_id(0)] = given[i];
    barrier(CLK_LOCAL_MEM_FENCE);
    result[i] = here[15 - get_local_id(0)];
}
