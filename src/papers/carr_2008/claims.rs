//! What the paper claims, and what running it has shown.

claims! {
    C01 ("section 1") InKind {
        claim: "Layer peeling takes as many iterations as the worst pixel has layers, and each draws everything: n² \
                work.",
        figures: [("iterations for n layers", "n", "n + 1")],
        evidence: "12 and 22 layers take 13 and 23 iterations, because one has to find nothing. Each draws the scene \
                   twice, the last once. Twice as many layers are 3.8 to 4 times as many triangles.",
        tests: [
            gl::claims_carr::c01_layer_peeling_takes_as_many_iterations_as_the_deepest_pixel_has_layers,
            gl::claims_carr_work::c01_layer_peeling_s_work_grows_with_the_square_of_the_layers,
        ],
    }
    C02 ("section 3, Algorithm 1") Amended {
        claim: "Hybrid layer peeling composites sorted and unsorted geometry together. Its iterations depend on the \
                unsorted geometry only.",
        evidence: "0, 10 and 100 slices take the iterations of the unsorted surfaces alone. As printed, Algorithm 1 \
                   loses or repeats surfaces in three places (CX19, CX20, CX21). As amended it composites 199,490 \
                   sequences of surfaces exactly, and the pseudocode and the OpenGL are one algorithm.",
        tests: [
            papers::listings_carr::c02_algorithm_1_prints_as_the_paper_has_it,
            papers::emulator_carr_errata::c02_iterations_depend_on_the_unsorted_geometry_only,
            papers::emulator_exhaustive::hybrid_layer_peeling_composites_every_sequence_with_every_part_of_it_sorted,
            gl::slices::c02_random_scenes_are_the_slices_in_f64_s,
            gl::slices::c02_c03_iterations_are_those_of_the_surfaces_alone,
        ],
    }
    C03 ("figure 1") InKind {
        claim: "256 slices of a volume with a cone in it take layer peeling 257 iterations, and hybrid layer peeling \
                3.",
        figures: [
            ("iterations of hybrid layer peeling", "3", "3"),
            ("iterations of layer peeling", "257", "259"),
        ],
        evidence: "A pixel of the cone sees 256 slices and two layers of the cone, and one iteration finds nothing. \
                   A cone that has one layer in front of all slices would take hybrid layer peeling 2 (CX30).",
        tests: [
            gl::claims_carr::c03_figure_1_takes_3_iterations_instead_of_257,
            gl::slices::c03_figure_1_with_a_volume_takes_3_iterations_instead_of_259,
        ],
    }
    C04 ("figure 3; section 8") InKind {
        claim: "With the number of slices, the iterations of layer peeling grow linearly, and those of hybrid and \
                coherent layer peeling stay constant.",
        figures: [
            ("layer peeling at 64, 128, 256, 512 slices", "linear", "67, 131, 259, 515"),
            ("hybrid layer peeling", "constant", "3, 3, 3, 3"),
            ("coherent layer peeling, A and B", "constant", "6, 6, 7, 9"),
        ],
        evidence: "It holds for layer peeling and for hybrid layer peeling. An iteration of coherent layer peeling \
                   processes at most 128 surfaces, so it is constant while no run of slices is longer: up to 192 \
                   slices with the cone that is bundled here, and past 256, the end of the figure, with a cone in the \
                   middle (CX29). The paper's own scene is not at hand.",
        tests: [
            papers::errata_carr::cx29_where_the_cone_lies_decides_up_to_how_many_slices_iterations_are_constant,
            gl::claims_carr_work::c04_c27_past_192_slices_the_128_an_iteration_show,
            gl::claims_carr_work::c04_too_few_buckets_cost_an_iteration_a_bucket_and_the_scene_s_own_number_none,
            gl::claims_carr::c04_iterations_grow_with_the_slices_for_layer_peeling_only,
            gl::slices::c04_layer_peeling_takes_an_iteration_a_slice,
        ],
    }
    C05 ("section 8") InKind {
        claim: "At 256 slices hybrid layer peeling is 52 times as fast as layer peeling, and coherent layer peeling \
                is slower than hybrid by a constant factor of about 6.",
        figures: [
            ("layer peeling for one of hybrid", "52 (62 in figure 1) in time", "172 in fragments"),
            ("coherent A and B for one of hybrid", "6 in time", "14.0 and 11.6 in fragments"),
        ],
        evidence: "What is counted is what is drawn, and not time. The first factor grows with the slices, 44, 87, \
                   172 at 64, 128, 256. The second is nearly constant, 11.9 to 14.0 and 9.9 to 11.6. A GPU's depth \
                   test spares fragments that a count has.",
        tests: [
            gl::claims_carr_work::c05_at_256_slices_hybrid_draws_over_52_times_fewer_fragments_and_coherent_6_times_more_than_hybrid,
        ],
    }
    C06 ("section 4, steps 1 and 2") Amended {
        claim: "z_min_prev and z_min_post, the nearest surfaces out of order before and after s_n, bound the range \
                that is in order.",
        evidence: "Computed straight from 1024 random sequences each of 1 to 16 surfaces, they are what the passes \
                   leave in the depth buffer after the first iteration, in both variants. The definition as printed \
                   is not: it compares with a predecessor that may lie outside of the range (CX07).",
        tests: [
            papers::emulator_figure_2::c06_the_passes_find_what_section_4_defines,
            papers::emulator_figure_2::cx07_a_predecessor_outside_of_the_range_hides_a_surface_that_is_out_of_order,
        ],
    }
    C07 ("figure 2, pass 1") Reproduced {
        claim: "s1, s2 and s3 update the stencil. It becomes 3, and the depth D(s3).",
        figures: [("stencil", "3", "3")],
        evidence: "On the emulated pixel and on OpenGL, for an order of depth that fits the text. 18 orders do.",
        tests: [
            papers::emulator_figure_2::c07_pass_1_counts_s1_s2_and_s3,
            papers::figure_2_orders::figure_2_fits_eighteen_orders_with_half_open_ranges_and_none_with_closed_ones,
            gl::figure_2::c07_to_c10_figure_2_on_opengl,
        ],
    }
    C08 ("figure 2, pass 2") Amended {
        claim: "s1 is skipped and the pass stops at s2. The stencil becomes 1, and the depth D(s2), which is \
                z_min_prev.",
        figures: [("stencil", "1", "1")],
        evidence: "Stencil and depth are as printed. But s1 is not skipped: it is drawn, and counts the stencil down \
                   (CX02).",
        tests: [
            papers::emulator_figure_2::c08_pass_2_stops_at_s2,
            papers::emulator_figure_2::cx02_s1_is_not_skipped_in_pass_2_but_drawn,
            gl::figure_2::c07_to_c10_figure_2_on_opengl,
        ],
    }
    C09 ("figure 2, pass 3") Amended {
        claim: "s3, s5, s6 and s7 are counted. s9 inverts the stencil from 4 to 251 and sets the depth to D(s9).",
        figures: [("stencil", "251", "251")],
        evidence: "The stencil is as printed. The depth stays D(s7), because a fragment that fails the depth test \
                   writes none (CX01). Nothing later reads it.",
        tests: [
            papers::emulator_figure_2::c09_pass_3_counts_s3_s5_s6_and_s7_and_s9_inverts_the_count,
            papers::emulator_figure_2::cx01_s9_does_not_set_the_depth_in_pass_3,
            gl::figure_2::c07_to_c10_figure_2_on_opengl,
        ],
    }
    C10 ("figure 2, pass 4") Reproduced {
        claim: "s3, s5, s6 and s7 are skipped, s9 and s10 rendered. The depth becomes D(s10), which is z_min_post.",
        evidence: "On the emulated pixel and on OpenGL. The stencil ends at 255.",
        tests: [
            papers::emulator_figure_2::c10_pass_4_skips_as_many_and_finds_s10,
            gl::figure_2::c07_to_c10_figure_2_on_opengl,
        ],
    }
    C11 ("section 5.2; figure 2's caption") Amended {
        claim: "Pass 5 composites the coherent range, [D(s3), D(s10)], and pass 6 the surface at its upper bound.",
        evidence: "Pass 5 composites s3, s5 and s6, and pass 6 composites s10. For that the range of pass 5 must be \
                   half open, and the state of pass 4 must be reset (CX05, CX12). This is one of the 18 orders that \
                   fit the figure.",
        tests: [
            papers::emulator_figure_2::c11_pass_5_composites_the_run_and_pass_6_what_ends_it,
            papers::emulator_carr_errata::cx05_a_closed_range_in_pass_5_composites_the_bound_twice,
            papers::emulator_carr_errata::cx12_state_left_behind_loses_surfaces,
        ],
    }
    C12 ("abstract") InKind {
        claim: "Perfectly sorted surfaces are rendered in a single iteration.",
        figures: [("iterations for up to 128 sorted surfaces", "1", "1, and 1 that finds nothing")],
        evidence: "A loop that ends by a query needs an iteration more to see that nothing is left; a query on pass \
                   1 would end it after 7 geometry passes instead of 12. Surfaces of equal depth break a run: 16 \
                   sorted pairs take 17 iterations, and with GEQUAL in pass 3 they take 2.",
        tests: [
            papers::emulator_carr_claims::c12_sorted_input_takes_one_iteration_and_one_that_finds_nothing,
            papers::emulator_carr_claims::a_query_on_pass_1_ends_a_sorted_scene_after_seven_passes,
            papers::emulator_carr_claims::tie_friendly_pass_3_peels_sorted_pairs_at_once,
        ],
    }
    C13 ("abstract; section 5.2") InKind {
        claim: "In the worst case, reversed order, two layers are peeled in each iteration.",
        figures: [("iterations for n reversed layers", "n/2", "n/2, rounded up, and 1")],
        evidence: "It holds for 1 to 32 reversed layers in both variants, and random orders of 8 and 24 layers never \
                   take more. Layers of equal depth count as one here.",
        tests: [
            papers::emulator_carr_claims::c13_reversed_input_takes_half_as_many_iterations_as_it_has_layers,
            papers::emulator_carr_claims::c13_at_least_two_layers_leave_per_iteration,
        ],
    }
    C14 ("section 5.1, pass 1") InKind {
        claim: "With more than 255 surfaces in opposite order the stencil overflows, and its count is invalid.",
        evidence: "It overflows, and iterations are wasted: 300 layers take A 174 and B 151, 600 take 474 and 301. \
                   But nothing is lost, whether INCR saturates or wraps, because any z_min_prev behind the right one \
                   is safe. Variant B has no such limit.",
        tests: [
            papers::emulator_carr_claims::c14_an_overflow_of_pass_1_costs_iterations_but_loses_nothing,
            papers::emulator_carr_claims::c14_wrapping_instead_of_saturating_loses_nothing_either,
            papers::emulator_carr_claims::pass_2_is_only_an_accelerator,
        ],
    }
    C15 ("section 5.1, pass 3") Reproduced {
        claim: "An iteration processes at most 128 surfaces, and there are no overflow issues.",
        figures: [("surfaces that an iteration peels at most", "128", "128")],
        evidence: "128 sorted surfaces take one iteration that finds something, 129 take 2, 257 take 3 and 600 take \
                   5. None is lost.",
        tests: [papers::emulator_carr_claims::c15_an_iteration_peels_at_most_128_surfaces_and_loses_none],
    }
    C16 ("section 5.2") Amended {
        claim: "Occlusion queries in the compositing phase tell when no surface is left.",
        evidence: "Every iteration but the last composites something, and the query ends the loop with the first \
                   that does not. It must count passes 5 and 6 (CX10), and surfaces on the opaque one must not count \
                   (CX08). The query costs an iteration that finds nothing.",
        tests: [
            papers::emulator_carr_claims::c16_the_loop_stops_when_the_compositing_phase_draws_nothing,
            papers::emulator_carr_errata::cx10_counting_pass_5_alone_ends_the_loop_too_early,
        ],
    }
    C17 ("section 6") Amended {
        claim: "One pass with float blending replaces passes 1 and 2, which leaves five geometry passes.",
        figures: [("geometry passes an iteration", "5", "5")],
        evidence: "It finds the D(s_n) and z_min_prev that passes 1 and 2 find, on random surfaces and with ties, \
                   and does not overflow past 255. For that its blend factors have to be the sentence's (C18), and \
                   its precision 32 bits (CX17).",
        tests: [
            papers::emulator_section_6::c17_one_pass_of_float_blending_finds_what_passes_1_and_2_find,
            papers::emulator_section_6::c17_the_blending_pass_does_not_overflow,
        ],
    }
    C18 ("section 6") Amended {
        claim: "Blending multiplies the source colour by the destination alpha, so that the last depth moves into \
                the colour.",
        evidence: "The sentence is right. The factors that are printed beside it multiply the destination colour: it \
                   becomes the product of all earlier depths, right by chance for up to two surfaces (CX16).",
        tests: [
            papers::emulator_section_6::c18_the_sentence_moves_one_depth_and_the_printed_factors_multiply_all,
            papers::emulator_carr_errata::cx16_the_printed_blend_factors_multiply_all_earlier_depths,
        ],
    }
    C19 ("section 7, Algorithm 2") Amended {
        claim: "On an ideal GPU an iteration takes two geometry passes, and the worst case is that of layer peeling.",
        figures: [("geometry passes an iteration", "2", "2")],
        evidence: "As printed, pixels that are done composite their last layer again (CX22). As amended it \
                   composites 208,848 sequences exactly and never takes more iterations than layer peeling. OpenGL \
                   runs it by framebuffer fetch or by images.",
        tests: [
            papers::emulator_carr_claims::c19_the_ideal_gpu_takes_at_most_as_many_iterations_as_layer_peeling,
            papers::emulator_exhaustive::algorithm_2_composites_every_sequence,
            gl::claims_carr_options::c19_the_ideal_gpu_takes_two_geometry_passes_an_iteration,
            gl::claims_carr_options::c19_the_ideal_gpu_by_images_gives_the_same_image,
        ],
    }
    C20 ("table 1") Reproduced {
        claim: "An iteration takes 6 geometry passes by variant A, 5 by variant B and 2 by layer peeling.",
        figures: [("geometry passes an iteration: A, B, layer peeling", "6, 5, 2", "6, 5, 2")],
        evidence: "On knots and on seven meshes from three sides, with one exception that the paper does not count: \
                   the last iteration of layer peeling, which finds nothing, takes 1.",
        tests: [
            gl::claims_carr::c20_geometry_passes_are_6_5_and_2_an_iteration,
            gl::claims_carr_table_1::c20_c21_table_1_on_the_meshes_at_hand,
        ],
    }
    C21 ("table 1; section 8") InKind {
        claim: "On mostly sorted models coherent layer peeling takes several times fewer iterations, and is up to 3 \
                times as fast.",
        figures: [("layer peeling's iterations for one of coherent layer peeling", "2.5 to 8.7", "1.7 to 9.5")],
        evidence: "The paper's models are not at hand. Seven meshes from three sides, and whole scenes, gain as \
                   much; shallow ones gain less. Times are not part of a test: on a software renderer they would say \
                   nothing of the paper's GPU. `benches/carr.rs` prints them.",
        tests: [
            gl::claims_carr::c21_coherent_peeling_takes_several_times_fewer_iterations_on_sorted_models,
            gl::claims_carr_table_1::c20_c21_table_1_on_the_meshes_at_hand,
        ],
    }
    C22 ("section 5.1") Amended {
        claim: "The opaque depth bounds the range: nothing behind it is counted or composited.",
        evidence: "Nothing is, and the images are exact in every method. What lies on the opaque surface itself is \
                   composited in every iteration as printed (CX08).",
        tests: [
            papers::emulator_carr_claims::c22_nothing_behind_the_opaque_depth_is_composited_or_counted,
            papers::emulator_carr_errata::cx08_surfaces_on_the_opaque_surface_are_composited_for_ever,
            gl::claims_carr::c22_opaque_surfaces_bound_every_method,
        ],
    }
    C23 ("section 9") InKind {
        claim: "A simple bucket sort of triangles by their centroids makes models sorted enough.",
        figures: [("iterations on shuffled knots: unsorted, 16 buckets, 1024 buckets", "-", "7, 5, 4")],
        evidence: "More buckets take fewer iterations. How many are enough depends on the scene.",
        tests: [gl::claims_carr::c23_bucket_sort_makes_a_model_sorted_enough],
    }
    C24 ("section 5.1, pass 1") Reproduced {
        claim: "Sorting the surfaces beforehand removes the overflow of pass 1.",
        figures: [("iterations for 600 layers: reversed, sorted", "-", "more than 400, fewer than 10")],
        evidence: "In opposite order the stencil overflows and the iterations are many (C14). Sorted, the same \
                   layers do not come near it.",
        tests: [papers::emulator_carr_claims::c24_sorting_beforehand_removes_the_overflow],
    }
    C25 ("sections 2 and 9") InKind {
        claim: "Batches by depth, after Wexler et al., make the work linear where they overlap little, and should be \
                combined with coherent layer peeling.",
        figures: [
            ("triangles for 32, 64, 128 shuffled sheets", "-", "6144, 21504, 89088"),
            ("the same in batches of 8", "O(n)", "2100, 3828, 8256"),
        ],
        evidence: "Peeled coherently, batches of a fixed size make triangles grow with n instead of with its square. \
                   Iterations grow with n either way. Of a soup, whose triangles reach into many batches, 64 batches \
                   draw three times as many. The image is exact with any number of them.",
        tests: [
            gl::claims_carr_work::c25_batches_of_a_fixed_size_make_the_work_linear,
            gl::claims_carr_work::c25_batches_that_overlap_draw_triangles_again,
            gl::claims_carr_options::batches_give_the_same_image_in_fewer_iterations_each,
        ],
    }
    C26 ("sections 4 and 9") InKind {
        claim: "What is finished can be culled, and a sort that is updated periodically as the camera moves is good \
                enough.",
        evidence: "Culling triangles before D(s_c) changes neither image nor iterations, and saves more than a \
                   fourth of all triangles on three scenes. A sort of an earlier frame costs an iteration at most \
                   while the camera has turned by a few degrees, and more when it looks from behind. For how long a \
                   sort is good depends on the scene.",
        tests: [
            gl::claims_carr_work::c26_culling_what_is_finished_saves_triangles_and_changes_nothing_else,
            gl::claims_carr_work::c26_with_culling_the_empty_iteration_draws_nothing,
            gl::claims_carr_work::c26_a_sort_that_is_kept_stays_good_for_some_degrees,
        ],
    }
    C27 ("figure 3; section 8") InKind {
        claim: "With the number of slices the time of layer peeling grows faster than linearly, and that of hybrid \
                and coherent layer peeling linearly.",
        evidence: "So do the triangles that are drawn, which are counted here: twice as many slices are nearly 4 \
                   times as many by layer peeling, and twice as many by the others while their iterations are \
                   constant (C04). `examples/24_figure_3.rs` plots iterations and times to 384 slices.",
        tests: [
            gl::figure_3::c27_work_grows_with_the_square_of_the_slices_for_layer_peeling_only,
            gl::claims_carr_work::c04_c27_past_192_slices_the_128_an_iteration_show,
        ],
    }
}
