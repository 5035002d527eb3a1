//! Coherent layer peeling, A and B.

#[test]
fn coherent_layer_peeling_does_call_by_call_what_the_emulated_pixel_does() {
    crate::compare::check(|key| key.starts_with("carr/coherent"));
}
