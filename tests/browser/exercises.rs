//! How the exercises are solved: what a reader does in the boxes below the listing.

/// What a reader can do, as functions of a player's element.
const ACTS: &str = r#"
const change = (it, value) => { it.value = value; it.dispatchEvent(new Event("change")); };
const labelled = (label) => player.querySelector(`[aria-label="${label}"]`);
const depth = (name, value) => change(player.querySelector(`input[aria-label="Depth of ${name}"]`), value);
const kind = (name, value) => change(labelled(`Kind of ${name}`), value);
const earlier = (name) => labelled(`Submit ${name} earlier`).click();
const button = (text) => [...player.querySelectorAll("button")].find((it) => it.textContent === text).click();
const reading = (name) => [...player.querySelectorAll(".choices button")].find((it) => it.textContent.split(", ").includes(name)).click();
const number = (label, value) => change([...player.querySelectorAll("input[type=number]")].find((it) => it.getAttribute("aria-label").startsWith(label)), value);
const range = player.querySelector("input[type=range]");
const go = (at) => { range.value = at; range.dispatchEvent(new Event("input")); };
const all = () => Number(range.max);
const until = (isThere) => { for (let at = 1; at <= all(); at += 1) { go(at); if (isThere()) return; } throw new Error("never"); };
const solved = () => item.classList.contains("solved");
const select = (argument) => [...player.querySelectorAll(".words label")].find((it) => it.textContent.split(" ")[0] === argument)?.querySelector("select");
// The first call that has the word, and that solves the exercise if it has another.
const word = (argument, before, after) => until(() => {
  if (select(argument)?.value !== before) return false;
  change(select(argument), after);
  if (!solved()) change(select(argument), before);
  return solved();
});
"#;

/// The script that does it.
pub(crate) fn act(key: &str, solution: &str) -> String {
    format!(
        "(() => {{ const item = document.querySelector('[data-exercise=\"{key}\"]'); const player = item.closest('.player'); {ACTS} {solution} return ''; }})()"
    )
}

/// What solves an exercise. Some follow from the one before.
pub(crate) fn solution(key: &str) -> Option<&'static str> {
    Some(match key {
        "everitt-third-layer" => "until(solved);",
        "everitt-tie" => "depth('s1', 0.3);",
        "everitt-less" => "button('start again'); word('func', 'GL_LESS', 'GL_ALWAYS');",
        "vtk-peels" => "number('num_passes', 2);",
        "vtk-cull" => "button('start again'); depth('wall', 0.5);",
        "vtk-under" => "button('start again'); word('srcRGB', 'GL_ONE_MINUS_DST_ALPHA', 'GL_ONE');",
        "dual-middle" => "button('add a surface');",
        "dual-tie" => "depth('s1', 0.6);",
        "proof-fails" => "earlier('s2');",
        "proof-holds-again" => "depth('s1', 0.1);",
        "tie-with-a-peel" => "reading('as-printed'); depth('s0', 0.3);",
        "opaque-ends-early" => "button('start again'); kind('s0', 'opaque');",
        "pass-3-inverts" => "depth('s5', 0.46);",
        "s9-before-s3" => "depth('s9', 0.1);",
        "longer-run" => "button('start again'); depth('s10', 0.71);",
        "two-are-right" => {
            "reading('as-printed'); for (const name of ['s3', 's4', 's5', 's6', 's7', 's8', 's9', 's10']) labelled(`Remove ${name}`).click();"
        }
        "three-are-wrong" => {
            "for (let more = 0; more < 5 && !solved(); more += 1) { button('add a surface'); const last = player.querySelectorAll('[data-depth]').length - 1; change(player.querySelector(`[data-depth='${last}']`), 0.3 - 0.05 * more); }"
        }
        "reversed" => "button('reverse the order');",
        "printed-again" => "reading('as-printed');",
        "drop-what-pp-dp-keeps" => "button('add a surface'); button('add a surface');",
        "past-the-last-segment" => "reading('as-printed');",
        "lose-a-tie" => "reading('as-printed'); depth('s4', 0.5);",
        "save-the-tie" => "number('Elements of the Local Array', 4);",
        "at-depth-0" => "button('start again'); depth('s1', 0);",
        _ => return None,
    })
}
