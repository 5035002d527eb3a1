// Runs programs by web/machine.js, as the test beside it asks: JSON objects by lines in, JSON values by lines out.
//
// {"machine": path}            loads the machine
// {"page": path}               loads it as a page does, where there are no modules, and answers with its names
// {"program": object}          is the program from now on
// {"words": [[call, argument]...]}  what may stand there
// {"cases": [...], "detail"}   runs it on each case, and answers with a digest of each, or with every moment in words
//
// {"runs": [...], "detail"}    runs pseudocode on each case, and answers with what is left of each at its end and a digest of
//                              every line that is executed, or every line in words
//
// A case is {"surfaces": [[depth, r, g, b, a, group]...], "options": {...}}.
"use strict";

const lines = require("readline").createInterface({ input: process.stdin });
const floats = new Float32Array(1);
const bits = new Uint32Array(floats.buffer);

/** The bits of a 32-bit float. There is one zero. */
function float(value) {
  floats[0] = value + 0;
  return bits[0];
}

/** Two sums over 32-bit words, by which runs are told apart. */
class Digest {
  constructor() {
    this.a = 0x811c9dc5 | 0;
    this.b = 0x9e3779b9 | 0;
    this.words = null;
  }

  add(word) {
    this.a = Math.imul(this.a ^ word, 0x01000193);
    this.b = Math.imul((this.b + word) | 0, 0x85ebca6b) ^ (this.b >>> 13);
    if (this.words) this.words.push(word >>> 0);
  }

  text(text) {
    for (const letter of text) this.add(letter.codePointAt(0));
  }

  value() {
    return [this.a >>> 0, this.b >>> 0];
  }
}

function texel(digest, { color, integers, depth, stencil }) {
  if (color) for (const channel of color) digest.add(float(channel));
  if (integers) for (const channel of integers) digest.add(channel);
  if (depth !== undefined) {
    digest.add(float(depth));
    digest.add(stencil);
  }
}

const OUTCOMES = { discarded: 0, "depth unit 0": 0, stencil: 1, depth: 2, pass: 3 };

function fate(digest, it) {
  digest.add(it.surface);
  digest.add(OUTCOMES[it.outcome]);
  for (const value of it.stencil) digest.add(value);
  for (const value of it.stored_depth) digest.add(float(value));
  for (const pair of it.colors) for (const channels of pair) for (const channel of channels) digest.add(float(channel));
}

const CHANGES = /^(draw|glClear$|glClearBuffer|glCopyImageSubData|swap)/;

function call(digest, { call, maps, fates, samples }) {
  const { name } = call;
  digest.add(1);
  if (CHANGES.test(name)) for (const map of Object.keys(maps).sort()) texel(digest, maps[map]);
  if (fates && name !== "drawScreen") for (const it of fates) fate(digest, it);
  if (name === "glEndQuery") digest.add(samples[call.arguments.id]);
}

/** A listing's run, call by call, and what is left at the end. */
function listing(digest, run, said) {
  for (const event of run.events) {
    if (event.kind !== "call") continue;
    if (said) digest.words = [];
    call(digest, event);
    if (said) {
      const named = Object.entries(event.call.arguments).map(([name, value]) => `${name} = ${value}`);
      said.push(`${event.call.name}(${named.sort().join(", ")}): ${digest.words.join(" ")}`);
    }
  }
}

/** A line of pseudocode on fragments, and the pixel's variables but for those that limit the run. */
function line(digest, { variables, composited }, limits) {
  for (const name of Object.keys(variables).sort()) {
    if (name in limits) continue;
    digest.text(name);
    digest.add(float(variables[name]));
  }
  digest.add(composited ? composited.length : 0);
}

/** A line of pseudocode on lists, and what the pixel holds. Every id is the largest word, and none yet the one before. */
function listLine(digest, { size, lists }) {
  const { buffer, min, complexity, stencil, marked, composited, times, records_read, slots } = lists;
  const id = (number) => (number === Infinity ? -1 : number < 0 ? -2 : number);
  digest.add(size);
  if (buffer) for (const number of buffer) digest.add(number);
  if (min) {
    digest.add(float(min[0]));
    digest.add(id(min[1]));
  }
  for (const word of [complexity, stencil, marked ? 1 : 0, composited.length, times, records_read, ...slots]) digest.add(word);
}

/** The words of the line at a path of the program, and two sums over them. */
function lineAt(program, path) {
  program.known ??= new Map();
  if (!program.known.has(path)) {
    const { text } = path.slice(1).split("/").reduce((inside, name) => inside[name], program);
    const digest = new Digest();
    digest.text(text);
    program.known.set(path, { text, sums: digest.value() });
  }
  return program.known.get(path);
}

/** A run of pseudocode, line by line. The lines that only composite say what: so it is enough to count that. */
function pseudocode(program, digest, run, limits, said) {
  let composited = [];
  for (const event of run.events) {
    composited = event.composited ?? composited;
    const { text, sums } = lineAt(program, event.path);
    if (said) digest.words = [];
    sums.forEach((word) => digest.add(word));
    digest.add(event.surface ?? 99);
    digest.add(event.holds === undefined ? 2 : event.holds ? 1 : 0);
    if (program.on === "fragments") line(digest, { ...event, composited }, limits);
    else listLine(digest, event);
    if (said) said.push(`${text}: ${digest.words.join(" ")}`);
  }
}

function end(digest, run, said) {
  if (said) digest.words = [];
  digest.text(run.stopped ?? "");
  for (const channel of run.image) digest.add(float(channel));
  if (said) said.push(`at the end: ${digest.words.join(" ")}`);
}

let machine, program;

function run({ surfaces, options }) {
  const named = surfaces.map(([depth, r, g, b, a, group]) => ({ depth, color: [r, g, b, a], group }));
  return machine.run(program, named, options);
}

const answers = {
  machine: (path) => (machine = require(path)) && null,
  page: (path) => {
    const page = {};
    require("vm").runInNewContext(require("fs").readFileSync(path, "utf8"), page);
    return Object.keys(page).concat(Object.keys(page.onionskin));
  },
  program: (object) => (program = object) && null,
  runs: (cases, detail) => cases.map((asked) => {
    const { events, ...left } = run(asked);
    const parting = left.parts === null ? null : events[left.parts];
    const more = { events: events.length, parting: parting && { name: parting.call?.name, pass: parting.pass } };
    if (program.on !== "calls") {
      const digest = new Digest();
      more.said = detail ? [] : null;
      pseudocode(program, digest, { events }, asked.options?.variables ?? {}, more.said);
      more.digest = digest.value();
    }
    return { ...left, ...more };
  }),
  words: (asked) => asked.map(([call, argument]) => machine.words(call, argument)),
  cases: (cases, detail) => cases.map((asked) => {
    const left = run(asked);
    const said = detail ? [] : null;
    if (left.error) return detail ? [`error: ${left.error.what}`] : [0, 0, []];
    const digest = new Digest();
    listing(digest, left, said);
    end(digest, left, said);
    return said ?? [...digest.value(), left.composited];
  }),
};

lines.on("line", (line) => {
  const asked = JSON.parse(line);
  const [name] = Object.keys(answers).filter((it) => it in asked);
  process.stdout.write(`${JSON.stringify(answers[name](asked[name], asked.detail))}\n`);
});
