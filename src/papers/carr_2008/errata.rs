//! What is wrong or missing in the paper's print.
//!
//! Figures such as "734 of 1024 pixels" are of images of 32 x 32 emulated pixels, each with random surfaces of its own.

errata! {
    CX01 ("section 5.1, pass 3") Error {
        printed: "In figure 2, s9 sets the depth to D(s9).",
        executed: "s9 fails the depth test, and what fails writes no depth. It stays D(s7), in each of the 18 orders \
                   of depth that fit the figure.",
        change: "\"leaves the depth at D(s7)\". Nothing later reads it.",
        tests: [papers::emulator_figure_2::cx01_s9_does_not_set_the_depth_in_pass_3],
    }
    CX02 ("section 5.1, pass 2") Error {
        printed: "In figure 2, s1 is skipped.",
        executed: "s1 passes both tests, is drawn, and counts the stencil down from 3 to 2.",
        change: "\"s1 and s2 pass, and s3 is stopped\".",
        tests: [papers::emulator_figure_2::cx02_s1_is_not_skipped_in_pass_2_but_drawn],
    }
    CX03 ("sections 4.1, 4.2 and 5") Contradiction {
        printed: "The range is [D(s_n), z_min_prev) in 4.1 and (D(s_n), min(...)] in 4.2. In 5 its end has no \
                  bracket; one of two scans guesses \"]\".",
        executed: "Of all orders of depth that can fit figure 2's text, 18 do if the range is half open above. \
                   Closed, pass 3 would count s2. See CX04 to CX06 for each end.",
        change: "[D(s_n), U) everywhere, with U the least of z_min_prev, z_min_post and opaque_depth, and pass 6 for \
                 U itself.",
        tests: [
            papers::figure_2_orders::figure_2_fits_eighteen_orders_with_half_open_ranges_and_none_with_closed_ones,
            papers::emulator_carr_errata::cx04_a_closed_range_in_passes_3_and_4_costs_iterations,
        ],
    }
    CX04 ("section 5.1, passes 3 and 4") Gap {
        printed: "The upper end of the range has no bracket, but \"all surfaces s_i with i < n fall outside this \
                  range\".",
        executed: "If it is read as closed, the image is right, but the surface at z_min_prev comes again and breaks \
                   the run: 24 random surfaces take 25 iterations instead of 13, and sorted ones with two exchanges \
                   25 instead of 6.",
        change: "Read it as half open, as that sentence asks.",
        tests: [papers::emulator_carr_errata::cx04_a_closed_range_in_passes_3_and_4_costs_iterations],
    }
    CX05 ("section 5.2, pass 5") Gap {
        printed: "The upper end of the range has no bracket, and pass 6 peels the surface at it.",
        executed: "If it is read as closed, the surface at the bound is composited by both passes: more than 1000 of \
                   1024 pixels of eight random surfaces are wrong. Sorted ones are right.",
        change: "Read it as half open, as pass 6 implies.",
        tests: [papers::emulator_carr_errata::cx05_a_closed_range_in_pass_5_composites_the_bound_twice],
    }
    CX06 ("section 4.2") Error {
        printed: "The tight bound on the range is (D(s_n), min(z_min_prev, z_min_post)].",
        executed: "Open below, s_n itself is never composited: all of 1024 pixels of eight random surfaces lack \
                   their nearest one.",
        change: "[D(s_n), ...",
        tests: [papers::emulator_carr_errata::cx06_a_range_that_is_open_below_loses_s_n],
    }
    CX07 ("section 4.2") Error {
        printed: "A surface s_i is out of order if D(s_i) <= D(s_(i-1)), whatever s_(i-1) is.",
        executed: "The predecessor may have been peeled or lie outside of the range. z_min_post by this definition \
                   is not what the passes find in 184 of 1024 random sequences of 8 surfaces, and in 226 of 16.",
        change: "Compare with the previous surface inside of [D(s_n), z_min_prev). Passes 3 and 4 do.",
        tests: [papers::emulator_figure_2::cx07_a_predecessor_outside_of_the_range_hides_a_surface_that_is_out_of_order],
    }
    CX08 ("section 5.2, pass 6") Error {
        printed: "The surface at the upper bound is peeled with a z equals test.",
        executed: "Where the bound is the opaque depth, surfaces exactly on the opaque surface are composited in \
                   every iteration. All of 1024 pixels are wrong and the loop never ends.",
        change: "z = U, and z < opaque_depth.",
        tests: [
            papers::emulator_carr_errata::cx08_surfaces_on_the_opaque_surface_are_composited_for_ever,
            gl::claims_carr_options::cx08_what_never_ends_is_given_up_and_says_so,
        ],
    }
    CX09 ("section 5.1") Error {
        printed: "D(s_c) begins at the near plane, and the range behind it is open.",
        executed: "What lies on the near plane is lost, in every pixel that has something there.",
        change: "Begin before the near plane. A depth map cannot hold that, so the first iteration's range is closed \
                 below.",
        tests: [papers::emulator_carr_errata::cx09_surfaces_on_the_near_plane_are_lost],
    }
    CX10 ("section 5.2") Gap {
        printed: "Occlusion queries during the compositing phase tell when nothing is left.",
        executed: "If that is read as pass 5 alone, the loop ends too early where s_n has a tie and the run is \
                   empty: in 337 of 400 images of one pixel.",
        change: "Count passes 5 and 6.",
        tests: [papers::emulator_carr_errata::cx10_counting_pass_5_alone_ends_the_loop_too_early],
    }
    CX11 ("section 5.1, pass 2") Contradiction {
        printed: "Pass 1 counts in (D(s_c), opaque_depth), and pass 2 counts down in (D(s_c), opaque_depth].",
        executed: "Where a surface lies on the opaque one the counts differ and z_min_prev is too loose. The image \
                   is right, and takes 6 iterations instead of 5.",
        change: "Open in both.",
        tests: [papers::emulator_carr_errata::cx11_a_closed_range_in_pass_2_only_costs_iterations],
    }
    CX12 ("section 5.2, passes 5 and 6") Gap {
        printed: "A standard compositing pass clips to the range.",
        executed: "It has no listing. With the stencil and depth tests of pass 4 left on, more than 1000 of 1024 \
                   pixels are wrong, in both variants.",
        change: "Disable both tests and enable blending before pass 5. Undo it before the next iteration.",
        tests: [papers::emulator_carr_errata::cx12_state_left_behind_loses_surfaces],
    }
    CX13 ("section 5.1, passes 2 and 4") Gap {
        printed: "The passes clear colour to white.",
        executed: "In one framebuffer with the image, they erase what has been composited: all of 1024 pixels are \
                   wrong.",
        change: "Mask colour in the passes that find depths, or give them a framebuffer of their own.",
        tests: [papers::emulator_carr_errata::cx13_white_clears_erase_the_image],
    }
    CX14 ("sections 5.2 and 6") Gap {
        printed: "Blending is enabled for compositing and by section 6's pass, and never disabled.",
        executed: "Harmless where maps are copies of the depth buffer, as here: the image is the same bit for bit. \
                   It would spoil maps that are read from colour.",
        change: "None, if maps are depths.",
        tests: [papers::emulator_carr_errata::cx14_blending_left_on_does_no_harm_where_maps_are_depths],
    }
    CX15 ("section 5.1") Gap {
        printed: "Depths are stored in maps.",
        executed: "How they get there is not said, and each pass clears the depth that the one before has found. \
                   Without the copy behind pass 1, 2 or 4, all of 1024 pixels are wrong.",
        change: "Copy the depth buffer into a map behind passes 1, 2 and 4.",
        tests: [papers::errata_carr::cx15_each_map_is_lost_that_is_not_copied_before_the_next_pass],
    }
    CX16 ("section 6") Error {
        printed: "glBlendFuncSeparate(ZERO, DEST_ALPHA, ONE, ZERO), beside a sentence that multiplies the source \
                  colour by the destination alpha.",
        executed: "The factors multiply the destination colour instead, which becomes the product of all depths \
                   before. Two surfaces come out right by chance; of eight random ones, 734 of 1024 pixels are \
                   wrong.",
        change: "(DST_ALPHA, ZERO, ONE, ZERO), as the sentence says.",
        tests: [papers::emulator_carr_errata::cx16_the_printed_blend_factors_multiply_all_earlier_depths],
    }
    CX17 ("section 6") Gap {
        printed: "Depths are kept in colour channels by floating point blending.",
        executed: "Of which precision is not said. 16-bit floats round z_min_prev, which may come to lie before \
                   D(s_n): 2 of 1024 pixels are wrong, after 16 iterations instead of 9.",
        change: "32-bit floats.",
        tests: [papers::emulator_carr_errata::cx17_sixteen_bit_floats_are_not_enough_for_depths],
    }
    CX18 ("section 6") Name {
        printed: "glClearStencil without a clear of the stencil, glClear of the depth and again with the colour, and \
                  z_prev_min for z_min_prev.",
        executed: "The first two calls do nothing: the image, the iterations and the end are the same without them. The \
                   name is turned around.",
        change: "Leave the two calls out, and write z_min_prev.",
        tests: [
            papers::emulator_carr_errata::cx18_two_calls_of_section_6_do_nothing,
            papers::errata_in_print::cx18_z_min_prev_is_called_z_prev_min_once,
        ],
    }
    CX19 ("Algorithm 1, line 17") Error {
        printed: "zPeel < zFragment < zPeelNext",
        executed: "Sorted surfaces exactly at a peel's depth are lost: 812 of 1024 pixels of 20 surfaces on 64 \
                   depths are wrong.",
        change: "zPeel <= zFragment < zPeelNext. Of equal depths the unsorted ones come first.",
        tests: [papers::emulator_carr_errata::cx19_sorted_surfaces_at_a_peel_depth_are_lost],
    }
    CX20 ("Algorithm 1, line 23") Error {
        printed: "zFragment = zPeelNext",
        executed: "Where nothing is left, zPeelNext is zOpaque, and unsorted surfaces on the opaque one are \
                   composited in every iteration: 840 of 1024 pixels are wrong.",
        change: "... and zFragment < zOpaque",
        tests: [papers::emulator_carr_errata::cx20_unsorted_surfaces_on_the_opaque_surface_are_composited_in_every_iteration],
    }
    CX21 ("Algorithm 1, line 2") Error {
        printed: "zPeel <- zNear",
        executed: "Unsorted surfaces on the near plane are lost, in more than 100 of 1024 pixels of eight surfaces \
                   on 16 depths.",
        change: "Begin before zNear.",
        tests: [papers::emulator_carr_errata::cx21_unsorted_surfaces_on_the_near_plane_are_lost],
    }
    CX22 ("Algorithm 2, lines 10 and 31") Error {
        printed: "zPeel <- z3, and what lies at zPeel is composited in pass 1.",
        executed: "A pixel with nothing left keeps z3 and composites its last layer again in each further iteration: \
                   1020 of 1024 pixels of eight random surfaces are wrong. A single pixel does not show it, because \
                   the loop ends with it.",
        change: "z3 <- zOpaque after line 10, and zFragment < zOpaque in line 31.",
        tests: [
            papers::emulator_carr_errata::cx22_pixels_that_are_done_composite_their_last_layer_again,
            gl::claims_carr_options::cx22_as_printed_the_ideal_gpu_composites_layers_again,
        ],
    }
    CX23 ("Algorithm 2, line 37") Gap {
        printed: "Pass 2 ends at z3, and z2 is computed but bounds nothing there.",
        executed: "Reversed surfaces take an iteration each, where section 5 takes one for two: 16 take 17 instead \
                   of 9.",
        change: "End at z2 where nothing broke the run, and go on from there. It is an improvement, not a correction.",
        tests: [papers::emulator_carr_errata::cx23_the_tighter_bound_halves_reversed_input],
    }
    CX24 ("Algorithm 2, gChanged") Gap {
        printed: "gChanged tells whether a fragment was found; Algorithm 1 notes an occlusion query beside it.",
        executed: "Pass 1 of Algorithm 2 composites, too. A query over it counts that, takes an iteration more, and \
                   together with CX22 never ends.",
        change: "Count changed pixels apart from composited fragments.",
        tests: [papers::errata_carr::cx24_a_query_over_pass_1_counts_what_it_composites_too],
    }
    CX25 ("section 5") Contradiction {
        printed: "The opening promises five passes. Section 6 brings \"the total count to five\" by saving one.",
        executed: "Section 5 has six, as Table 1 counts (7 iterations, 42 geometry passes).",
        change: "\"six passes\".",
        tests: [
            papers::listings_carr::cx25_the_passes_of_section_5_are_six,
            papers::errata_in_print::cx25_five_passes_are_promised_and_then_saved_to,
        ],
    }
    CX26 ("section 5.1, pass 4") Name {
        printed: "\"The logic in Figure 5.1\".",
        executed: "There is no such figure. The figures are 1 to 5.",
        change: "\"in the listing below\".",
        tests: [papers::errata_in_print::cx26_there_is_no_figure_5_1],
    }
    CX27 ("sections 4.1 and 4.2") Name {
        printed: "z_min_prev and z_min_post are arg min of D(s).",
        executed: "That is a surface, but both are used as depths from there on.",
        change: "min.",
        tests: [papers::errata_in_print::cx27_a_minimum_is_printed_as_its_argument],
    }
    CX28 ("figure 1, section 8 and table 1") Number {
        printed: "The speed-up of one scene is 62 in figure 1 and 52 in section 8. The Dragon has 150K faces and \
                  749K vertices.",
        executed: "150K triangles have 450K corners at the most. A closed mesh has half as many vertices as faces, \
                   as the Lucy of the same table has: 74.9K would fit.",
        change: "74.9K, perhaps. Which speed-up is right cannot be told.",
        tests: [papers::errata_in_print::cx28_table_1_s_dragon_has_more_vertices_than_corners],
    }
    CX29 ("sections 5.1 and 8, figure 3") Gap {
        printed: "Coherent layer peeling processes at most 128 surfaces in an iteration, and its passes remain \
                  constant up to 256 slices.",
        executed: "Both are true only if the cone leaves no more than 128 slices in one run, and where it lies is not \
                   said. With a third of the slices before it, in it and behind it, 256 take as many iterations as \
                   32. With a cone near the front 128 take 4 iterations, 256 take 5 and 512 take 7.",
        change: "\"constant while no more than 128 slices follow one another\".",
        tests: [papers::errata_carr::cx29_where_the_cone_lies_decides_up_to_how_many_slices_iterations_are_constant],
    }
    CX30 ("figure 1") Number {
        printed: "256 slices and a cone take layer peeling 257 iterations and hybrid layer peeling 3.",
        executed: "Where the cone has n layers in a pixel that sees all slices, they take 257 + n and n + 1, or one \
                   less each if the last, empty iteration does not count. No n gives 257 and 3.",
        change: "259 and 3, or 258 and 2.",
        tests: [papers::errata_carr::cx30_no_cone_takes_257_and_3_iterations],
    }
    CX31 ("section 4") Name {
        printed: "s_0 to s_(n-1) are the surfaces, and s_n is the first one behind the last peeled.",
        executed: "n is the number of surfaces and the index of one of them, which is not among s_0 to s_(n-1).",
        change: "Another letter for the number.",
        tests: [papers::errata_in_print::cx31_n_is_the_count_and_an_index],
    }
    CX32 ("section 4.2") Name {
        printed: "The list with a hat \"is given by\" a list with a caron, and the cases of z_min_post ask whether \
                  the one with the hat is empty.",
        executed: "The list with the hat is that of section 4.1.",
        change: "The caron, in all three places.",
        tests: [papers::errata_in_print::cx32_two_lists_are_mixed_up],
    }
    CX33 ("section 6") Name {
        printed: "DEST_ALPHA",
        executed: "OpenGL has no such factor.",
        change: "DST_ALPHA.",
        tests: [papers::errata_carr::cx33_one_of_section_6_s_four_factors_is_none_of_opengl_s],
    }
    CX34 ("section 8 and table 1") Contradiction {
        printed: "\"We compare a top and side view of some models.\"",
        executed: "Table 1 has front, side and end on, and no top. Its two rows for the Dragon, front and side, are \
                   identical.",
        change: "The views of the table. One of the Dragon's rows is probably a copy of the other.",
        tests: [papers::errata_in_print::cx34_table_1_has_no_top_view_and_one_row_twice],
    }
    CX35 ("section 7") Gap {
        printed: "The list of what is available to the rasterization shader: zFragment, zPeel, zOpaque, z1, z2, z3.",
        executed: "Algorithm 2 also keeps zPostFlag for each pixel, from line 11 on.",
        change: "Add zPostFlag.",
        tests: [papers::errata_in_print::cx35_the_post_flag_is_not_among_what_is_available],
    }
    CX36 ("section 5.1, pass 3") Error {
        printed: "The pass leaves \"a stencil value that gives an upper bound on the number of surfaces\" in order.",
        executed: "Where a surface breaks the run, it is inverted: 251 for four surfaces, that is 255 less the \
                   number.",
        change: "\"255 less the number, where the run was broken\".",
        tests: [papers::emulator_figure_2::c09_pass_3_counts_s3_s5_s6_and_s7_and_s9_inverts_the_count],
    }
}
