//! Rounds, in each of which everyone who takes part draws one frame. So a machine that is busy for a while is busy for all
//! of them, and their ratios stay what they are.

use onionskin::low_level::scene::CameraPath;
use onionskin::{Camera, Error, Result};

/// Who takes part: draws a frame as this camera sees it, and says how many milliseconds it took.
pub(super) type Runner<'r> = Box<dyn FnMut(Camera) -> Result<f64> + 'r>;

/// How long to go on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plan {
    /// The rounds before any time counts. Drivers optimise a shader when it is first used, and pages of memory are given
    /// when they are first written.
    pub(super) warm_up: u32,
    /// After so many milliseconds of its own, a runner is warm.
    pub(super) warm_after: f64,
    /// The rounds that count.
    pub(super) rounds: u32,
    /// After so many milliseconds of its own, a runner takes no part in further rounds. It has had one that counts.
    pub(super) budget: f64,
}

/// The views of a round: the eye goes on around the target by a quarter of a degree, so that nothing that depends on the
/// view can be kept from the frame before.
const ORBIT: CameraPath = CameraPath {
    frames: 1440,
    rotate: 360.0,
    dolly: 1.0,
    dolly_frames: 2,
};

/// The times of each runner. `warmed` has the milliseconds of frames that they have drawn before. A runner that fails takes
/// no part any more, and its error is the answer.
pub(super) fn run(
    runners: &mut [Runner<'_>],
    camera: &Camera,
    plan: Plan,
    warmed: &[f64],
    mut frame_done: impl FnMut(),
) -> Vec<Result<Vec<f64>>> {
    let count = runners.len();
    let mut times: Vec<Result<Vec<f64>, Error>> = (0..count).map(|_| Ok(Vec::new())).collect();
    let mut spent = warmed.to_vec();
    let mut most = plan.warm_after;
    for round in 0..plan.warm_up + plan.rounds {
        if round == plan.warm_up {
            spent.fill(0.0);
            most = plan.budget;
        }
        let seen = Camera {
            eye: ORBIT.eye(camera, round),
            ..*camera
        };
        // Everyone is once after everyone else's caches, not always the same one.
        for turn in 0..count {
            let number = (turn + round as usize) % count;
            if let Ok(own) = &mut times[number]
                && spent[number] <= most
            {
                match runners[number](seen) {
                    Ok(ms) => {
                        spent[number] += ms;
                        if round >= plan.warm_up {
                            own.push(ms);
                        }
                    }
                    Err(error) => times[number] = Err(error),
                }
            }
            frame_done();
        }
    }
    times
}

#[cfg(test)]
mod tests {
    use std::cell::RefCell;

    use super::*;

    const PLAN: Plan = Plan {
        warm_up: 2,
        warm_after: 50.0,
        rounds: 3,
        budget: 100.0,
    };

    fn camera() -> Camera {
        Camera::looking([0.0, 0.0, 3.0].into(), [0.0; 3].into())
    }

    #[test]
    fn everyone_draws_once_in_each_round_and_the_first_rounds_do_not_count() {
        let seen = RefCell::new(Vec::new());
        let runner = |name: char| -> Runner<'_> {
            let seen = &seen;
            Box::new(move |camera| {
                seen.borrow_mut().push((name, camera.eye));
                Ok(if name == 'a' { 1.0 } else { 2.0 })
            })
        };
        let times = run(
            &mut [runner('a'), runner('b')],
            &camera(),
            PLAN,
            &[0.0, 0.0],
            || {},
        );
        let times: Vec<_> = times.into_iter().map(Result::unwrap).collect();
        assert_eq!(times, [vec![1.0; 3], vec![2.0; 3]]);
        let seen = seen.into_inner();
        let names: String = seen.iter().map(|(name, _)| name).collect();
        assert_eq!(names, "abbaabbaab", "each round begins with the next one");
        // Both see the same in a round, and something else in the next.
        for round in seen.chunks(2) {
            assert_eq!(round[0].1, round[1].1);
        }
        assert_ne!(seen[0].1, seen[2].1);
    }

    #[test]
    fn who_has_drawn_for_long_is_warm() {
        let frames = RefCell::new(0);
        let runner: Runner<'_> = Box::new(|_| {
            *frames.borrow_mut() += 1;
            Ok(20.0)
        });
        let times = run(&mut [runner], &camera(), PLAN, &[40.0], || {});
        assert_eq!(times[0].as_ref().unwrap().len(), 3);
        assert_eq!(*frames.borrow(), 1 + 3);
    }

    #[test]
    fn who_is_slow_has_fewer_frames_and_who_fails_has_none() {
        let slow: Runner<'_> = Box::new(|_| Ok(60.0));
        let mut left = 3;
        let failing: Runner<'_> = Box::new(move |_| {
            left -= 1;
            assert!(left >= 0, "asked again after its error");
            match left {
                0 => Err(Error::usage("no", "none")),
                _ => Ok(1.0),
            }
        });
        let quick: Runner<'_> = Box::new(|_| Ok(1.0));
        let times = run(
            &mut [slow, failing, quick],
            &camera(),
            PLAN,
            &[0.0; 3],
            || {},
        );
        assert_eq!(times[0].as_ref().unwrap().len(), 2);
        assert!(times[1].is_err());
        assert_eq!(times[2].as_ref().unwrap().len(), 3);
    }
}
