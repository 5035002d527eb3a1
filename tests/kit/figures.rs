//! The figures that claims print, held against what is counted, so that a row does not go stale.

use onionskin::low_level::papers::papers;

/// Holds the figures of a claim, the `number`-th of its row. A hundredth is allowed, or half of the last digit that is
/// printed: another driver may round a fragment over an edge.
#[track_caller]
pub fn expect_figures(key: &str, number: usize, counted: &[f64]) {
    let mut claims = papers().iter().flat_map(|paper| paper.claims);
    let claim = claims.find(|claim| claim.key == key).expect(key);
    let figure = &claim.figures[number];
    if let Err(why) = compare(figure.here, counted) {
        panic!("{key}, {}: {why}", figure.of);
    }
}

/// Numbers with commas between them, each perhaps with a percent sign.
fn compare(printed: &str, counted: &[f64]) -> Result<(), String> {
    let numbers: Vec<&str> = printed
        .split(", ")
        .map(|it| it.trim_end_matches('%'))
        .collect();
    let close = |(printed, counted): (&&str, &f64)| {
        let number: f64 = printed.parse().expect("a number");
        let digits = printed
            .split_once('.')
            .map_or(0, |(_, digits)| digits.len());
        let last = 0.5 * 0.1_f64.powi(digits as i32);
        (number - counted).abs() <= last.max(number / 100.0)
    };
    let holds = numbers.len() == counted.len() && numbers.iter().zip(counted).all(close);
    holds
        .then_some(())
        .ok_or_else(|| format!("the row says {printed}, and here are {counted:?}"))
}

#[test]
fn a_stale_figure_would_be_noticed() {
    assert_eq!(compare("100%, 1.11, 300", &[99.6, 1.114, 302.0]), Ok(()));
    for counted in [
        &[99.6, 1.114, 304.0][..],
        &[98.0, 1.11, 300.0],
        &[100.0, 1.11],
    ] {
        assert!(compare("100%, 1.11, 300", counted).is_err(), "{counted:?}");
    }
}
