// The player: one pixel on which a listing runs, in the page. It finds its places by the class `player`. Each has a script of
// type application/json with the program in its readings, the scene, and the exercises. machine.js runs them.
"use strict";

(() => {
  const SVG = "http://www.w3.org/2000/svg";
  /** The depth axis: where depth 0 and depth 1 are, and the height of a row. */
  const [NEAR, FAR, ROW] = [70, 610, 30];
  const MOST_SURFACES = 16;
  const EXERCISES = onionskin.exercises;
  const GROUPS = { unsorted: "transparent", sorted: "transparent, sorted", opaque: "opaque" };

  /** An element with attributes, listeners (on...) and children.
   * @param {string} name @param {Object} [given] @param {...(Node|string)} children @returns {any} */
  const make = (name, given, ...children) => filled(document.createElement(name), given, children);
  const draw = (name, given, ...children) => filled(document.createElementNS(SVG, name), given, children);
  function filled(it, given, children) {
    put(it, given ?? {});
    it.append(...children);
    return it;
  }
  function put(it, given) {
    for (const [name, value] of Object.entries(given)) {
      if (name.startsWith("on")) it.addEventListener(name.slice(2), value);
      else if (value === true) it.setAttribute(name, "");
      else if (value !== false && value !== null && value !== undefined) it.setAttribute(name, value);
    }
  }
  const copy = (it) => JSON.parse(JSON.stringify(it));
  const short = (value) => (Number.isInteger(value) ? String(value) : Number.isFinite(value) ? String(Number(value.toFixed(4))) : "no limit");
  const clamp = (value) => Math.min(Math.max(value, 0), 1);

  const button = (text, label, act, given = {}) => make("button", { type: "button", "aria-label": label, title: label, onclick: act, ...given }, text);

  /** A premultiplied colour before white, with its numbers. */
  function swatch(color) {
    const shown = color.slice(0, 3).map((channel) => Math.round(255 * clamp(channel + 1 - clamp(color[3]))));
    const square = make("span", { class: "swatch", style: `background: rgb(${shown.join(" ")})` });
    return make("span", null, square, ` ${color.map((channel) => short(channel)).join(" ")}`);
  }
  const change = ([before, after]) => (before === after ? short(before) : `${short(before)} → ${short(after)}`);

  /** A table with a caption, from rows of texts or nodes. The first cell of a row is its heading. */
  function table(caption, columns, rows) {
    const cells = ([first, ...rest]) => [make("th", { scope: "row" }, first), ...rest.map((it) => make("td", null, it))];
    return make("div", { class: "scroll" }, make("table", null,
      make("caption", null, caption),
      make("thead", null, make("tr", null, ...columns.map((it) => make("th", { scope: "col" }, it)))),
      make("tbody", null, ...rows.map((row) => make("tr", null, ...cells(row))))));
  }

  class Player {
    constructor(root) {
      const { programs, scene } = JSON.parse(root.querySelector("script").textContent);
      Object.assign(this, { root, programs, scene });
      root.dataset.program = programs[0].key;
      root.player = this; // for the console
      this.solved = new Set();
      this.choose(programs.find((it) => it.readings.includes(scene.reading ?? "amended")) ?? programs[0]);
      this.reset();
      this.rerun();
      this.first = EXERCISES.first(this);
      this.frame();
      this.rebuild();
      root.addEventListener("keydown", (event) => this.key(event));
    }

    // ---- What is run ------------------------------------------------------------------------------------------------

    choose(program) {
      this.given = program;
      this.program = copy(program);
      this.changed = [];
      this.variables = { ...program.variables, ...this.scene.variables };
      this.array = this.scene.array ?? program.array;
      this.at = 0;
    }

    reset() {
      this.surfaces = copy(this.scene.surfaces).map((it, number) => ({ name: `s${number}`, ...it }));
      this.choose(this.given);
    }

    name(number) {
      return number === null ? "the screen" : this.surfaces[number].name;
    }
    names(numbers) {
      return numbers && numbers.length ? numbers.map((it) => this.name(it)).join(" ") : "–";
    }

    /** Runs everything again, and stays at the same moment. */
    rerun() {
      const { program, surfaces, variables, array } = this;
      this.run = onionskin.run(program, surfaces, { variables, array, limit: 4000 });
      this.at = Math.min(this.at, this.run.events.length);
    }

    /** The event whose outcome is shown, or null before the first. */
    get event() {
      return this.at > 0 ? this.run.events[this.at - 1] : null;
    }

    go(at) {
      this.at = Math.min(Math.max(at, 0), this.run.events.length);
      this.show();
    }

    /** To the next draw or walk through a list, or to the one before. */
    goPass(by) {
      const { events } = this.run;
      const ends = (at) => at === 0 || at === events.length || events[at - 1].fates || (events[at - 1].lists && events[at]?.pass !== events[at - 1].pass);
      let at = this.at + by;
      while (at > 0 && at < events.length && !ends(at)) at += by;
      this.go(at);
    }

    key(event) {
      const target = /** @type {HTMLElement} */ (event.target);
      if (event.ctrlKey || event.altKey || event.metaKey || target.closest("input, select, [role=slider]")) return;
      const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (by) event.shiftKey ? this.goPass(by) : this.go(this.at + by);
      else if (event.key === "Home") this.go(0);
      else if (event.key === "End") this.go(Infinity);
      else return;
      event.preventDefault();
    }

    // ---- What is on the page ----------------------------------------------------------------------------------------

    frame() {
      this.readings = this.programs.map((program) => button(program.readings.join(", "), null, () => { this.choose(program); this.rebuild(); }));
      this.slider = make("input", { type: "range", min: 0, "aria-label": "Call", oninput: () => this.go(Number(this.slider.value)) });
      this.where = make("output");
      this.listing = make("div", { class: "listing", tabindex: 0, role: "group", "aria-label": "The listing" });
      this.axis = draw("svg", { class: "axis", role: "group", "aria-label": "Surfaces by depth" });
      this.parts = { words: make("div"), edit: make("div"), now: make("div", { class: "now", "aria-live": "polite" }), end: make("div") };
      const tasks = [...this.root.querySelectorAll("[data-exercise]")];
      this.tasks = tasks.map((item) => ({ item, key: item.dataset.exercise, said: item.appendChild(make("strong", { class: "said" })) }));
      const stage = make("div", { class: "stage" },
        make("div", { class: "choices", role: "group", "aria-label": "Reading" }, ...this.readings, button("start again", "Undo all changes", () => { this.reset(); this.rebuild(); })),
        make("div", { class: "steps" },
          button("|◀", "Begin (Home)", () => this.go(0)),
          button("◀◀", "Pass back (Shift, left)", () => this.goPass(-1)),
          button("◀", "Call back (left)", () => this.go(this.at - 1)),
          button("▶", "Call on (right)", () => this.go(this.at + 1)),
          button("▶▶", "Pass on (Shift, right)", () => this.goPass(1)),
          button("▶|", "End (End)", () => this.go(Infinity)),
          this.slider, this.where),
        make("div", { class: "beside" }, make("div", null, this.listing, this.parts.words), make("div", null, make("div", { class: "scroll" }, this.axis), this.parts.now)),
        this.parts.end, make("details", { open: true }, make("summary", null, "Change the pixel"), this.parts.edit));
      stage.tabIndex = -1;
      this.root.querySelector(".keys").after(stage);
      this.root.querySelector("noscript")?.remove();
    }

    /** After surfaces came, went or changed places, or after another reading was chosen. */
    rebuild() {
      this.rerun();
      this.readings.forEach((it, at) => it.setAttribute("aria-pressed", String(this.programs[at] === this.given)));
      this.buildListing();
      this.buildAxis();
      this.buildEdit();
      this.show();
    }

    buildListing() {
      const row = ({ origin, note, text }, number) => {
        const { is = "", why, quote } = origin ?? {};
        return make("tr", { class: is + (note ? " note" : ""), title: why ?? quote, onclick: () => this.goLine(number) },
          make("td", null, is.slice(0, 1)), make("td", null, make("code", null, text)));
      };
      this.rows = this.given.lines.map(row);
      this.listing.replaceChildren(make("table", null, make("caption", { class: "hidden" }, this.given.title), make("tbody", null, ...this.rows)));
    }

    /** To the next moment at which a line is performed, or to its first one. */
    goLine(number) {
      const { events } = this.run;
      const find = (from) => events.findIndex((it, at) => at >= from && it.line === number) + 1;
      this.go(find(this.at) || find(0) || this.at);
    }

    buildAxis() {
      const height = ROW * this.surfaces.length + 44;
      put(this.axis, { viewBox: `0 0 680 ${height}` });
      const text = (x, y, it, given) => draw("text", { x, y, ...given }, it);
      this.handles = this.surfaces.map((surface, number) => {
        const y = ROW * number + 20;
        const mark = { opaque: "M-9 -9H9V9H-9Z", sorted: "M0 -11L11 0L0 11L-11 0Z" }[surface.group] ?? "M-10 0a10 10 0 1 0 20 0a10 10 0 1 0 -20 0";
        const [r, g, b] = surface.color.map((channel) => Math.round(255 * channel));
        const told = text(16, 5, "");
        const handle = draw("g", {
          tabindex: 0, role: "slider", "aria-label": `Depth of ${surface.name}`, "aria-valuemin": 0, "aria-valuemax": 1, class: "handle",
          onpointerdown: (event) => { handle.setPointerCapture(event.pointerId); handle.focus(); this.dragged = number; },
          onpointermove: (event) => { if (this.dragged === number) this.drag(number, event); },
          onpointerup: () => { this.dragged = null; },
          onkeydown: (event) => this.nudge(number, event),
        }, draw("rect", { x: -14, y: -14, width: 28, height: 28, fill: "transparent" }), draw("path", { d: mark, fill: `rgb(${r} ${g} ${b})`, "fill-opacity": Math.max(surface.color[3], 0.25), class: "mark" }), told);
        return { handle, told, y };
      });
      const lanes = this.handles.map(({ y }, number) => draw("g", { class: "lane" }, draw("path", { d: `M${NEAR} ${y}H${FAR}` }), text(8, y + 5, this.surfaces[number].name)));
      this.stored = draw("g", { class: "stored" });
      this.axis.replaceChildren(...lanes, this.stored,
        text(NEAR, height - 6, "depth 0, near"), text(FAR, height - 6, "1, far", { "text-anchor": "end" }), ...this.handles.map(({ handle }) => handle));
    }

    drag(number, event) {
      const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.axis.getScreenCTM().inverse());
      const depth = clamp((at.x - NEAR) / (FAR - NEAR));
      const near = this.surfaces.find((it, other) => other !== number && Math.abs(it.depth - depth) < 0.008);
      this.move(number, near?.depth ?? Math.round(depth * 1000) / 1000);
    }

    /** Arrow keys move a surface. With Shift it goes to where another one is. */
    nudge(number, event) {
      const by = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
      if (!by) return;
      event.preventDefault();
      const { depth } = this.surfaces[number];
      const others = this.surfaces.map((it) => it.depth).filter((it) => (it - depth) * by > 0).sort((a, b) => (a - b) * by);
      this.move(number, event.shiftKey ? others[0] ?? depth : clamp(Math.round((depth + 0.01 * by) * 1000) / 1000));
    }

    move(number, depth) {
      this.surfaces[number].depth = depth;
      this.rerun();
      this.show();
    }

    buildEdit() {
      const number = (value, label, act, given = {}) => make("input", { type: "number", value, "aria-label": label, onchange: (event) => act(event.target), ...given });
      const act = (text, label, does, given) => button(text, label, () => { does(); this.rebuild(); }, given);
      const row = (surface, at) => {
        const swap = (other) => () => { [this.surfaces[at], this.surfaces[other]] = [this.surfaces[other], this.surfaces[at]]; };
        const group = make("select", { "aria-label": `Kind of ${surface.name}`, onchange: ({ target }) => {
          surface.group = target.value;
          surface.color[3] = surface.group === "opaque" ? 1 : Math.min(surface.color[3], 0.5);
          this.rebuild();
        } },
          ...Object.entries(GROUPS).map(([key, text]) => make("option", { value: key, selected: key === surface.group }, text)));
        const depth = number(surface.depth, `Depth of ${surface.name}`, (it) => this.move(at, clamp(Number(it.value))), { min: 0, max: 1, step: 0.01, "data-depth": at });
        const alpha = number(surface.color[3], `Opacity of ${surface.name}`, (it) => { surface.color[3] = surface.group === "opaque" ? 1 : clamp(Number(it.value)); this.rebuild(); }, { min: 0, max: 1, step: 0.05 });
        return [surface.name, depth, alpha, group, make("span", {},
          act("↑", `Submit ${surface.name} earlier`, swap(at - 1), { disabled: at === 0 }),
          act("↓", `Submit ${surface.name} later`, swap(at + 1), { disabled: at === this.surfaces.length - 1 }),
          act("×", `Remove ${surface.name}`, () => this.surfaces.splice(at, 1), { disabled: this.surfaces.length === 1 }))];
      };
      const adds = act("add a surface", "Add a surface", () => this.add(), { disabled: this.surfaces.length >= MOST_SURFACES });
      const reverses = act("reverse the order", "Submit in opposite order", () => this.surfaces.reverse());
      const variables = Object.entries(this.variables).map(([name, value]) => make("label", null, `${name} `,
        number(value ?? "", `${name}, empty is no limit`, (it) => { this.variables[name] = it.value === "" ? null : Number(it.value); this.rebuild(); }, { min: 0, step: "any" })));
      if (this.array) variables.push(make("label", null, "Local Array ", number(this.array, "Elements of the Local Array", (it) => { this.array = Math.min(Math.max(Math.round(Number(it.value)), 1), 64); this.rebuild(); }, { min: 1, max: 64 })));
      this.parts.edit.replaceChildren(
        table("In the order of submission", ["surface", "depth", "opacity", "kind", "order"], this.surfaces.map(row)),
        make("p", { class: "choices" }, adds, reverses, ...variables));
    }

    add() {
      let number = 0;
      while (this.surfaces.some(({ name }) => name === `s${number}`)) number += 1;
      const group = this.surfaces[0].group === "sorted" ? "sorted" : "unsorted";
      this.surfaces.push({ name: `s${number}`, depth: 0.5, color: [0.9, 0.6, 0, 0.5], group });
    }

    // ---- What is shown at a moment ----------------------------------------------------------------------------------

    show() {
      const { run, event } = this;
      put(this.slider, { max: run.events.length });
      this.slider.value = this.at;
      this.where.textContent = `${this.at} of ${run.events.length}`;
      this.rows.forEach((row, number) => row.classList.toggle("current", event?.line === number));
      this.follow();
      this.showAxis();
      this.parts.words.replaceChildren(...this.wordsOf());
      this.parts.now.replaceChildren(...this.stateOf());
      this.parts.end.replaceChildren(...this.endOf());
      this.look();
    }

    /** Keeps the current line in sight, without moving the page. */
    follow() {
      const row = this.event && this.rows[this.event.line];
      if (!row) return;
      const [box, line] = [this.listing.getBoundingClientRect(), row.getBoundingClientRect()];
      if (line.top < box.top || line.bottom > box.bottom) this.listing.scrollTop += line.top - box.top - box.height / 2;
    }

    showAxis() {
      const fates = this.lastFates();
      const x = (depth) => NEAR + depth * (FAR - NEAR);
      this.handles.forEach(({ handle, told, y }, number) => {
        const { depth } = this.surfaces[number];
        const outcomes = fates.filter((it) => it.surface === number).map((it) => it.outcome);
        put(handle, { transform: `translate(${x(depth)} ${y})`, "aria-valuenow": depth, "aria-valuetext": `${short(depth)} ${outcomes.join(", ")}`, "data-outcome": outcomes.at(-1) ?? "" });
        told.textContent = outcomes.at(-1) ?? "";
        put(told, depth > 0.8 ? { x: -16, "text-anchor": "end" } : { x: 16, "text-anchor": "start" });
        const input = this.parts.edit.querySelector(`[data-depth="${number}"]`);
        if (input && document.activeElement !== input) input.value = depth;
      });
      const maps = Object.entries(this.event?.maps ?? {}).filter(([, it]) => it.depth !== undefined);
      this.stored.replaceChildren(...maps.map(([name, it]) => draw("path", { d: `M${x(it.depth)} 4v${ROW * this.surfaces.length + 4}` }, draw("title", {}, `${name}: ${short(it.depth)}`))));
    }

    /** The fates of the last draw up to now. */
    lastFates() {
      for (let at = this.at - 1; at >= 0; at -= 1) if (this.run.events[at].fates) return this.run.events[at].fates;
      return [];
    }

    /** The words of the current call that may be changed, and those that were. */
    wordsOf() {
      const { event } = this;
      const step = event && this.stepAt(event.path);
      const choices = Object.keys(step?.arguments ?? {}).map((argument) => [argument, onionskin.words(step.name, argument)]);
      const selects = choices.filter(([, words]) => words.length).map(([argument, words]) => make("label", null, `${argument} `,
        make("select", { onchange: (it) => this.change(event.path, argument, it.target.value) },
          ...words.map((word) => make("option", { selected: word === step.arguments[argument] }, word)))));
      const told = this.changed.map(({ path, argument, was }) => {
        const now = this.stepAt(path);
        return make("li", null, make("code", null, `${now.name}, ${argument}: ${was} → ${now.arguments[argument]} `),
          button("undo", `Undo ${argument}`, () => this.change(path, argument, was)));
      });
      const call = event?.call && `${event.call.name}(${Object.entries(event.call.arguments).map(([name, value]) => `${name}: ${value}`).join(", ")})`;
      const line = event && (this.given.lines[event.line]?.text.trim() ?? event.kind);
      const held = event && "holds" in event ? (event.holds ? "  (yes)" : "  (no)") : "";
      return [
        make("p", null, make("code", null, (call || line || "") + held)),
        make("p", { class: "words" }, selects.length ? "Change a word: " : "", ...selects),
        make("ul", { class: "changed" }, ...told),
      ];
    }

    stepAt(path) {
      return path.split("/").slice(1).reduce((it, part) => it[part], this.program);
    }

    change(path, argument, word) {
      const step = this.stepAt(path);
      const before = this.changed.find((it) => it.path === path && it.argument === argument);
      if (!before) this.changed.push({ path, argument, was: step.arguments[argument] });
      step.arguments[argument] = word;
      if (before?.was === word) this.changed = this.changed.filter((it) => it !== before);
      this.rerun();
      this.show();
    }

    stateOf() {
      const { event } = this;
      if (!event) return ["Nothing has been done yet."];
      const shown = [];
      if (this.at - 1 === this.run.parts) shown.push(make("p", { class: "bad" }, "Here they part."));
      if (event.fates) {
        shown.push(table("This draw, fragment by fragment", ["fragment", "ended", "stencil", "stored depth"],
          event.fates.map((it) => [this.name(it.surface), it.outcome, change(it.stencil), change(it.stored_depth)])));
      }
      if (event.lists) shown.push(...this.listsOf(event.lists));
      const maps = Object.entries(event.maps);
      const value = (it) => (it.depth !== undefined ? `depth ${short(it.depth)}, stencil ${it.stencil}` : it.color ? swatch(it.color) : (it.integers ?? []).join(" "));
      const from = ({ how, from }) => (!how || how === "data" ? "" : from ? this.names(from) : "mixed");
      if (maps.length) shown.push(table("The pixel of each map", ["map", "holds", "made of"], maps.map(([name, it]) => [name, value(it), from(it)])));
      const numbers = [...Object.entries(event.samples).map(([name, it]) => [`samples of ${name}`, String(it)]), ...Object.entries(event.variables).map(([name, it]) => [name, short(it)])];
      if (numbers.length) shown.push(table("Numbers", ["name", "value"], numbers));
      return shown;
    }

    listsOf(lists) {
      const rows = lists.passes.map((it, at) => [String(at + 1), ...["skipped", "dropped", "array", "composited"].map((of) => this.names(it[of]))]);
      return [
        table("The pixel's list, and the Local Array", ["what", "holds"], [
          ["the list", this.names(lists.list)], ["the array", lists.buffer ? this.names(lists.buffer) : "–"],
          ["min depth, id", lists.min ? lists.min.map(short).join(", ") : "–"], ["composited", this.names(lists.composited)]]),
        ...(rows.length ? [table("Walks", ["walk", "skipped", "dropped", "in the array", "composited"], rows)] : []),
      ];
    }

    endOf() {
      const { run } = this;
      const jump = run.parts === null ? "" : button(`They part at ${run.parts + 1}`, "Go there", () => this.go(run.parts + 1));
      const agree = run.parts === null ? make("strong", { class: "good" }, "The image is exact.") : make("strong", { class: "bad" }, "The image is not exact. ");
      return [
        table("At the end of the run", ["image", "colour", "composited, nearest first"], [
          [this.given.method, swatch(run.image), this.names(run.composited)], ["exact", swatch(run.exact.color), this.names(run.exact.order)]]),
        make("p", null, agree, jump, run.stopped ? ` The loop ended: ${run.stopped}.` : ""),
        make("p", { class: "bad" }, run.error ? `The run cannot go on after ${run.error.event}: ${run.error.what}.` : ""),
      ];
    }

    // ---- Exercises --------------------------------------------------------------------------------------------------

    look() {
      for (const { key, item, said } of this.tasks) {
        if (!this.solved.has(key) && EXERCISES[key]?.(this)) this.solved.add(key);
        item.classList.toggle("solved", this.solved.has(key));
        const text = this.solved.has(key) ? ` Solved. ${item.dataset.solved ?? ""}` : "";
        if (said.textContent !== text) said.textContent = text;
      }
    }
  }

  document.querySelectorAll(".player").forEach((root) => new Player(root));
})();
