//! What the paper claims, and what running it has shown.

claims! {
    L01 ("section 3.1") Reproduced {
        claim: "One atomic counter for each pixel, counted up by all geometry and by the boxes of volumes, makes the \
                depth complexity image. Its histogram is the DCH.",
        figures: [("pixels of 8 layers or fewer in the bundled molecule", "-", "65.0% as the paper counts, 65.4% of what is resolved")],
        evidence: "The counters have the known depths of a row of pixels, and blending and the stencil count the \
                   same. As the paper counts, opaque geometry and what it hides count, too. By default only what has \
                   to be resolved does. The bundled molecule is another one.",
        tests: [
            gl::claims_lindholm::l01_atomic_counters_give_the_depth_complexity_image_and_its_histogram,
            gl::claims_lindholm::l01_all_geometry_is_counted_as_in_the_paper_beside_what_is_resolved,
            gl::claims_lindholm::l01_the_paper_s_counting_of_the_molecule_finds_more_than_is_resolved,
            gl::a_buffer::the_counts_equal_the_occlusion_query_s_however_they_are_counted,
            gl::fused::l01_the_complexity_image_counts_boxes,
            gl_cli::complexity::l01_complexity_writes_the_picture_the_plot_and_the_table,
        ],
    }
    L02 ("section 3.2") Reproduced {
        claim: "Closed geometry makes even depth complexities dominate.",
        evidence: "Of a closed knot no pixel at all has an odd count. With a third of it cut away more than a \
                   hundred have.",
        tests: [gl::claims_lindholm::l02_closed_geometry_makes_even_depth_complexities_dominate],
    }
    L03 ("section 3.2, figure 1") InKind {
        claim: "Histograms of real scenes fall steeply: most pixels lie far below the maximum.",
        figures: [
            ("maximum in the protein scene", "46", "32"),
            ("pixels of 8 layers or fewer", "68%", "55.1% of the covered ones"),
            ("pixels of more than 17 layers", "6.6%", "5.6% of the covered ones"),
        ],
        evidence: "The bundled molecule is another one. In each of four scenes half of the covered pixels have at \
                   most a third of the deepest one's surfaces. A stack that is as deep everywhere does not fall.",
        tests: [
            gl::claims_lindholm::l03_most_pixels_of_the_molecule_lie_far_below_the_maximum,
            gl::four_scenes::l03_most_pixels_lie_far_below_the_maximum,
            gl::four_scenes::a_stack_that_is_as_deep_everywhere_does_not_fall,
        ],
    }
    L04 ("section 4, figures 3 and 4") Reproduced {
        claim: "The A-buffer's three steps, clear, fill and resolve, run over three memory managers, FFB, DFB and \
                PPLL.",
        evidence: "By 96 combinations of managers, fills, sorts and arrays, random stacks with ties come out as the \
                   oracle has them, bit for bit alike. This holds up to the array's size. Past it the managers lose \
                   as many fragments, but not the same ones: of 192 slices with an array of 32, FFB and DFB are off \
                   by 0.59 and PPLL by 0.42 (LX12).",
        tests: [
            gl::claims_lindholm::l04_three_managers_give_the_same_image,
            gl::claims_lindholm::l04_past_n_the_managers_lose_as_many_fragments_but_not_the_same,
            gl::a_buffer::l04_every_manager_and_fill_gives_the_oracle_s_image,
        ],
    }
    L05 ("section 4, figure 4") Reproduced {
        claim: "DFB gives each pixel a base offset into the pool, by a prefix scan of the counts, so that lists are \
                contiguous.",
        evidence: "The image is that of fixed buffers at five odd sizes, and the pool holds a record for each \
                   fragment and no more. The scan is a compute shader; the paper's was CUDA, with a penalty for the \
                   switch.",
        tests: [gl::claims_lindholm::l05_base_offsets_keep_every_pixel_s_list_to_itself],
    }
    L06 ("section 4, figure 4") Reproduced {
        claim: "PPLL chains each pixel's fragments from a list anchor through a pool.",
        evidence: "By atomics, as the paper has it, a fragment takes a record of 16 bytes and a link of 4. Filled in \
                   order, the same lists need no atomics.",
        tests: [gl::claims_lindholm::l06_linked_lists_take_a_node_and_a_link_for_each_fragment],
    }
    L07 ("section 6.1") Reproduced {
        claim: "A fragment is stored as z (float32), id (int32) and colour (4 x float16), 16 bytes, and the id's \
                bits hold the source's type and number.",
        figures: [("bytes of a record", "16", "16")],
        evidence: "Read back from the pool byte by byte, by all three managers. Which bits of the id say what is not \
                   printed: here two tell the box of a volume, and its far side, and the others number the triangle \
                   or the volume.",
        tests: [
            gl::claims_lindholm::l07_a_record_s_16_bytes_are_z_id_and_four_half_floats,
            gl::claims_lindholm::l07_the_id_s_bits_tell_surfaces_from_the_boxes_of_volumes,
        ],
    }
    L08 ("section 7.2") Amended {
        claim: "FFB takes approximately 12.6 MiB for each depth layer at 1024 x 768.",
        figures: [("a layer of FFB", "12.6 MiB", "12.6 MB, which are 12.0 MiB")],
        evidence: "The number is right and the unit is not (LX14).",
        tests: [gl::claims_lindholm::l08_a_layer_of_a_fixed_buffer_takes_12_6_megabytes_which_are_12_mebibytes],
    }
    L09 ("section 4, Managing Local GPU Caches") Reproduced {
        claim: "A static array of N limits the depth complexity to N, since everything beyond is discarded.",
        evidence: "Exactly the pixels of more than N fragments are wrong, and the frame says how many fragments are \
                   missing. Which of them are discarded is left open (LX12).",
        tests: [
            gl::claims_lindholm_resolve::l09_a_static_array_loses_everything_past_n_and_says_so,
            gl::a_buffer_kept::l09_a_full_array_keeps_what_each_manager_s_list_begins_with,
            gl::a_buffer_kept::l09_keeping_the_nearest_gives_the_oracle_s_image_of_the_nearest_n,
            papers::emulator_lists::l09_without_pp_dp_the_last_segment_drops_what_overflows_it,
            gl_cli::complexity::l09_render_says_what_a_static_array_has_lost,
        ],
    }
    L10 ("section 5.1") Amended {
        claim: "ppAO resolves pixels by segments of 8, 16, 32 ... N with a program each. It counts while it fills \
                and adds no geometry pass.",
        evidence: "With a buffer of a fixed number of layers one geometry pass counts and fills, as printed and as \
                   amended. Where lists are allocated by an exact count, the manager makes a pass for that, with \
                   ppAO and without. Every pixel is resolved once, by the smallest segment that holds it. The \
                   masking itself has to be corrected (LX05 to LX07).",
        tests: [
            gl::claims_lindholm_pp_ao::l10_the_fill_counts_and_no_geometry_pass_is_added,
            gl::claims_lindholm_pp_ao::l10_the_counting_pass_is_the_memory_manager_s_and_not_pp_ao_s,
            gl::claims_lindholm_pp_ao::l10_every_pixel_is_resolved_by_the_smallest_segment_that_holds_it,
            gl::claims_lindholm_pp_ao::l10_what_a_fixed_buffer_has_no_room_for_is_lost_and_counted,
        ],
    }
    L11 ("section 6.2") Amended {
        claim: "An 8-bit stencil buffer does not limit the depth complexity to 255: higher ones share a segment.",
        evidence: "With a last segment of 256 and INCR, complexities of 254 to 280 are resolved once each, as \
                   printed; what is past 256 is dropped, and pixels of up to 128 are resolved twice (LX07). With a \
                   last segment of 64 or 128, what is deeper is resolved in none (LX05). By a counter of 32 bits, a \
                   last segment that takes the rest, and ppDP, complexities of 254 to 600 lose nothing.",
        tests: [
            gl::claims_lindholm_pp_ao::l11_eight_bits_leave_255_and_more_to_the_last_segment_as_printed,
            gl::claims_lindholm_pp_ao::l11_complexities_of_255_and_more_share_the_last_segment_and_none_is_lost,
            gl::claims_lindholm_pp_ao::l11_as_printed_the_stencil_loses_what_lies_past_the_last_segment,
            papers::emulator_lists::l11_the_stencil_s_masks_are_what_arithmetic_says,
            papers::emulator_lists::l11_of_the_marks_only_invert_works_and_only_up_to_128,
        ],
    }
    L12 ("section 5.2") Amended {
        claim: "ppDP with a buffer of n sorts n - 1 fragments a subpass, so that a pixel of D takes at most D / (n - \
                1), rounded up.",
        figures: [("subpasses of D fragments", "at most D / (n - 1)", "D / n, rounded up")],
        evidence: "The bound holds and is not reached: the pseudocode resolves n a subpass. To resolve n - 1 and go \
                   on from the n-th, as the text has it, loses one a subpass (LX02).",
        tests: [
            gl::claims_lindholm_resolve::l12_a_pixel_takes_at_most_d_over_n_minus_1_subpasses,
            papers::emulator_lists::l12_n_minus_1_a_pass_but_going_on_from_the_nth_loses_one_a_pass,
        ],
    }
    L13 ("section 5.2") Amended {
        claim: "ppDP may show artifacts where fragments of equal depth fall into two subpasses. The authors saw none.",
        evidence: "As printed, 20 coplanar fragments leave 8 (LX01). Comparing depth and id loses none: every list \
                   of up to four fragments in every order in memory comes out in the oracle's order.",
        tests: [
            gl::claims_lindholm_resolve::l13_as_printed_ties_are_lost_where_a_buffer_ends_and_amended_none,
            papers::emulator_lists::l13_ties_are_lost_where_a_buffer_ends_as_printed,
            papers::emulator_lists::l13_amended_peeling_is_the_oracle_s_order_of_every_small_list_however_it_lies_in_memory,
            papers::emulator_lists::l13_random_lists_come_out_in_the_oracle_s_order,
            gl::fused_as_printed::l13_a_tie_that_is_lost_is_a_volume_that_is_not_seen_or_does_not_end,
        ],
    }
    L14 ("section 8") Amended {
        claim: "ppAO and ppDP can be combined.",
        evidence: "As amended, together they give the exact image by all three managers, in more than three \
                   subpasses. Neither is exact as printed (L11, L13).",
        tests: [gl::claims_lindholm_resolve::l14_pp_ao_and_pp_dp_together_give_the_exact_image_too],
    }
    L15 ("section 7.2") Reproduced {
        claim: "A ray may end early where the transparency is below 0.02.",
        figures: [("transparency below which a ray ends", "0.02", "0.02")],
        evidence: "Of 64 sheets the nearest 11 are composited, the image is off by less than 0.02, and ppDP reads a \
                   quarter of the records.",
        tests: [gl::claims_lindholm_resolve::l15_early_ray_termination_errs_by_less_than_its_threshold_and_saves_work],
    }
    L16 ("section 6.1") Amended {
        claim: "Rays are cast through the segments between fragments. A bitmask says which volumes a segment lies in.",
        evidence: "The images are those of closed forms and of a caster in f64. For this the text needs two \
                   additions: where the ray begins, for an eye inside of a volume, and that an opaque surface ends \
                   it (LX15).",
        tests: [
            gl::fused::l16_fog_and_a_pane_follow_the_closed_form,
            gl::fused::l16_random_scenes_are_the_f64_caster_s,
            gl::fused::l16_densities_of_overlapping_volumes_add,
            gl::volumes::l16_a_second_caster_agrees_on_random_scenes,
            papers::emulator_fused::l16_every_list_is_evaluated_as_light_is,
            papers::emulator_fused::l16_without_the_opaque_surface_a_ray_goes_on_behind_it,
        ],
    }
    L17 ("section 5.2") Reproduced {
        claim: "ppDP keeps the state of the ray, occupancy and position, from one subpass to the next.",
        evidence: "The image is that of a single pass, bit for bit, whatever the manager, the array and the fill. A \
                   state that is not kept is noticed.",
        tests: [
            papers::emulator_fused::l17_ppdp_keeps_the_state_whatever_its_buffer,
            papers::emulator_fused::l17_a_state_that_is_not_kept_loses_what_subpasses_share,
            gl::fused::l16_l17_every_combination_gives_one_image,
            gl::fused_lockstep::l16_l17_the_pseudocode_and_the_shaders_see_the_same_light,
        ],
    }
    L18 ("figure 7") InKind {
        claim: "On 64 screen-filling quads in random order ppAO costs what a static array does, and ppDP is 3.6 \
                times as fast.",
        figures: [
            ("array elements a pixel: static, ppAO, ppDP", "-", "64, 64, 8"),
            ("records read a pixel: static, ppAO, ppDP", "-", "64, 64, 512"),
        ],
        evidence: "ppAO reserves and reads exactly what the static array does. ppDP needs an eighth of the array and \
                   reads the list eight times. The paper's termination changes nothing, since 0.0375 of the light \
                   comes through all 64. The speed of ppDP is not reproduced. By `benches/a_buffer.rs` on an H200, \
                   ppAO is 0.98 and 1.00 times as fast as the static array (FFB and DFB), and ppDP 0.80 and 0.74 \
                   times. On llvmpipe, which renders on a CPU and has no local memory to save, ppDP takes longer, \
                   too.",
        tests: [
            gl::claims_lindholm_resolve::l18_sixty_four_quads_cost_what_figure_7_says_they_must,
            gl::claims_lindholm_conditions::l18_figure_7_is_the_same_with_the_paper_s_termination,
        ],
    }
    L19 ("figure 6") Open {
        claim: "On four scenes and by three managers, ppAO is about 3 times and ppDP about 8 times as fast as static \
                arrays.",
        figures: [
            ("array elements reserved on the medical scene: static, ppAO, ppDP", "-", "219264, 24656, 13704"),
            ("records read on it: static, ppAO, ppDP", "-", "14970, 14970, 23460"),
        ],
        evidence: "The paper's GPUs were not at hand. On an H200 by `benches/fused.rs`, four scenes by three \
                   managers, ppAO is 0.6 to 4.5 times as fast as the static array (in the median 0.85) and ppDP 0.6 to \
                   5.0 times (1.08). The large gain is one bar: space by FFB. On llvmpipe, which has no local memory \
                   to save, the bars are all nearly one. What the two are made for is there: on scenes after the paper's, under its conditions, ppAO and ppDP reserve a fourth to a \
                   sixteenth of a static array's elements. ppDP pays with reading lists again.",
        tests: [gl::claims_lindholm_conditions::l19_l25_figure_6_under_the_paper_s_conditions_and_exactly],
    }
    L20 ("figure 2") InKind {
        claim: "Along a camera path the histogram changes with the camera and with what is shown, and the time \
                follows it.",
        evidence: "The cost is counted, in records read and subpasses, and follows from each frame's histogram. It \
                   rises as the camera comes nearer and changes at once where the scene's content does, at the \
                   pixels where it should. The bundled molecule and path are others; \
                   `examples/20_figure_2_over_time.rs` draws them with times.",
        tests: [
            gl::camera_path::l20_what_a_frame_costs_follows_from_its_histogram,
            gl::camera_path::l20_a_dolly_in_raises_coverage_and_cost_and_a_dolly_out_lowers_them,
            gl::camera_path::l20_a_change_of_composition_shows_at_once_and_where_it_should,
        ],
    }
    L21 ("section 5.2") Reproduced {
        claim: "With ppDP the depth complexity is not limited by the local array, but by global memory only.",
        evidence: "Up to 1000 fragments a pixel come out exact by arrays of 8, 16 and 64, with and without ppAO, and \
                   so do 2000. llvmpipe itself ends a shader's loops at 65,535 iterations, which allows about four \
                   thousand.",
        tests: [
            gl::a_buffer::l21_every_complexity_comes_out_exact_by_peeling,
            gl::a_buffer::two_thousand_fragments_are_not_too_many,
        ],
    }
    L22 ("section 5.2") Open {
        claim: "8 is the best size of ppDP's array on all test setups.",
        figures: [
            ("records read for arrays of 1, 2, 4, 8, 16, 32", "-", "125688, 64051, 35150, 21070, 13349, 12354"),
            ("part of the array that is used", "-", "100%, 100%, 89%, 69%, 44%, 22%"),
        ],
        evidence: "The paper has measured it as times on its GPUs, which were not at hand. On an H200 at 1024 x 768, \
                   the quickest of four frames each, 8 was the best of 1 to 32 on three bundled scenes of six, and at \
                   most 1.13 times the best on the others; 32 took up to 1.9 times and 1 up to 4.5 times as long as 8. \
                   What is counted is the same on every renderer, and has no best size: a larger array reads less and \
                   is used less.",
        tests: [gl::claims_lindholm_conditions::l22_in_counts_no_array_size_of_pp_dp_is_the_best],
    }
    L23 ("section 4, Managing Global GPU Memory") InKind {
        claim: "DFB and PPLL consume almost as little memory as is possible.",
        figures: [
            ("bytes over 16 a fragment on the molecule: DFB, PPLL, FFB", "almost 0, almost 0, -", "1.11, 4.00, 79.70"),
            ("the same on the space scene, of few layers", "-", "12.43, 4.00, 277.44"),
        ],
        evidence: "PPLL takes a link for each fragment, DFB an offset for each pixel, which is little only where \
                   pixels are deep. FFB takes many times as much as either.",
        tests: [gl::claims_lindholm_conditions::l23_dynamic_buffers_take_almost_16_bytes_a_fragment],
    }
    L24 ("section 8") Amended {
        claim: "Combined, ppAO and ppDP guarantee a minimum number of correctly blended samples.",
        evidence: "Cut short after k subpasses, ppDP has blended the k x n nearest fragments right, with ppAO and \
                   without, and counts the others as lost. As printed ties may be among the lost (LX01).",
        tests: [gl::claims_lindholm_conditions::l24_pp_dp_cut_short_has_blended_the_nearest_ones_right],
    }
    L25 ("section 7.2") InKind {
        claim: "All measurements are made with rays that end at a transparency of 0.02, and with arrays of 64, 32, \
                128 and 128.",
        figures: [("records that ppDP reads on the medical scene, exact and at 0.02", "-", "70724, 23460")],
        evidence: "Under these conditions and exactly, side by side: the image is off by 0.014 to 0.018, ppDP reads \
                   less, and static arrays and ppAO read the same. So the termination favours ppDP. The scenes are \
                   made after the paper's.",
        tests: [
            gl::claims_lindholm_conditions::l19_l25_figure_6_under_the_paper_s_conditions_and_exactly,
            gl::claims_lindholm_conditions::l25_termination_saves_most_of_what_pp_dp_reads_of_the_medical_scene,
        ],
    }
}
