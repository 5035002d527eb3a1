//! The data of a player: a program in its readings, the pixel that it begins with, and the exercises.

use serde_json::{Value, json};

use super::super::{program_json, programs};

/// The pixels and the exercises, by their names in templates.
const EXERCISES: &str = include_str!("../web/exercises.json");

fn book() -> Value {
    serde_json::from_str(EXERCISES).expect("exercises.json is JSON")
}

/// What the page has of a player, or the name that leads nowhere.
pub(super) fn data(program: &str, scene: &str, exercises: &[String]) -> Result<Value, String> {
    let book = book();
    let known = programs::all().iter().find(|it| it.key == program);
    let known = known.ok_or(program)?;
    let readings = known.readings();
    let programs = readings.iter().map(|it| program_json::object(known, it));
    let programs: Vec<_> = programs.collect();
    let scene = book["scenes"].get(scene).ok_or(scene)?;
    let exercise = |key: &String| {
        let it = book["exercises"].get(key).ok_or(key)?;
        Ok(json!({ "key": key, "task": it["task"], "solved": it["solved"] }))
    };
    let exercises: Result<Vec<_>, String> = exercises.iter().map(exercise).collect();
    let run = json!({ "programs": programs, "scene": scene });
    Ok(json!({
        "says": scene["says"],
        "title": programs[0]["title"],
        "source": programs[0]["source"],
        "exercises": exercises?,
        // Inside of a script nothing but the end of the script is markup.
        "run": run.to_string().replace('<', "\\u003c"),
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_leads_nowhere_is_said() {
        let of = |program, scene, exercise: &str| data(program, scene, &[exercise.to_owned()]);
        assert!(of("vtk/on-the-fly", "vtk-panes", "vtk-peels").is_ok());
        assert_eq!(of("vtk", "vtk-panes", "vtk-peels"), Err("vtk".into()));
        assert_eq!(
            of("vtk/on-the-fly", "pain", "vtk-peels"),
            Err("pain".into())
        );
        assert_eq!(of("vtk/on-the-fly", "vtk-panes", "x"), Err("x".into()));
    }

    /// Every exercise has a rule, and every rule an exercise.
    #[test]
    fn every_exercise_can_be_solved_by_a_rule_of_the_script() {
        let rules = include_str!("../web/exercises.js").lines();
        let rules = rules.filter_map(|line| line.trim().strip_prefix('"'));
        let mut rules: Vec<_> = rules.filter_map(|line| line.split_once("\": ")).collect();
        rules.sort_unstable();
        let rules: Vec<_> = rules.into_iter().map(|(name, _)| name).collect();
        let book = book();
        let exercises = book["exercises"].as_object().unwrap();
        let mut keys: Vec<_> = exercises.keys().cloned().collect();
        keys.sort_unstable();
        assert_eq!(rules, keys);
    }
}
