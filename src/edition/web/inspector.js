"use strict";
// Steps through the passes of a pixel's history. Without this script the page shows all of them.
(() => {
  /** @type {{by_distance: boolean, passes: {events: {fragment: number, outcome: string}[], held: {depth: number|null}, over_screen: boolean}[]}} */
  const history = JSON.parse(document.getElementById("history").textContent);
  const panels = document.getElementById("panels");
  const articles = [...panels.querySelectorAll("article")];
  const buttons = [...document.querySelectorAll("#steps button")];
  const drawing = document.querySelector("#axis svg");
  const stored = drawing.querySelector(".stored");
  const places = JSON.parse(drawing.dataset.places);
  const STAGES = ["pass", "fail", "clipped"];
  let current = 0;

  /** The stage's class of an outcome. */
  const stage = (outcome) => (outcome === "pass" ? "pass" : outcome === "clipped" ? "clipped" : "fail");

  /** Marks on the axis what the pass did to each fragment, and the depth that it left. */
  function mark(pass) {
    for (const fragment of drawing.querySelectorAll(".fragment")) {
      fragment.classList.remove(...STAGES);
      const number = Number(fragment.dataset.fragment);
      const event = pass.events.find((it) => it.fragment === number);
      if (event) fragment.classList.add(stage(event.outcome));
    }
    const depth = pass.held.depth;
    stored.style.visibility = depth === null ? "hidden" : "visible";
    if (depth === null) return;
    const deeper = Object.entries(places).filter(([other]) => Number(other) <= depth).map(([, place]) => place);
    const place = Math.max(0, ...deeper);
    const end = Number(drawing.dataset.end) - 3;
    const x = depth >= 1 && !history.by_distance ? end : place;
    stored.setAttribute("x1", x);
    stored.setAttribute("x2", x);
  }

  function show(number) {
    current = Math.min(Math.max(number, 0), articles.length - 1);
    articles.forEach((article, at) => article.classList.toggle("current", at === current));
    buttons.forEach((button, at) => {
      if (at === current) button.setAttribute("aria-current", "step");
      else button.removeAttribute("aria-current");
    });
    buttons[current].scrollIntoView({ block: "nearest" });
    mark(history.passes[current]);
  }

  const KEYS = {
    ArrowRight: () => show(current + 1),
    ArrowLeft: () => show(current - 1),
    Home: () => show(0),
    End: () => show(articles.length - 1),
    a: () => panels.classList.toggle("stepping"),
  };
  document.addEventListener("keydown", (event) => {
    const step = KEYS[event.key];
    if (!step || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    step();
  });
  document.getElementById("back").addEventListener("click", KEYS.ArrowLeft);
  document.getElementById("forward").addEventListener("click", KEYS.ArrowRight);
  buttons.forEach((button, at) => button.addEventListener("click", () => show(at)));
  panels.classList.add("stepping");
  show(0);
})();
