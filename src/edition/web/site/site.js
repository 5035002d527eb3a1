// What the pages do besides being read: light or dark, pictures to flip through, readings of listings, a plot's readout.
// Without this script everything is shown one below the other.
"use strict";

/** A row of buttons of which one is pressed. The arrow keys go on to the next, and a digit goes to its button.
 * @param {string[]} labels @param {(chosen: number) => void} show @returns {HTMLElement} */
function choices(labels, show) {
  const row = document.createElement("div");
  row.className = "choices";
  row.setAttribute("role", "group");
  const buttons = labels.map((label, number) => {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = label;
    button.addEventListener("click", () => choose(number));
    row.append(button);
    return button;
  });
  const choose = (number) => {
    buttons.forEach((it, other) => it.setAttribute("aria-pressed", String(other === number)));
    show(number);
  };
  row.addEventListener("keydown", (event) => {
    const now = buttons.indexOf(/** @type {HTMLButtonElement} */ (document.activeElement));
    const steps = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };
    let next = Number(event.key) - 1;
    if (steps[event.key]) next = (now + steps[event.key] + buttons.length) % buttons.length;
    if (!buttons[next] || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    buttons[next].focus();
    choose(next);
  });
  choose(0);
  return row;
}

for (const flip of document.querySelectorAll(".flip")) {
  const pictures = [...flip.querySelectorAll(".picture")];
  const labels = pictures.map((it) => it.querySelector("figcaption").textContent);
  pictures.forEach((it) => it.querySelector("img").removeAttribute("loading"));
  flip.classList.add("flipping");
  const row = choices(labels, (chosen) => pictures.forEach((it, at) => it.classList.toggle("shown", at === chosen)));
  row.setAttribute("aria-label", "Which picture");
  row.title = "Arrow keys or digits flip";
  flip.before(row);
}

for (const listing of document.querySelectorAll(".listing")) {
  const readings = /** @type {HTMLElement[]} */ ([...listing.querySelectorAll(".reading")]);
  if (readings.length < 2) continue;
  const row = choices(readings.map((it) => it.dataset.reading), (chosen) => readings.forEach((it, at) => { it.hidden = at !== chosen; }));
  row.setAttribute("aria-label", "Which reading");
  readings[0].before(row);
}

for (const chart of document.querySelectorAll(".chart")) {
  const svg = chart.querySelector(":scope > svg");
  const cursor = svg.querySelector(".cursor");
  const output = chart.querySelector("output");
  const points = [...svg.querySelectorAll(".point")].map((it) => ({
    x: Number(it.dataset.x), y: Number(it.dataset.y), across: it.dataset.across, up: it.dataset.up,
    label: it.parentElement.dataset.label,
  }));
  svg.addEventListener("pointermove", (event) => {
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    const distance = (it) => Math.hypot(it.x - at.x, it.y - at.y);
    const nearest = points.reduce((a, b) => (distance(b) < distance(a) ? b : a), points[0]);
    if (!nearest) return;
    const height = svg.viewBox.baseVal.height;
    cursor.setAttribute("d", `M${nearest.x} 0V${height}M0 ${nearest.y}H${svg.viewBox.baseVal.width}`);
    output.textContent = `${nearest.label}: ${nearest.up} at ${nearest.across}`;
  });
}

const theme = document.getElementById("theme");
theme.hidden = false;
theme.addEventListener("click", () => {
  const root = document.documentElement;
  const dark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  root.dataset.theme = dark ? "light" : "dark";
  try { localStorage.theme = root.dataset.theme; } catch (e) { /* a page read from a file may have no storage */ }
});
