// What a fragment comes from. The id's bits 31 and 30 say what the source is, 0 a surface, 1 a volume's proxy; 29 to 0 are the
// source's number. A surface's number is its triangle's place in the order of submission, so that (z, id) puts the fragments
// of a pixel into one order, whatever the order in which they came. A proxy's bit 29 says that the ray leaves the volume
// there, and bits 4 to 0 are the volume's number, so that an occupancy of 32 bits holds them all.

const uint SURFACE = 0u << 30;
const uint VOLUME = 1u << 30;
const uint LEAVES = 1u << 29;
const uint NUMBER = 31u;
