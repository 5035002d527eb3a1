//! What is wrong or missing in the page's print, and where VTK behaves otherwise than its page and its documentation
//! say.
//!
//! Rows of the kind `Program` are no errors of the print. VTK 9.7.2 was run on llvmpipe for them; it is no part of this
//! project. The tests hold onionskin to the exact image of the same scene files, and VTK to what is said here where it
//! is installed.

errata! {
    VX01 ("VTK calls, step 3") Program {
        printed: "VTK documents a maximum of 0 peels as no limit.",
        executed: "VTK's dual pass, its default, peels nothing then and blends in the order of submission: four \
                   panes of 0.5 are off by 80 of 255. Its single pass honours the 0.",
        change: "Ask for very many peels instead of 0. Here 0 is no limit in every method.",
        tests: [
            peer_vtk::errata::vx01_by_0_peels_vtk_s_dual_pass_blends_unsorted,
            gl::claims_vtk_requirements::v01_0_peels_is_no_limit_in_every_method_as_vtk_documents_it,
        ],
    }
    VX02 ("VTK calls, step 3") Program {
        printed: "The initial value of the maximum number of passes is 4, and that of the occlusion ratio 0, \"exact \
                  image\".",
        executed: "With both initial values the image is not exact if there are more layers. Of twelve panes of 0.2 \
                   the single pass cuts eight off, and is off by 12 of 255. The dual pass blends the rest unsorted, \
                   and is off by 6.",
        change: "Ask for as many peels as there are layers. Here there is no limit by default, and a limit says what \
                 it loses.",
        tests: [
            peer_vtk::errata::vx02_four_peels_leave_layers_out,
            gl::claims_vtk::v01_what_the_limit_leaves_out_is_counted,
        ],
    }
    VX03 ("introduction") Program {
        printed: "Geometry is peeled until there is no more to render.",
        executed: "Of a red and a green pane in one plane VTK's single pass keeps the second alone, and its dual \
                   pass makes (128, 128, 0), which nobody has drawn. Right is (128, 64, 0), if red was submitted \
                   first.",
        change: "Peel every fragment of a depth (coplanar-depth-peeling), or blend colours of equal depth under one \
                 another (dual-depth-peeling).",
        tests: [
            peer_vtk::errata::vx03_vtk_merges_or_drops_what_is_coplanar,
            gl::coplanar::vx03_coplanar_peeling_has_every_tie_in_the_order_of_submission,
            gl::coplanar::vx03_red_and_green_at_one_depth_are_red_before_green,
            gl::dual_peeling::vx03_blending_colors_by_max_merges_what_is_coplanar,
            papers::emulator_coplanar::vx03_every_sequence_is_composited_with_its_ties_in_the_order_of_submission,
        ],
    }
    VX04 ("introduction") Program {
        printed: "Geometry is peeled until there is no more to render.",
        executed: "Where a face is there twice, as in models from scans, both of VTK's passes lose one of them: a \
                   red pane that is doubled is off by more than 30 of 255.",
        change: "As for VX03.",
        tests: [
            peer_vtk::errata::vx04_vtk_loses_a_layer_where_faces_are_doubled,
            gl::coplanar::real_meshes_with_duplicated_faces_lose_none,
        ],
    }
    VX05 ("VTK changes") Program {
        printed: "Each peel is saved as an RGBA buffer.",
        executed: "VTK's buffers have 8 bits. 64 panes of 0.0015 vanish altogether, since each is less than half a \
                   step, and the dual pass stops after one peel. 256 panes of 0.02 are off by 12 of 255 by the \
                   single pass.",
        change: "Accumulate in 32-bit floats, as is the default here.",
        tests: [
            peer_vtk::errata::vx05_vtk_s_8_bits_do_not_add_up_faint_layers,
            gl::claims_vtk_settings::vx05_layers_below_the_step_of_8_bits_are_peeled_and_counted_all_the_same,
            gl::accumulation::e12_the_accumulator_s_error_grows_with_depth_complexity_and_with_its_step,
        ],
    }
    VX06 ("introduction") Program {
        printed: "Geometry is peeled until there is no more to render. What depth precision that takes is not said.",
        executed: "Between planes at 0.001 and 10,000 four panes a thousandth apart, 3 from the eye, become two or \
                   three by VTK, off by more than 30 of 255. Between planes at 1 and 8 they are right.",
        change: "Draw between planes close around the scene, which is the default here, or test 1/w, which is an \
                 option.",
        tests: [
            peer_vtk::errata::vx06_by_loose_planes_vtk_merges_layers,
            gl::claims_vtk_settings::vx06_loose_planes_make_ties_which_depth_peeling_loses_and_coherent_peeling_cannot_order,
            gl::exact_depth::by_1_over_w_every_method_that_can_keeps_apart_what_window_depth_confuses,
        ],
    }
    VX07 ("VTK calls, step 2") Program {
        printed: "Depth peeling is off at first; the caller chooses it.",
        executed: "What VTK 9.5 and later do instead is not blending, but an average of colours by their alpha. It \
                   is independent of order, and off by more than 20 of 255 for four panes of four colours.",
        change: "Choose a method that sorts. `weighted-blended` is such an average here, and is said not to be exact.",
        tests: [peer_vtk::errata::vx07_without_peeling_vtk_averages_colours],
    }
    VX08 ("introduction; VTK calls, step 3") Gap {
        printed: "A larger ratio renders faster. How far the image may then be off is not said.",
        executed: "The ratio bounds the pixels that a peel changes, and not the error. Twelve panes that shrink by \
                   turns are off by more than 2 of 255 with a ratio of 0.05, here and by VTK's single pass, and by \
                   more than 10 by its dual pass.",
        change: "Leave it at 0, or look at what is counted as lost.",
        tests: [
            peer_vtk::errata::vx08_an_occlusion_ratio_does_not_bound_the_image_s_error,
            gl::claims_vtk::v02_what_the_ratio_leaves_out_is_counted,
        ],
    }
    VX09 ("Comments on references") Error {
        printed: "The query \"can count the number of pixels that changed\".",
        executed: "It counts samples that pass. A pixel whose ten fragments come back to front counts ten times.",
        change: "Count the layer's pixels by a pass over the screen.",
        tests: [gl::claims_vtk::v02_pixels_are_counted_and_not_the_fragments_that_changed_them],
    }
    VX10 ("VTK changes") Error {
        printed: "Layers are kept, \"if it was possible to do front-to-back compositing\" they need not be.",
        executed: "It is possible: blending with (ONE_MINUS_DST_ALPHA, ONE) puts each layer under those before it. \
                   The image is the same, and no layer is kept.",
        change: "Composite on the fly.",
        tests: [
            gl::claims_vtk_layers::v06_both_ways_of_compositing_give_the_same_image,
            gl::claims_vtk_layers::v06_compositing_on_the_fly_takes_the_same_memory_for_any_number_of_layers,
        ],
    }
    VX11 ("OpenGL context requirement") Name {
        printed: "At least 8 alpha bits are needed, so call SetAlphaBitPlanes(1).",
        executed: "The number of the sentence and the number of the call are not of one kind: the argument is a \
                   boolean, as the page itself says further down (\"initial value is 0 (false)\").",
        change: "Say that the call asks for alpha bits, and not how many.",
        tests: [papers::errata_in_print::vx11_eight_bits_are_asked_for_by_a_boolean],
    }
}
