//! Buffers that fragments read and write in the order of submission: by images, held against what framebuffer fetch makes
//! of them, and against the oracle. Drivers have one of the two: Mesa's llvmpipe fetches, NVIDIA's interlocks images.

use crate::kit::bounds::F32;
use crate::kit::render::{example, render};
use crate::kit::stack::row;
use onionskin::options::{BufferAccess, MultiLayerOptions, Nodes};
use onionskin::{Comparison, Context, Method, Renderer};

const NODES: [Nodes; 2] = [Nodes::Four, Nodes::Eight];

fn by_images(nodes: Nodes) -> Method {
    Method::MultiLayerAlphaBlending(MultiLayerOptions {
        nodes,
        access: BufferAccess::Images,
    })
}

/// Without an interlock nothing promises the order. llvmpipe, which draws each tile by one thread, keeps it.
fn keeps_the_order(context: &Context) -> bool {
    let driver = context.driver();
    let keeps = driver.has("GL_ARB_fragment_shader_interlock") || driver.quirks().runs_in_order;
    if !keeps {
        println!("skipped: no GL_ARB_fragment_shader_interlock");
    }
    keeps
}

/// Scenes with opaque surfaces before transparent ones, and the depth by either measure.
#[test]
fn by_images_every_image_is_the_same() {
    let context = Context::headless().unwrap();
    if !keeps_the_order(&context) {
        return;
    }
    if !context.driver().has("GL_EXT_shader_framebuffer_fetch") {
        println!("skipped: no GL_EXT_shader_framebuffer_fetch to compare with");
        return;
    }
    for name in ["teapot", "soup"] {
        let scene = example(name, [96, 72]);
        for nodes in NODES {
            for inverse_w in [false, true] {
                let [images, fetched] = [BufferAccess::Images, BufferAccess::Best].map(|access| {
                    let mut renderer = Renderer::new(&context, 96, 72).unwrap();
                    if inverse_w {
                        renderer = renderer.with_inverse_w();
                    }
                    let options = MultiLayerOptions { nodes, access };
                    renderer.render(&scene, &options).unwrap().image
                });
                assert!(images == fetched, "{name}, {nodes:?}, 1/w: {inverse_w}");
            }
        }
    }
}

#[test]
fn by_images_as_many_fragments_as_nodes_are_exact() {
    let context = Context::headless().unwrap();
    if !keeps_the_order(&context) {
        return;
    }
    for nodes in NODES {
        let most = nodes as usize;
        let stack = row(&[0, 1, 2, 3, most - 1, most]);
        let frame = render(&context, &stack.scene(), &by_images(nodes));
        let error = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
        assert_eq!(error.over, 0, "{nodes:?}: {error:?}");
        // One more would be merged, and the image hangs on the order: the control.
        let stack = row(&[40; 6]);
        let frame = render(&context, &stack.scene(), &by_images(nodes));
        let error = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
        assert!(error.over > 0, "{nodes:?}: {error:?}");
    }
}
