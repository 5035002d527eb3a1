//! Everitt's figure 4 (E11): a cross section of the view volume, peeled.

use onionskin::low_level::gl::CapturedFragment;
use onionskin::options::{Compositing, DepthPeelingOptions};
use onionskin::report::{CrossSection, Plot};
use onionskin::{Context, Method, Renderer, Scene};

use crate::kit::lists::Lists;

#[test]
pub(crate) fn e11_each_layer_has_the_frontmost_of_what_the_layers_before_have_left() {
    let context = Context::headless().unwrap();
    for name in ["teapot", "knots"] {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/scenes");
        let scene = Scene::load_at(format!("{folder}/{name}.toml"), Some([160, 120])).unwrap();
        let options = DepthPeelingOptions {
            compositing: Compositing::KeepLayers,
            ..Default::default()
        };
        let mut renderer = Renderer::new(&context, 160, 120).unwrap();
        let frame = renderer
            .render(&scene, &Method::DepthPeeling(options))
            .unwrap();
        let lists = Lists::of(&context, &scene).distinct();
        // The row of pixels with most fragments.
        let fragments = |row: &usize| lists.pixels[row * 160..][..160].iter().map(Vec::len).sum();
        let row = (0..120)
            .max_by_key(|row| -> usize { fragments(row) })
            .unwrap();
        let depths = |pixel: &Vec<CapturedFragment>| pixel.iter().map(|f| f.depth).collect();
        let cut: Vec<Vec<f32>> = lists.pixels[row * 160..][..160]
            .iter()
            .map(depths)
            .collect();
        let [Plot::Svg(figure), _] = CrossSection::new(name, 3, &cut).draw().unwrap() else {
            panic!("an SVG was promised");
        };
        let mut bold_before = usize::MAX;
        for (number, layer) in frame.layers.iter().enumerate().take(3) {
            let (mut bold, mut hidden, mut peeled) = (0, 0, 0);
            for pixel in row * 160..(row + 1) * 160 {
                let depth = layer.depth[pixel];
                let list = &lists.pixels[pixel];
                // Light grey in the figure: every one lies before the layer.
                let before = list
                    .iter()
                    .filter(|fragment| fragment.depth < depth)
                    .count();
                assert_eq!(before, number.min(list.len()), "{name}, layer {number}");
                peeled += before;
                // Bold: the layer itself, one fragment.
                let at = list
                    .iter()
                    .filter(|fragment| fragment.depth == depth)
                    .count();
                assert_eq!(at, usize::from(list.len() > number));
                bold += at;
                // Thin: behind it.
                hidden += list.len() - before - at;
            }
            println!(
                "{name}, row {row}, layer {number}: {bold} bold, {hidden} thin, {peeled} grey"
            );
            // The drawn figure says the same.
            let drawn = format!("layer {number}: {bold} samples\n");
            assert!(figure.contains(&drawn), "no {drawn}: {figure}");
            // "The number of samples is decreasing"; a closed surface has as many in its first two layers.
            assert!(bold <= bold_before && bold > 0);
            assert_eq!(bold + hidden + peeled, fragments(&row));
            bold_before = bold;
        }
        let most = lists.samples(0);
        assert!(
            lists.samples(2) < most,
            "and over the whole image they do decrease"
        );
    }
}
