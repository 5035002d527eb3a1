// Where the lists of marked pixels lie: side by side in maps of their own, numbered row by row. a_buffer/band.glsl comes
// before it.

ivec2 place_of_list(uint number) {
    return ivec2(number % band.width, number / band.width);
}

// Lists of other bands take their turns.
bool is_in_band(ivec2 place) {
    return uint(place.y) - band.first_row < band.rows;
}
