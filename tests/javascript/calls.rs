//! Every program that is a listing but for coherent layer peeling, whose loops take longest.

use onionskin::low_level::edition::program_json::object;
use onionskin::low_level::edition::programs;
use onionskin::low_level::steps::Reading;
use serde_json::json;

use crate::cases;
use crate::chance::Chance;
use crate::compare::{case, emulate, variables};
use crate::node::Node;

#[test]
fn every_listing_does_call_by_call_what_the_emulated_pixel_does() {
    crate::compare::check(|key| !key.starts_with("carr/coherent"));
}

#[test]
fn another_order_of_drawing_is_drawn_as_on_the_emulated_pixel() {
    let Some(mut node) = Node::start() else {
        return;
    };
    let mut chance = Chance::new(3);
    for key in ["edition/verified-painter", "carr/hybrid", "vtk/on-the-fly"] {
        let program = programs::all().iter().find(|it| it.key == key).unwrap();
        node.run(&object(program, &[Reading::Amended]));
        for pixel in &cases::random_pixels(4, 300) {
            let numbers = chance.shuffled(pixel.len()).into_iter();
            let order: Vec<_> = numbers.map(|number| number as u32).collect();
            let mut asked = case(pixel, variables(program, pixel));
            asked["options"]["order"] = json!(order);
            let theirs = node.answer_to(&json!({ "cases": [asked], "detail": true }));
            let ours = emulate(program, Reading::Amended, pixel, Some(&order), true);
            assert_eq!(
                theirs[0],
                json!(ours.said),
                "{key}: {pixel:#?} drawn as {order:?}"
            );
        }
    }
}
