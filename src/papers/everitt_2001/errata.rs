//! What is wrong or missing in the paper's print.

errata! {
    EX01 ("Listing 2") Gap {
        printed: "The listing sets the operations of four texture shader stages.",
        executed: "It never enables GL_TEXTURE_SHADER_NV, without which the operations have no effect: the depth that is \
                   stored stays the rasteriser's, and the peels go wrong as if there were no Listing 2.",
        change: "Enable it before drawing.",
        tests: [
            gl::errata_everitt::ex01_listing_2_enables_nothing,
            gl::errata_everitt::ex01_without_the_enabling_the_rasteriser_s_depth_is_stored,
        ],
    }
    EX02 ("Listing 2, unit 3") Gap {
        printed: "Unit 3, which holds the shadow map, has the environment GL_NONE.",
        executed: "By the environment the comparison reaches neither colour nor alpha, so the alpha test sees the \
                   surface's own alpha, and every layer is the first one. Register combiners could carry it on; the \
                   paper does not mention them.",
        change: "Let unit 3 replace or modulate alpha.",
        tests: [
            gl::errata_everitt::ex02_unit_3_s_environment_drops_the_comparison,
            gl::errata_everitt::ex02_by_unit_3_s_printed_environment_nothing_is_peeled,
        ],
    }
    EX03 ("Listing 2, unit 3") Gap {
        printed: "Unit 3 looks up a rectangle texture.",
        executed: "Its coordinates count texels. The listing generates none for this unit and leaves its matrix as \
                   it was, and clip coordinates are none either.",
        change: "Scale the coordinates on unit 3 to the window's size, or look up a texture of two dimensions.",
        tests: [
            gl::errata_everitt::ex03_unit_3_has_no_texel_coordinates,
            gl::errata_everitt::ex03_with_coordinates_from_0_to_1_the_printed_rectangle_does_not_peel,
        ],
    }
    EX04 ("Shadow Mapping; Listing 1") Gap {
        printed: "Depth unit 0 tests GREATER, and the SGIX_shadow extension compares.",
        executed: "SGIX_shadow compares by LEQUAL and GEQUAL only, and its result is a luminance, which leaves alpha \
                   at 1. GEQUAL in place of GREATER passes equal depths, so it peels nothing: every layer is the \
                   first one.",
        change: "Compare by LEQUAL, and carry the inverse into alpha by register combiners, or use the extensions of \
                 2002 (ARB_depth_texture, ARB_shadow, EXT_shadow_funcs). Both give the same layers.",
        tests: [
            gl::errata_everitt::ex04_gequal_peels_nothing_and_not_lequal_peels,
            gl::errata_everitt::ex04_a_luminance_leaves_alpha_as_it_is_and_nothing_is_peeled,
            gl::errata_everitt::ex04_sgix_shadow_peels_by_what_lequal_does_not_pass,
            gl::errata_everitt::ex04_by_gequal_equal_depths_pass_and_every_layer_is_the_first,
            papers::emulator_sgix_shadow::ex04_every_peel_by_gequal_or_lequal_finds_the_nearest_again,
        ],
    }
    EX05 ("An Invariance Issue") Name {
        printed: "A texture of GL_UNSIGNED_HILO_NV.",
        executed: "NV_texture_shader has no such name. Its unsigned formats are called HILO_NV and HILO16_NV.",
        change: "GL_HILO_NV.",
        tests: [papers::errata_in_print::ex05_the_extension_s_unsigned_format_has_another_name],
    }
    EX06 ("An Invariance Issue") Name {
        printed: "The lookup divides \"s/q\", twice.",
        executed: "The quotient that is compared is r/q, as the same section says everywhere else.",
        change: "r/q.",
        tests: [papers::errata_in_print::ex06_the_quotient_is_called_s_over_q_twice],
    }
    EX07 ("Putting It All Together") Gap {
        printed: "The blending function is (SRC_ALPHA, ONE_MINUS_SRC_ALPHA).",
        executed: "It blends alpha by alpha, too: over an opaque background the image's own alpha becomes a² + 1 - \
                   a. A screen does not show it, a file does.",
        change: "Blend alpha by (ONE, ONE_MINUS_SRC_ALPHA).",
        tests: [gl::claims_everitt_compositing::e12_the_printed_blend_function_leaves_an_opaque_image_translucent],
    }
    EX08 ("figure 5") Number {
        printed: "Two figures are called figure 5: the depth replace shader, and the layers blended.",
        executed: "\"Figure 5\" in the text is the first one once, and the second one three times.",
        change: "Call the second one figure 6.",
        tests: [papers::errata_in_print::ex08_two_figures_have_one_number],
    }
}
