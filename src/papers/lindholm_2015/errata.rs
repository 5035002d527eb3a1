//! What is wrong or missing in the paper's print.

errata! {
    LX01 ("section 5.2, if depth(f) <= min depth") Error {
        printed: "A fragment is skipped if its depth is at most that of the last one that was resolved.",
        executed: "Where the buffer ends among fragments of equal depth, the others are lost: of 20 coplanar ones, \
                   with a buffer of 8, all but 8. With volumes, a lost face is a volume that is not seen or does not \
                   end.",
        change: "Compare depth and id.",
        tests: [
            papers::emulator_lists::l13_ties_are_lost_where_a_buffer_ends_as_printed,
            gl::claims_lindholm_resolve::l13_as_printed_ties_are_lost_where_a_buffer_ends_and_amended_none,
            gl::fused_as_printed::l13_a_tie_that_is_lost_is_a_volume_that_is_not_seen_or_does_not_end,
        ],
    }
    LX02 ("section 5.2") Contradiction {
        printed: "The text sorts n - 1 fragments a subpass. The pseudocode resolves n and goes on from the last, the \
                  n-th.",
        executed: "To resolve n - 1 and go on from the n-th loses one with each subpass that is followed by another.",
        change: "Resolve n, as the pseudocode does, or go on from the (n-1)-th.",
        tests: [papers::emulator_lists::l12_n_minus_1_a_pass_but_going_on_from_the_nth_loses_one_a_pass],
    }
    LX03 ("section 5.2, until all fragments are resolved") Gap {
        printed: "The loop ends when all fragments are resolved.",
        executed: "How that is known is not said. Read as a count, it never ends once a tie was lost (LX01).",
        change: "End after a subpass that has dropped nothing.",
        tests: [papers::emulator_lists::l13_a_loop_that_waits_for_a_lost_fragment_never_ends],
    }
    LX04 ("section 5.2, set min depth to 0") Error {
        printed: "The minimal depth begins at 0, and what is at most as deep is skipped.",
        executed: "A fragment at depth 0 is lost.",
        change: "Begin before all depths.",
        tests: [
            papers::emulator_lists::l13_what_lies_at_depth_0_is_skipped_as_printed,
            gl::fused_as_printed::l13_a_face_before_the_near_plane_is_skipped_and_the_fog_is_inside_out,
        ],
    }
    LX05 ("section 5.1, if depth complexity(p) <= i") Gap {
        printed: "Segments are 8, 16, ... max, and a pixel belongs to the first that is not less than its count.",
        executed: "A pixel of more than max fragments is in none, and not resolved at all. Section 7.2 would have \
                   its first 128 layers.",
        change: "\"or i = max\".",
        tests: [
            papers::emulator_lists::l11_past_the_last_segment_nothing_is_resolved_as_printed,
            gl::claims_lindholm_pp_ao::l11_as_printed_the_stencil_loses_what_lies_past_the_last_segment,
            gl::claims_lindholm_pp_ao::lx05_by_counter_alone_exactly_what_lies_past_the_last_segment_is_lost,
            gl::fused_as_printed::l11_past_the_last_segment_there_is_no_fog,
        ],
    }
    LX06 ("section 6.2") Error {
        printed: "An 8-bit stencil buffer does not limit the depth complexity: all higher ones share a segment.",
        executed: "By INCR they share one only if max is 255 or more, whose array is then too small for them. By \
                   INCR_WRAP, 260 fragments are given an array of 8.",
        change: "Count in an integer buffer, as section 5.1 says. 6.2 itself names a texture of higher precision for \
                 larger segments.",
        tests: [
            papers::emulator_lists::l11_eight_bits_send_what_is_past_255_to_the_wrong_segment,
            gl::claims_lindholm_pp_ao::l11_complexities_of_255_and_more_share_the_last_segment_and_none_is_lost,
        ],
    }
    LX07 ("sections 5.1 and 6.2") Gap {
        printed: "A pixel that is resolved is marked.",
        executed: "How a stencil buffer does this is not said. KEEP and REPLACE resolve pixels again in every later \
                   segment. INVERT works for segments up to 128.",
        change: "None is needed if a pixel belongs to one segment by its count.",
        tests: [
            papers::emulator_lists::l11_of_the_marks_only_invert_works_and_only_up_to_128,
            gl::claims_lindholm_pp_ao::lx07_as_printed_pixels_are_resolved_twice,
            gl::fused_as_printed::lx07_with_a_segment_of_256_the_fog_is_seen_through_itself,
        ],
    }
    LX08 ("section 6.2") Name {
        printed: "\"The Fill Step is enclosed in a loop on the CPU\", which goes over the segments.",
        executed: "Filled once for each of four segments, a pixel of three fragments has twelve, and shows each four \
                   times.",
        change: "\"The Resolve Step\", as in section 5.1.",
        tests: [papers::errata_lindholm::lx08_filled_once_a_segment_every_fragment_is_there_four_times],
    }
    LX09 ("abstract and section 7.2") Number {
        printed: "Gains \"of up to eight times\", and \"about eightfold\" on average over all scenes and GPUs.",
        executed: "The largest of several gains is their average only if all of them are equal.",
        change: "One of the two. Figure 6 is not at hand as numbers.",
        tests: [papers::errata_in_print::lx09_an_average_is_printed_as_a_maximum],
    }
    LX10 ("sections 5.1 and 7.2") Contradiction {
        printed: "By the pseudocode nothing past max is resolved. In 7.2, \"only the first 128 layers were \
                  resolved\".",
        executed: "The pseudocode resolves no layer of such a pixel (LX05).",
        change: "As for LX05. The sentence of 7.2 is its authority.",
        tests: [
            papers::emulator_lists::l11_past_the_last_segment_nothing_is_resolved_as_printed,
            papers::errata_in_print::lx10_layers_past_the_last_segment_are_told_in_two_ways,
        ],
    }
    LX11 ("section 5.2, store min depth ... of last buffer element") Gap {
        printed: "Each subpass stores the depth of the last element of the buffer.",
        executed: "An empty list takes a subpass, whose buffer has no last element.",
        change: "Store nothing if the buffer is empty, or leave out pixels without fragments.",
        tests: [papers::errata_lindholm::lx11_an_empty_list_takes_a_subpass_without_a_last_element],
    }
    LX12 ("section 4, Managing Local GPU Caches") Gap {
        printed: "\"All fragments beyond this number are discarded.\"",
        executed: "Beyond it in which order is not said. FFB and DFB keep the fragments that were submitted first, \
                   PPLL those that came last, and their images differ.",
        change: "Keep the nearest, whatever the manager, which is an option here.",
        tests: [
            gl::a_buffer_kept::l09_a_full_array_keeps_what_each_manager_s_list_begins_with,
            gl::a_buffer_kept::what_is_kept_decides_how_wrong_the_image_is,
            papers::emulator_lists::l09_a_full_array_keeps_the_first_of_its_list_or_the_nearest,
        ],
    }
    LX13 ("section 7.2") Name {
        printed: "\"neuro and flow\"",
        executed: "No scenes have these names. They are medical and cfd everywhere else.",
        change: "\"medical and cfd\".",
        tests: [papers::errata_in_print::lx13_two_scenes_have_other_names_once],
    }
    LX14 ("section 7.2") Number {
        printed: "12.6 MiB for each depth layer at 1024 x 768.",
        executed: "1024 x 768 records of 16 bytes are 12.6 MB, and 12.0 MiB.",
        change: "12.0 MiB, or MB.",
        tests: [gl::claims_lindholm::l08_a_layer_of_a_fixed_buffer_takes_12_6_megabytes_which_are_12_mebibytes],
    }
    LX15 ("section 6.1") Gap {
        printed: "Occupancy changes where a fragment of a volume's proxy is met, and rays are cast between fragments.",
        executed: "For an eye inside of a volume no fragment is met where it is entered, and nothing ends a ray at \
                   an opaque surface. Every list of which one of these is true comes out wrong.",
        change: "Begin inside of what is only left, and end at the opaque depth.",
        tests: [
            papers::emulator_fused::l16_without_where_it_begins_a_ray_is_wrong_exactly_where_it_begins_inside,
            papers::emulator_fused::l16_without_the_opaque_surface_a_ray_goes_on_behind_it,
        ],
    }
    LX16 ("sections 5.1 and 6.2") Contradiction {
        printed: "The counter of 5.1 is an integer buffer. The buffer of 6.2, which masks, is a stencil buffer of 8 bits.",
        executed: "How the counts come from one into the other is not said. A stencil buffer that holds none masks \
                   nothing, so that every segment resolves every pixel.",
        change: "Count into the stencil buffer along with the fill, by INCR, or mask by the integer counter.",
        tests: [gl::claims_lindholm_pp_ao::lx16_literally_the_stencil_buffer_holds_no_count_and_masks_nothing],
    }
}
