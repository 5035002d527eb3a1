#version 430 core
// Counts its own invocations; some drivers lose some (see `onionskin doctor`).
// vertex: screen.vert

layout(std430, binding = 0) buffer Count {
    uint count;
};

out vec4 color;

void main() {
    atomicAdd(count, 1u);
    color = vec4(1.0);
}
