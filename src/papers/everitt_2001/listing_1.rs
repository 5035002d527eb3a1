//! Listing 1: depth peeling, for an OpenGL with two depth units.

use crate::steps;
use crate::steps::{Dialect, Listing};

/// Listing 1, line by line.
pub const LISTING_1: Listing = Listing {
    title: "Pseudocode for depth peeling using multiple simultaneous depth buffers",
    source: "Everitt 2001, Listing 1",
    dialect: Dialect::Phrases,
    steps: steps! {
        printed;
        for (i in 0..num_passes) {
            clear color buffer;
            A = i % 2;
            B = (i + 1) % 2;
            depth unit 0: {
                if (i == 0) {
                    disable depth test;
                } else {
                    enable depth test;
                }
                bind buffer A;
                disable depth writes;
                set depth func to GREATER;
            }
            depth unit 1: {
                bind buffer B;
                clear depth buffer;
                enable depth writes;
                enable depth test;
                set depth func to LESS;
            }
            render scene;
            save color buffer RGBA as layer i;
        }
    },
};
