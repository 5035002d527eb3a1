// A node of multi-layer alpha blending (Salvi and Vaidyanathan 2014): one fragment, or several that were merged. A texel of
// four words holds it. The first word has the depth's bits, which are ordered as depths are. The others have 24 bits for
// each channel of the premultiplied colour, and 24 for the transmittance.
// defines: method

struct Node {
    uint depth;            // the nearest one's bits
    vec3 color;
    float transmittance;
};

// An empty node. It lies behind every depth.
const uint NO_DEPTH = 0xFFFFFFFFu;
const Node NOTHING = Node(NO_DEPTH, vec3(0.0), 1.0);

const float STEPS = 16777215.0;    // 2^24 - 1

uvec4 texel_of(Node node) {
    uvec4 parts = uvec4(round(clamp(vec4(node.color, node.transmittance), 0.0, 1.0) * STEPS));
    uvec3 bytes = (parts.aaa >> uvec3(0, 8, 16)) & 0xFFu;
    return uvec4(node.depth, parts.rgb | (bytes << 24));
}

Node node_of(uvec4 texel) {
    uvec3 bytes = texel.yzw >> 24;
    uint transmittance = bytes.x | (bytes.y << 8) | (bytes.z << 16);
    return Node(texel.x, vec3(texel.yzw & 0xFFFFFFu) / STEPS, float(transmittance) / STEPS);
}

// Two nodes as one, at the nearer one's depth.
Node merged(Node near, Node far) {
    return Node(near.depth, near.color + near.transmittance * far.color, near.transmittance * far.transmittance);
}
