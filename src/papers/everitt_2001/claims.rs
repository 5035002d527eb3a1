//! What the paper claims, and what running it has shown.

claims! {
    E01 ("figure 1") Reproduced {
        claim: "Blended in the order of submission, transparent surfaces make a wrong image. Peeled layers make the \
                right one.",
        evidence: "On a teapot and on knots, blending is off by more than 0.1 and visibly wrong in more than a \
                   twentieth of the covered pixels. Peeling is right to the rounding of 32-bit floats. Blending is \
                   right where the order happens to be right.",
        tests: [
            gl::claims_everitt::e01_blending_in_the_order_of_submission_is_wrong_and_peeling_is_right,
            gl::claims_everitt::e01_blending_is_right_where_the_order_happens_to_be,
        ],
    }
    E02 ("Depth Peeling") Reproduced {
        claim: "With n passes over a scene the n nearest layers are found, each with its colour and its depth.",
        evidence: "On soups, a teapot and knots every layer has the depth, to the last bit, and the colour of the \
                   fragment that a captured list has in its place. On random stacks the lists are known beforehand.",
        tests: [
            gl::claims_everitt::e02_n_passes_give_the_n_nearest_layers,
            gl::claims_everitt::e02_all_passes_give_all_layers,
            gl::claims_everitt::e02_layers_of_known_stacks_are_their_lists,
            gl::claims_everitt::e02_a_depth_off_by_its_last_bit_would_be_noticed,
        ],
    }
    E03 ("Listing 1") Reproduced {
        claim: "Two depth units peel: unit 0 discards what is not behind the last layer and never writes, unit 1 is \
                the ordinary depth test. They exchange their buffers from pass to pass.",
        evidence: "The listing prints as the paper has it, and it runs. No OpenGL has two depth units, so unit 0 \
                   becomes a shadow lookup with a discard, as the paper proposes, and a real OpenGL refuses the \
                   listing without this replacement.",
        tests: [
            papers::listings::e03_listing_1_prints_as_the_paper_has_it,
            papers::listings::e03_two_rounds_of_listing_1_unroll_with_their_buffers,
            papers::listings::e03_unit_0_becomes_a_shadow_lookup_and_unit_1_the_ordinary_depth_test,
        ],
    }
    E04 ("Shadow Mapping as Depth Test") InKind {
        claim: "A shadow map lookup is a depth test: its result goes into alpha, and the alpha test discards.",
        evidence: "The lookup passes exactly the fragments that the depth comparison passes, for all eight \
                   comparisons and to the last bit. Core profiles have no alpha test, so it is emulated, and the \
                   emulation makes the pixels of the real fixed functions. GREATER and a result in alpha are not \
                   what the extensions of 2001 had. What they had peels the same layers in another way (EX04).",
        tests: [
            gl::claims_everitt_depth_units::e04_a_shadow_lookup_passes_exactly_what_the_depth_comparison_passes,
            gl::claims_everitt_depth_units::e04_the_comparison_is_of_every_bit_of_the_depth,
            gl::classic_fixed_function::e04_the_emulation_is_the_real_fixed_functions_pixel_for_pixel,
            gl::classic_listing_2::e04_peeling_as_in_2001_with_depth_replace_equals_the_exact_image,
        ],
    }
    E05 ("Shadow Mapping as Depth Test") Reproduced {
        claim: "The shadow map that peels has the camera's own orientation and resolution.",
        evidence: "The first peel's depths are those of the nearest captured fragments, pixel by pixel, and every \
                   pixel looks up its own texel at sizes from 1 x 1 to 1021 x 3.",
        tests: [
            gl::claims_everitt_depth_units::e05_the_peeling_buffer_is_the_camera_s_own_depth_buffer,
            gl::claims_everitt_depth_units::e05_every_pixel_looks_up_its_own_texel_whatever_the_size,
        ],
    }
    E06 ("An Invariance Issue, equations 1 to 4") Reproduced {
        claim: "A peel that compares the rasteriser's depth with an interpolated quotient r/q goes wrong in the last \
                bits.",
        evidence: "More than half of the covered pixels are wrong, and more than a tenth repeat a layer for ever. In \
                   exact arithmetic both sides of the comparison are one number; in 32 bits they are not. The text \
                   at hand mentions equations 1 to 4 without their letters, so they are a reconstruction from its \
                   words.",
        tests: [
            gl::invariance::e06_comparing_r_over_q_with_the_rasterisers_depth_mis_peels,
            gl::invariance::e06_the_detector_and_the_exact_image_agree_on_what_is_right,
            gl::invariance::e06_window_z_compared_in_the_shader_and_in_the_sampler_give_the_same_image,
            gl::classic_listing_2::e06_equations_1_to_4_are_one_number_in_exact_arithmetic,
            gl::classic_listing_2::e06_equations_1_to_4_are_not_one_number_in_32_bits,
            gl::classic_listing_2::e06_peeling_as_in_2001_without_depth_replace_mis_peels,
        ],
    }
    E07 ("An Invariance Issue") InKind {
        claim: "With depth replace the stored and the compared depth are computed in one way, so that no bits differ \
                and no bias is needed.",
        evidence: "It holds on 32-bit float depths: every pixel that is left over is a tie or lies beyond the far \
                   plane, and every bias makes it worse. On 24 bits, which the paper has, it does not hold here: \
                   llvmpipe compares a depth that was not rounded with one that was, and the loop gets stuck with \
                   or without depth replace. Rounding both sides first is the cure.",
        tests: [
            gl::invariance::e07_with_depth_replace_every_pixel_left_over_is_a_tie_or_beyond_the_far_plane,
            gl::invariance::e07_no_bias_is_needed_with_depth_replace_and_none_helps_without_harm,
            gl::invariance::e07_on_24_bits_the_sampler_compares_what_was_not_rounded_and_the_loop_gets_stuck,
            gl::invariance::e07_on_24_bits_a_pixel_is_stuck_just_where_a_stored_depth_was_rounded_down,
            gl::invariance::e07_a_loop_that_would_never_end_is_given_up_and_says_so,
        ],
    }
    E08 ("Listing 2") Amended {
        claim: "Listing 2 sets up the depth replace shader so that two dot products give window z and w, and their \
                quotient replaces the depth.",
        evidence: "In f64 the products are zc/2 + wc/2 and wc, to 1e-11, and the depth that is stored is window z, \
                   to a few last bits. Each of its 38 steps is missed if it is left out, but for three that the \
                   emulation does by itself. The listing alone would not do it: what it leaves out or overrides is \
                   in EX01 to EX03, and the emulation supplies it.",
        tests: [
            gl::classic_listing_2::e08_listing_2_prints_as_the_paper_has_it,
            gl::classic_listing_2::e08_the_dot_products_are_homogeneous_window_z_and_w,
            gl::classic_listing_2::e08_listing_2_runs_and_stores_window_z,
            gl::classic_listing_2::e07_e08_every_step_of_listing_2_is_missed,
        ],
    }
    E09 ("Shadow Mapping") InKind {
        claim: "Peeling needs the full depth precision of 24 bits. The 8 or 16 bits of multitexture shadow maps are \
                not enough.",
        evidence: "Of a soup with a far plane 10,000 times as far as the near one, 8 bits get more than a twentieth \
                   of the covered pixels wrong, 16 bits more than a thousandth, and 24 bits less. A 16-bit depth \
                   buffer loses what shares a step. The bits are rounded in a shader, because no driver has the \
                   hardware of 2001.",
        tests: [
            gl::invariance::e09_8_and_16_bits_are_not_enough_and_24_are,
            gl::invariance::e09_a_16_bit_depth_buffer_loses_what_shares_a_step,
        ],
    }
    E10 ("figure 3") InKind {
        claim: "Layers 0 to 3 of a teapot over a plane: the red outside first, then the green inside, then mostly \
                blue plane in the shape of the teapot.",
        figures: [("samples of layers 0, 1, 2, 3", "-", "11622, 3887, 3369, 314")],
        evidence: "The bundled teapot is another one, and so is its camera. Layers 0 to 2 have the colours that the \
                   text names. Layer 3, which the text does not describe, is a part of layer 2's shape, inside and \
                   plane. The samples become fewer from layer to layer.",
        tests: [
            gl::claims_everitt::e10_samples_decrease_from_layer_to_layer,
            gl::claims_everitt::e10_layer_0_shows_the_teapot_s_outside_before_the_plane,
            gl::claims_everitt::e10_layer_1_shows_the_teapot_s_inside,
            gl::claims_everitt::e10_layer_2_has_the_shape_of_a_teapot_but_most_of_it_is_plane,
            gl::claims_everitt::e10_layer_3_is_a_part_of_layer_2_s_shape,
        ],
    }
    E11 ("figure 4") InKind {
        claim: "In a cross section, each layer is the frontmost of what the layers before have left, and its samples \
                become fewer.",
        evidence: "In the deepest row of two scenes every layer has one fragment where there is one, with as many \
                   before it as its number. The samples do not grow; a closed surface has as many in its first two \
                   layers. The edition draws the diagram of a column of knots.",
        tests: [gl::cross_section::e11_each_layer_has_the_frontmost_of_what_the_layers_before_have_left],
    }
    E12 ("Putting It All Together") Amended {
        claim: "Layers are composited back to front as textured quads with the blending function (SRC_ALPHA, \
                ONE_MINUS_SRC_ALPHA).",
        evidence: "The colours come out right. The image's own alpha does not: over an opaque background it becomes \
                   a² + 1 - a instead of 1. Blending alpha by (ONE, ONE_MINUS_SRC_ALPHA) is the cure.",
        tests: [
            gl::claims_everitt_compositing::e12_the_layers_composited_back_to_front_are_the_image,
            gl::claims_everitt_compositing::e12_as_printed_with_enough_passes_gives_the_right_colors,
            gl::claims_everitt_compositing::e12_the_printed_blend_function_leaves_an_opaque_image_translucent,
            gl::claims_everitt_compositing::e12_front_to_back_with_the_same_blending_function_is_another_image,
        ],
    }
    E13 ("figure 5, the second of this number") InKind {
        claim: "Truncated after few layers, the image is a good approximation. Three layers are \"good enough\" for \
                a teapot over a plane, and a fourth hardly changes it.",
        figures: [
            ("rms error of the teapot after 1, 2, 3, 4 layers", "-", "0.112, 0.042, 0.008, 0.002"),
            ("rms error of a molecule after 1, 2, 3, 4 layers", "-", "0.209, 0.169, 0.130, 0.094"),
        ],
        evidence: "Each layer brings the image nearer to the exact one. Three layers leave less than a tenth of the \
                   error that one leaves, but not less than a step of 8 bits; four do. A molecule needs more than \
                   four.",
        tests: [
            gl::claims_everitt_compositing::e13_each_further_layer_brings_the_image_nearer_to_the_exact_one,
            gl::claims_everitt_compositing::e13_three_layers_are_good_enough,
            gl::claims_everitt_compositing::e13_an_error_below_a_step_of_8_bits_takes_four_layers,
            gl::claims_everitt_compositing::e13_what_the_layers_do_not_hold_is_counted_as_lost,
            gl::accumulation::e13_three_layers_in_numbers,
        ],
    }
    E14 ("Shadow Mapping, figure 2") Reproduced {
        claim: "From a light's own point of view the same depth test makes shadows. The camera's is the special case \
                in which nothing that is seen is in shadow.",
        evidence: "A depth map from a light throws the shadows that rays in f64 find, at all pixels but those near \
                   an edge. It takes a bias, because a texel's depth is not that of every fragment in it. With the \
                   map at the camera everything that is seen is lit. A floor and a blind are the scene: the figure's \
                   own is not at hand.",
        tests: [
            gl::claims_everitt_shadows::e14_a_light_s_own_depth_map_throws_the_shadows_that_rays_find,
            gl::claims_everitt_shadows::e14_without_a_bias_lit_surfaces_shadow_themselves,
            gl::claims_everitt_shadows::e14_the_camera_s_own_map_is_the_special_case,
        ],
    }
    E15 ("An Invariance Issue, equation 4") InKind {
        claim: "The quotient's side of the comparison interpolates three quantities and performs four divides, and \
                the other side interpolates one.",
        figures: [
            ("quantities interpolated, left and right", "3 and 1", "3 and 1"),
            ("divides, left and right", "4 and 0", "3 and 0"),
        ],
        evidence: "As its sentences describe the equations, they hold three divides. A fourth is there if the \
                   lookup's other coordinates are divided, too. The divides cost the last bits: the sides differ in \
                   331 of 1000 cases, by 2^-24 at most. The equations themselves are no part of the text at hand.",
        tests: [
            papers::everitt_divides::e15_the_left_side_interpolates_three_quantities_and_divides_three_times,
            papers::everitt_divides::e15_the_divides_cost_the_last_bits,
        ],
    }
}
