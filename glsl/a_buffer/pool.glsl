// Where a fragment of a linked list goes, as the paper has it: into the next node of the pool, which all pixels share.

layout(std430, binding = 3) buffer Pool {
    uint nodes;
};
uint place(uint count) {
    return atomicAdd(nodes, 1u);
}
