//! What the page claims, and what running it has shown.

claims! {
    V01 ("VTK calls") Reproduced {
        claim: "Peeling stops after the user's largest number of passes, which is 4 if the user says nothing.",
        figures: [("peels if nothing is said", "4", "4 by VTK's settings, no limit by the method")],
        evidence: "The loop stops after n peels, the image is that of the n nearest layers, and what the limit \
                   leaves out is counted. VTK's settings begin with 4. The method by itself has no limit, because \
                   four peels lose layers of most scenes (VX02).",
        tests: [
            gl::claims_vtk::v01_the_loop_ends_after_the_maximum_number_of_peels,
            gl::claims_vtk::v01_the_image_of_n_peels_is_that_of_the_n_nearest_layers,
            gl::claims_vtk::v01_what_the_limit_leaves_out_is_counted,
            gl::claims_vtk_settings::v01_vtk_s_initial_maximum_is_4_peels,
        ],
    }
    V02 ("introduction; Comments on references") Amended {
        claim: "Peeling stops after the peel that changed fewer pixels than a ratio of the window's area. A ratio of \
                0, the default, is exact.",
        evidence: "So it does, if pixels are counted. The query of the peel, which the page names, counts every \
                   fragment that lowered the depth (VX09), so the layer's pixels are counted by a query of their \
                   own.",
        tests: [
            gl::claims_vtk::v02_the_loop_stops_when_a_peel_changed_fewer_pixels_than_the_ratio,
            gl::claims_vtk::v02_a_ratio_of_0_is_exact_and_the_default,
            gl::claims_vtk::v02_a_larger_ratio_needs_no_more_peels,
            gl::claims_vtk::v02_pixels_are_counted_and_not_the_fragments_that_changed_them,
            gl::claims_vtk::v02_what_the_ratio_leaves_out_is_counted,
            gl::claims_vtk::v02_without_the_amendment_the_ratio_would_be_ignored,
        ],
    }
    V03 ("VTK changes; Comments on references") Reproduced {
        claim: "Opaque geometry is drawn first and culls transparent geometry, which lowers the number of layers.",
        evidence: "Of four layers, an opaque surface leaves 4, 3, 1 or 0, by where it lies, and no pass is made for \
                   what is culled. Without the culling there are four layers again.",
        tests: [
            gl::claims_vtk_layers::v03_opaque_geometry_culls_what_lies_behind_it_and_lowers_the_number_of_layers,
            gl::claims_vtk_layers::v03_what_is_culled_makes_no_pass,
            gl::claims_vtk_layers::v03_without_the_amendment_the_number_of_layers_is_not_lowered,
        ],
    }
    V04 ("Comments on references") Reproduced {
        claim: "An occlusion query for each peel finds the layer that is empty, and the loop ends.",
        evidence: "Scenes of 0 to 4 layers take one peel more than they have layers. Without the query nothing but a \
                   limit ends the loop.",
        tests: [
            gl::claims_vtk_layers::v04_the_empty_layer_ends_the_loop,
            gl::claims_vtk_layers::v04_without_the_query_the_loop_would_not_end,
        ],
    }
    V05 ("VTK calls, step 5") Reproduced {
        claim: "The caller can ask whether depth peeling was used for the last frame.",
        evidence: "Every frame says that it was, or why it was not: nothing is transparent, or another method was \
                   asked for.",
        tests: [
            gl::claims_vtk_layers::v05_a_frame_says_that_depth_peeling_was_used,
            gl::claims_vtk_layers::v05_a_frame_without_anything_transparent_says_why_it_was_not,
            gl::claims_vtk_layers::v05_a_frame_of_another_method_says_why_it_was_not,
            gl::claims_vtk_settings::v05_a_caller_can_ask_whether_depth_peeling_was_used_and_why_not,
        ],
    }
    V06 ("VTK changes") Reproduced {
        claim: "Every peeled layer is kept and then composited back to front, which takes memory by the number of \
                peels. Compositing front to back would need none of it.",
        evidence: "Both ways give one image, to the rounding of 32-bit floats. Kept layers take 24 bytes a pixel and \
                   layer; compositing on the fly takes the same for any number. The page doubts that it is possible \
                   (VX10).",
        tests: [
            gl::claims_vtk_layers::v06_both_ways_of_compositing_give_the_same_image,
            gl::claims_vtk_layers::v06_kept_layers_take_memory_by_their_number,
            gl::claims_vtk_layers::v06_compositing_on_the_fly_takes_the_same_memory_for_any_number_of_layers,
            gl::claims_vtk_layers::v06_compositing_over_instead_of_under_would_be_noticed,
            gl::peeling::every_pixel_of_a_layer_is_counted_once,
        ],
    }
    V07 ("OpenGL context requirement") Reproduced {
        claim: "At least 8 bits of alpha are needed.",
        evidence: "A layer is a colour and an opacity. Formats with fewer bits are refused by name, 8 bits will do, \
                   and the bits are those that OpenGL itself reports.",
        tests: [
            gl::claims_vtk_requirements::v07_fewer_than_8_alpha_bits_are_refused_with_what_to_choose,
            gl::claims_vtk_requirements::v07_8_alpha_bits_will_do_and_methods_without_layers_need_none,
            gl::claims_vtk_requirements::v07_the_bits_are_those_that_opengl_counts,
        ],
    }
    V08 ("Linux Nvidia driver") Reproduced {
        claim: "Shadow lookups go through a rectangle texture.",
        evidence: "Peeled through rectangle textures, a scene has the layers that it has through 2D textures, to the \
                   last bit, at three odd sizes. By default 2D textures of any size are looked up, which OpenGL has \
                   had since 2.0.",
        tests: [
            gl::claims_vtk_settings::v08_depth_peeling_through_rectangle_textures_gives_the_same_image,
            gl::classic_fixed_function::v08_a_rectangle_texture_gives_what_a_texture_of_2d_gives,
        ],
    }
    V09 ("Required OpenGL extensions") Reproduced {
        claim: "Ten extensions are required.",
        figures: [("required extensions", "10", "10")],
        evidence: "They are asked for by name. Those that are missing are listed, unless the version of OpenGL has \
                   them in its core, and either name of the tenth will do.",
        tests: [
            gl::claims_vtk_requirements::v09_this_driver_lacks_nothing,
            papers::vtk_requirements::v09_what_is_core_is_not_missing,
            papers::vtk_requirements::v09_an_old_driver_lacks_what_it_does_not_name,
            papers::vtk_requirements::v09_either_of_two_names_will_do,
            papers::vtk_requirements::v09_with_nothing_at_all_every_one_is_listed_in_the_page_s_order,
        ],
    }
    V10 ("VTK calls, steps 1 and 2") Reproduced {
        claim: "Depth peeling is off at first. The caller asks for alpha bit planes, and chooses it.",
        evidence: "With VTK's initial settings, and with one of the two alone, a frame is blended as it comes. With \
                   both it is peeled.",
        tests: [gl::claims_vtk_settings::v10_depth_peeling_is_off_at_first_and_needs_alpha_bit_planes],
    }
}
