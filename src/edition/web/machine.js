/**
 * The third machine: it runs a program (program_json.rs) on one pixel, in a page or in node. What a step does, and in which
 * order, is that of the emulated pixel (src/emulator/), whose files have the reasons. Numbers that OpenGL keeps as 32-bit
 * floats are rounded to them (Math.fround) after every operation.
 *
 *     const run = onionskin.run(program, [{ depth: 0.5, color: [1, 0, 0, 0.5], group: "unsorted" }]);
 *
 * Surfaces are given in the order of submission, and told by their place in it. A colour has straight alpha; a group is
 * "opaque", "sorted" or "unsorted". Options, all of which may be left out: `variables` in the place of the program's (a
 * program's null is Infinity), `limit`, the number of calls after which the run is left, `array`, the size of the Local Array,
 * and `order`, the surfaces as they are drawn if that is not the order of submission. Of pseudocode, the variables `rounds`
 * and `subpasses` limit its loops.
 *
 * @typedef {{depth: number, color: number[], group: string, order: number}} Surface
 *
 * A texel of a color map has `color` or `integers`. `from` are the surfaces that are in it, nearest first, or null where
 * they were mixed; `how` says how they came there: "replace", "under", "over", "mixed", or "data" if it is no colour. One of a depth map has `depth` and
 * `stencil`. Texels are never changed, only replaced.
 * @typedef {{color?: number[], integers?: number[], from?: number[]|null, how?: string, depth?: number, stencil?: number}} Texel
 *
 * What became of a surface in a draw. That of the quad over the screen has the surface null.
 * @typedef {{surface: number|null, outcome: string, depth: number, stencil: number[], stored_depth: number[],
 *            colors: number[][][]}} Fate
 *
 * A moment of a run. `line` is an index into the program's lines, `path` leads to the step in the program's JSON, `pass` is
 * the number of the draw to which it leads, or of the walk through a list. `kind` is "call", "let", "if", "stop", "loop" or
 * "list". `samples`, `variables` and `maps` are what they are after it. An "if" and a "stop" have `holds`. A line of
 * pseudocode has `surface`, the fragment's, if it is for one. One on lists has `size`, that of the Local Array, and `lists`:
 * the `list`, what is in the `buffer` (the Local Array), the depth and the id in `min`, what has been `composited`, what the
 * `walk` has `skipped`, `dropped`, held in its `array` and `composited`, and counts.
 * @typedef {{line: number|null, path: string, pass: number, kind: string, call: ?{name: string, arguments: Object},
 *            fates: ?Fate[], samples: Object, variables: Object, maps: Object<string, Texel>}} Event
 *
 * `image` is premultiplied. `composited` and `exact.order` are surfaces, nearest first, up to the opaque one. `parts` is the
 * index of the event from which on the image cannot become the exact one, or null if it is the exact one. `rounds` are those of
 * a pseudocode's `while`, `passes` the draws or walks, `lists` what is left of a list, with all its walks in `passes`.
 * @typedef {{events: Event[], image: number[], composited: number[], exact: {color: number[], order: number[]},
 *            parts: number|null, stopped: string|null, error: ?{what: string, event: number}}} Run
 */
var onionskin = (() => {
  "use strict";
  const f32 = Math.fround;
  const ZERO = [0, 0, 0, 0];

  /** What the program or a changed word of it does wrong, in words. */
  class Fault extends Error {}
  /** Thrown when a run has had as many calls as it may. */
  const LIMIT = {};

  // ---- Words ----------------------------------------------------------------------------------------------------------

  const COMPARE = {
    NEVER: () => false, LESS: (a, b) => a < b, EQUAL: (a, b) => a === b, LEQUAL: (a, b) => a <= b,
    GREATER: (a, b) => a > b, NOTEQUAL: (a, b) => a !== b, GEQUAL: (a, b) => a >= b, ALWAYS: () => true,
  };
  const SIGNS = { never: "NEVER", "<": "LESS", "=": "EQUAL", "<=": "LEQUAL", ">": "GREATER", "!=": "NOTEQUAL", ">=": "GEQUAL", always: "ALWAYS" };
  const STENCIL = {
    KEEP: (v) => v, ZERO: () => 0, REPLACE: (v, ref) => ref, INCR: (v) => Math.min(v + 1, 255), INCR_WRAP: (v) => (v + 1) & 255,
    DECR: (v) => Math.max(v - 1, 0), DECR_WRAP: (v) => (v + 255) & 255, INVERT: (v) => ~v & 255,
  };
  const FACTOR = {
    ZERO: () => 0, ONE: () => 1, SRC_ALPHA: (s) => s, ONE_MINUS_SRC_ALPHA: (s) => f32(1 - s),
    DST_ALPHA: (s, d) => d, ONE_MINUS_DST_ALPHA: (s, d) => f32(1 - d),
  };
  const EQUATION = { FUNC_ADD: null, MIN: Math.min, MAX: Math.max };
  const CAPS = ["DEPTH_TEST", "STENCIL_TEST", "BLEND"];
  const FLAGS = ["FALSE", "TRUE"];
  const GROUPS = {
    drawScene: () => true, drawOpaqueObjects: (g) => g === "opaque", drawTransparentObjects: (g) => g !== "opaque",
    drawSortedObjects: (g) => g === "sorted", drawUnsortedObjects: (g) => g === "unsorted", drawScreen: () => false,
  };

  /** A word of one of these, without its `GL_`. */
  function word(text, among) {
    const name = String(text).replace(/^GL_/, "");
    if (!(Array.isArray(among) ? among.includes(name) : name in among)) throw new Fault(`${text} cannot stand here`);
    return name;
  }
  const flag = (text) => word(text, FLAGS) === "TRUE";
  const holds = (compare, a, b) => COMPARE[word(SIGNS[compare] || compare, COMPARE)](a, b);

  /** Where calls take words, and which. */
  const TAKES = [
    [/^gl(DepthFunc|StencilFunc)\.func$|^glSamplerParameteri\.param$/, COMPARE],
    [/^glStencilOp\./, STENCIL],
    [/^glBlendFunc(Separate|i)?\.(s|d|src|dst)/, FACTOR],
    [/^glBlendEquationi\.mode$/, EQUATION],
    [/^gl(Enable|Disable)\.cap$/, CAPS],
    [/^glDepthMask\.flag$|^glColorMaski?\.(red|green|blue|alpha)$/, FLAGS],
  ];
  /** The same of pseudocode. */
  const LINES_TAKE = [
    [/^if\.(ab|bc|cd)$/, Object.keys(SIGNS)],
    [/^(if|insert|store)\.by$/, ["depth", "depth, id"]],
    [/^if\.is$/, ["complexity fits", "stencil fits", "complexity fits or last", "overflows", "not behind min"]],
    [/^until\.end$/, ["all resolved", "nothing dropped"]],
    [/^set min\.to$/, ["0", "before all"]],
    [/^resolve buffer\.taken$/, ["all", "all but the last on overflow"]],
    [/^store\.of$/, ["last", "last resolved"]],
    [/^count\.by$/, ["integer", "INCR", "INCR_WRAP"]],
    [/^mark\.by$/, ["flag", "KEEP", "REPLACE", "INVERT"]],
  ];

  /** What may stand in the place of a call's or a line's argument: words, the one that is there among them, or none. */
  function words(call, argument) {
    const place = `${call}.${argument}`;
    const gl = TAKES.find(([where]) => where.test(place));
    if (gl) return (Array.isArray(gl[1]) ? gl[1] : Object.keys(gl[1])).map((name) => `GL_${name}`);
    const line = LINES_TAKE.find(([where]) => where.test(place));
    return line ? [...line[1]] : [];
  }

  // ---- Shaders: the twins of glsl/, one function each ------------------------------------------------------------------

  // A twin gets the fragment and its pixel (`i`), and gives the texels for the color maps (`colors`) and a `depth` of its own
  // if it has one, or null if it discards.
  const UNIT_0 = "depth unit 0";
  const keep = (...colors) => ({ colors });
  const of = (i, color) => ({ color, from: i.surface.order < 0 ? [] : [i.surface.order], how: "replace" });
  const straight = (i) => of(i, i.surface.color);
  const times = ([r, g, b, a]) => [f32(r * a), f32(g * a), f32(b * a), a];
  const premultiplied = (i) => of(i, times(i.surface.color));
  /** What a texture unit has. An unbound one reads zeros. */
  const texel = (i, unit) => i.pixel.planes[i.pixel.textures[unit]]?.texel ?? EMPTY;
  const red = (i, unit) => texel(i, unit).depth ?? texel(i, unit).color?.[0] ?? 0;
  const passesUnit0 = (i) => holds(i.pixel.compare, i.depth, red(i, 0));
  const opaqueDepth = (i) => red(i, 4);
  const upper = (i) => Math.min(red(i, 2), red(i, 3), opaqueDepth(i));
  const clipped = (inside) => (i) => (inside(i.depth, red(i, 1), upper(i), i) ? keep(premultiplied(i)) : null);
  const openOpen = (z, low, high) => low < z && z < high;
  const closedOpen = (z, low, high) => low <= z && z < high;
  const isHidden = (i) => i.depth >= red(i, 5);
  /** The layer's texel, unless the opaque surface hides it. */
  const layer = (i) => (red(i, 3) < red(i, 1) ? texel(i, 2) : null);
  const under = (i) => {
    const found = layer(i);
    return found && keep({ ...found, color: times(found.color) });
  };
  const nearestAndFarthest = (i) => [-texel(i, 2).color[0], texel(i, 2).color[1]];
  /** Numbers that are no colour. */
  const data = (...color) => ({ color, from: null, how: "data" });
  const WHITE = data(1, 1, 1, 1);
  const previousDepth = (inside) => (i) => (inside(i.depth, red(i, 1), upper(i)) ? keep(data(1, 1, 1, i.depth)) : null);
  const NOTHING_LEFT = data(-2, -2, 0, 1);
  const EMPTY = { color: ZERO, from: [], how: "replace" };

  /** Algorithm 2's pixel: z1, z2, z3 and zPostFlag; the image; zPeel. */
  const ideal = (change) => (i) => {
    const [depths, image, peel] = i.place.colors;
    const p = { depths: depths.color, image, peel: peel.color, far: opaqueDepth(i) };
    change(p, i);
    return keep(data(...p.depths), p.image, data(...p.peel));
  };
  /** Lines 14 to 30. Whether the fragment lies in the range. */
  const peelFragment = (p, z) => {
    const [z1, z2, z3, post] = p.depths;
    if (!(p.peel[0] < z && z < z2)) return false;
    if (z < z1) p.depths = [z, z1, z, 0];
    else if (post !== 0) p.depths = [z1, z2, Math.min(z3, z), post];
    else p.depths = [z1, z2, z, z < z3 ? 1 : 0];
    return true;
  };
  const compositeFragment = (p, i) => {
    const source = premultiplied(i);
    const visible = f32(1 - p.image.color[3]);
    const color = p.image.color.map((here, at) => f32(here + f32(source.color[at] * visible)));
    p.image = { color, from: both(p.image.from, source.from), how: "under" };
  };
  const pass1 = (atPeel) => ideal((p, i) => {
    if (!peelFragment(p, i.depth) && i.depth === p.peel[0] && atPeel(p, i)) compositeFragment(p, i);
  });
  const four = (z) => [z, z, z, z];

  const TWINS = {
    surface: (i) => keep(straight(i)),
    peel: (i) => (passesUnit0(i) ? keep(straight(i)) : UNIT_0),
    layer: (i) => keep(texel(i, 2)),
    over: (i) => layer(i) && keep(texel(i, 2)),
    under,
    "clip/open_open": clipped(openOpen),
    "clip/between_peels_as_printed": clipped(openOpen),
    "clip/open_closed": clipped((z, low, high) => low < z && z <= high),
    "clip/closed_open": clipped(closedOpen),
    "clip/closed_closed": clipped((z, low, high) => low <= z && z <= high),
    "clip/at_bound": clipped((z, low, high, i) => z < opaqueDepth(i) && z === high),
    "clip/at_bound_as_printed": clipped((z, low, high) => z === high),
    "clip/previous_depth": previousDepth(openOpen),
    "clip/previous_depth_from_near": previousDepth(closedOpen),
    "clip/next_bound": (i) => ({ colors: [], depth: upper(i) }),
    "dual/depths": (i) => keep(data(-i.depth, i.depth, 0, 1)),
    "dual/peel": (i) => {
      const [nearest, farthest] = nearestAndFarthest(i);
      const z = i.depth;
      if (z < nearest || z > farthest) return null;
      const [atNearest, atFarthest] = [z === nearest, z === farthest];
      const next = atNearest || atFarthest ? NOTHING_LEFT : data(-z, z, 0, 1);
      return keep(next, atNearest ? premultiplied(i) : EMPTY, atFarthest && !atNearest ? premultiplied(i) : EMPTY);
    },
    "dual/left": (i) => {
      const [nearest, farthest] = nearestAndFarthest(i);
      return nearest > farthest ? null : keep(WHITE);
    },
    "ideal/begin": ideal((p) => ([p.peel, p.depths] = [four(p.depths[2]), [p.far, p.far, p.far, 0]])),
    "ideal/begin_as_printed": ideal((p) => ([p.peel, p.depths] = [four(p.depths[2]), [p.far, p.far, p.depths[2], 0]])),
    "ideal/pass_1": pass1((p, i) => i.depth < p.far),
    "ideal/pass_1_as_printed": pass1(() => true),
    "ideal/pass_2": ideal((p, i) => {
      if (p.peel[0] < i.depth && i.depth < p.depths[2]) compositeFragment(p, i);
    }),
    "ideal/changed": (i) => (i.place.colors[0].color[0] < opaqueDepth(i) ? keep() : null),
    "verified/surface": (i) => (isHidden(i) ? null : keep(straight(i))),
    // It asks for early tests, but as it discards nothing, that makes no difference.
    "verified/mark": () => keep(),
    "verified/place": (i) => keep(texel(i, 3)),
  };

  // ---- The pixel: state, maps, and what each call does ------------------------------------------------------------------

  /** How formats store colours. Of channels that they lack, alpha is 1 and the others are 0. */
  const FORMATS = {
    rgba32f: (c) => c, rg32f: ([r, g]) => [r, g, 0, 1], r32ui: ([r]) => [r, 0, 0, 1], d32f: null,
  };
  const INTEGERS = ["r32ui"];
  const depthOf = (z) => (Number.isNaN(z) ? 1 : Math.min(Math.max(f32(z), 0), 1));
  const both = (front, behind) => (front && behind ? [...front, ...behind] : null);

  /** The texel under the format, or undefined if they do not go together. */
  function stored(format, texel) {
    const channels = INTEGERS.includes(format) ? "integers" : "color";
    return texel[channels] && { ...texel, [channels]: FORMATS[format](texel[channels]) };
  }

  /**
   * Whether factors put what is drawn under what is there, over it, or in its place. Otherwise colours are mixed. What comes
   * under others later is seen through their alpha, so that one must be right, too.
   */
  function howBlended({ equation, src_rgb: src, dst_rgb: dst, src_alpha, dst_alpha }) {
    if (equation !== "FUNC_ADD") return "mixed";
    if (src === "ONE_MINUS_DST_ALPHA" && dst === "ONE") return src_alpha === src && dst_alpha === dst ? "under" : "mixed";
    if ((src === "ONE" || src === "SRC_ALPHA") && dst === "ONE_MINUS_SRC_ALPHA") return "over";
    return src === "ONE" && dst === "ZERO" ? "replace" : "mixed";
  }

  function blend(state, source, here) {
    const how = source.how === "data" ? "data" : howBlended(state);
    let from = how === "replace" ? source.from : null;
    if (how === "under") from = both(here.from, source.from);
    if (how === "over") from = both(source.from, here.from);
    const [s, d] = [source.color, here.color];
    const choose = EQUATION[state.equation];
    const sum = (channel, src, dst) =>
      f32(f32(s[channel] * FACTOR[src](s[3], d[3])) + f32(d[channel] * FACTOR[dst](s[3], d[3])));
    const one = (channel) => {
      if (choose) return choose(s[channel], d[channel]);
      return channel < 3 ? sum(channel, state.src_rgb, state.dst_rgb) : sum(3, state.src_alpha, state.dst_alpha);
    };
    // What adds nothing leaves what is there.
    const nothing = how !== "replace" && source.from?.length === 0;
    return { color: [0, 1, 2, 3].map(one), from, how: nothing ? here.how : how };
  }

  /** Writes the channels that the mask lets through. */
  function masked(here, next, mask) {
    if (!next || !mask.includes(true)) return here;
    const channels = here.integers ? "integers" : "color";
    const values = here[channels].map((value, channel) => (mask[channel] ? next[channels][channel] : value));
    const isSeen = mask[0] || mask[1] || mask[2];
    return { ...(isSeen ? next : here), [channels]: values };
  }

  class Pixel {
    /** In OpenGL's initial state, with the program's maps and framebuffers. `drawn` are the surfaces as they are drawn. */
    constructor(program, drawn) {
      this.drawn = drawn;
      this.depth = { test: false, func: "LESS", mask: true };
      this.stencil = { test: false, func: "ALWAYS", ref: 0, mask: 255, ops: ["KEEP", "KEEP", "KEEP"], write: 255 };
      this.blend = false;
      const buffer = () => ({ equation: "FUNC_ADD", src_rgb: "ONE", dst_rgb: "ZERO", src_alpha: "ONE", dst_alpha: "ZERO", mask: [true, true, true, true] });
      this.buffers = [0, 1, 2, 3, 4, 5, 6, 7].map(buffer);
      this.clear = { color: ZERO, depth: 1, stencil: 0 };
      this.compare = "LEQUAL";
      /** Depth unit 0 is a shadow lookup. Calls go to unit 1, the ordinary depth buffer, but inside of `depth unit 0`. */
      this.units = { active: 1, func: "LESS", enabled: false };
      this.shader = null;
      this.samples = {};
      this.counting = null;
      /** Planes have texels; names lead to planes, and so does what is bound, whatever a plane is called later. */
      this.planes = [];
      this.names = {};
      this.targets = {};
      this.target = null;
      this.textures = [];
      this.active = 0;
      this.snapshot = null;
      for (const { name, format } of program.maps) this.allocate(name, format);
      for (const { name, colors, depth } of program.framebuffers) {
        this.targets[name] = { colors: colors.map((map) => this.plane(map)), depth: depth === null ? null : this.plane(depth) };
      }
    }

    allocate(name, format) {
      if (this.planes[this.names[name]]?.format === format) return;
      if (!(format in FORMATS)) throw new Fault(`there are no maps of the format ${format}`);
      this.snapshot = null;
      this.names[name] = this.planes.length;
      const texel = FORMATS[format] === null ? { depth: 0, stencil: 0 } : stored(format, INTEGERS.includes(format) ? { integers: ZERO } : EMPTY);
      this.planes.push({ format, texel });
    }

    plane(name) {
      if (!(name in this.names)) throw new Fault(`there is no map '${name}'`);
      return this.names[name];
    }

    set(plane, texel) {
      if (this.planes[plane].texel !== texel) this.snapshot = null;
      this.planes[plane].texel = texel;
    }

    /** The texels of all maps by name. */
    maps() {
      this.snapshot ??= Object.fromEntries(Object.entries(this.names).map(([name, plane]) => [name, this.planes[plane].texel]));
      return this.snapshot;
    }

    attached() {
      if (this.target === null) throw new Fault("the listing draws or clears before it chooses a framebuffer");
      return (this.targets[this.target] ??= { colors: [], depth: null });
    }

    /** Performs a call, whose arguments have values in the places of variables. A draw gives its fates. */
    perform(name, a) {
      if (this.units.active === 0 && this.unit0(name, a)) return null;
      if (name in GROUPS) return this.draw(name);
      if (!(name in CALLS)) throw new Fault(`${name} is not performed`);
      CALLS[name](this, a);
      return null;
    }

    /** A call to depth unit 0, if it is one that belongs to a unit. */
    unit0(name, a) {
      const { units } = this;
      const test = name === "glEnable" || name === "glDisable";
      if (name === "bindDepthBuffer") [this.active, this.textures[0]] = [0, this.plane(a.buffer)];
      else if (name === "glDepthFunc") units.func = word(a.func, COMPARE);
      else if (test && word(a.cap, CAPS) === "DEPTH_TEST") units.enabled = name === "glEnable";
      else if (name === "glDepthMask" && !flag(a.flag)) return true;
      else if (name === "glDepthMask" || (name === "glClear" && /DEPTH/.test(a.mask))) throw new Fault("depth unit 0 is a shadow map, which is only looked up");
      else return false;
      if (name !== "bindDepthBuffer") this.compare = units.enabled ? units.func : "ALWAYS";
      return true;
    }

    clearMaps(mask) {
      const { colors, depth } = this.attached();
      if (/COLOR/.test(mask)) colors.forEach((_, number) => this.clearColor(number, { ...EMPTY, color: this.clear.color }));
      if (depth === null) return;
      const here = this.planes[depth].texel;
      const write = /STENCIL/.test(mask) ? this.stencil.write : 0;
      this.set(depth, {
        depth: /DEPTH/.test(mask) && this.depth.mask ? depthOf(this.clear.depth) : here.depth,
        stencil: (here.stencil & ~write) | (this.clear.stencil & write & 255),
      });
    }

    clearColor(number, texel) {
      const plane = this.attached().colors[number];
      if (plane === undefined) return;
      const { format, texel: here } = this.planes[plane];
      this.set(plane, masked(here, stored(format, texel), this.buffers[number].mask));
    }

    draw(objects) {
      const shader = this.shader;
      if (shader === null) throw new Fault("the listing draws before it chooses a program");
      if (!(shader in TWINS)) throw new Fault(`there is no shader ${shader}`);
      const attached = this.attached();
      // The quad's vertices are at z = 0 in clip space.
      const screen = { depth: 0.5, color: ZERO, order: -1 };
      const drawn = objects === "drawScreen" ? [screen] : this.drawn.filter(({ group }) => GROUPS[objects](group));
      return drawn.map((surface) => this.send(surface, attached));
    }

    /** Sends a surface's fragment through the shader and the stages. */
    send(surface, attached) {
      const before = attached.depth === null ? { depth: 1, stencil: 0 } : this.planes[attached.depth].texel;
      const place = { texel: before, colors: attached.colors.map((plane) => this.planes[plane].texel) };
      const kept = TWINS[this.shader]({ surface, depth: surface.depth, pixel: this, place });
      let outcome = kept === null ? "discarded" : kept;
      if (kept?.colors) outcome = this.test(place, kept.depth ?? surface.depth, attached.depth !== null);
      const colors = place.colors.slice();
      if (outcome === "pass") {
        if (this.counting !== null) this.samples = { ...this.samples, [this.counting]: this.samples[this.counting] + 1 };
        kept.colors.forEach((source, number) => this.write(attached.colors[number], number, source, colors));
      }
      if (attached.depth !== null && place.texel !== before) this.set(attached.depth, place.texel);
      const channels = (texel) => texel.color ?? texel.integers;
      return {
        surface: surface.order < 0 ? null : surface.order,
        outcome,
        depth: surface.depth,
        stencil: [before.stencil, place.texel.stencil],
        stored_depth: [before.depth, place.texel.depth],
        colors: place.colors.map((texel, number) => [channels(texel), channels(colors[number])]),
      };
    }

    /** The stencil test, then the depth test. */
    test(place, z, hasDepth) {
      const { depth, stencil } = place.texel;
      const { ops, write, mask } = this.stencil;
      const ref = Math.min(Math.max(this.stencil.ref, 0), 255);
      const after = (op) => {
        if (!this.stencil.test || !hasDepth) return stencil;
        return (stencil & ~write & 255) | (STENCIL[ops[op]](stencil, ref) & write & 255);
      };
      if (this.stencil.test && hasDepth && !COMPARE[this.stencil.func](ref & mask & 255, stencil & mask & 255)) {
        place.texel = { depth, stencil: after(0) };
        return "stencil";
      }
      const tested = this.depth.test && hasDepth;
      if (hasDepth) z = depthOf(z);
      if (tested && !COMPARE[this.depth.func](z, depth)) {
        place.texel = { depth, stencil: after(1) };
        return "depth";
      }
      // Without a depth test, nothing is written to the depth buffer.
      place.texel = { depth: tested && this.depth.mask ? z : depth, stencil: after(2) };
      return "pass";
    }

    write(plane, number, source, colors) {
      if (plane === undefined) return;
      const { format, texel: here } = this.planes[plane];
      const state = this.buffers[number];
      const isColor = here.color && source.color;
      const next = this.blend && isColor ? blend(state, source, here) : source;
      colors[number] = masked(here, stored(format, next), state.mask);
      this.set(plane, colors[number]);
    }
  }

  const channels = (a) => [a.red, a.green, a.blue, a.alpha];
  const factors = (src_rgb, dst_rgb, src_alpha, dst_alpha) => {
    const named = { src_rgb, dst_rgb, src_alpha, dst_alpha };
    for (const name in named) named[name] = word(named[name], FACTOR);
    return named;
  };
  const enable = (on) => (p, { cap }) => {
    const name = word(cap, CAPS);
    if (name === "DEPTH_TEST") p.depth.test = on;
    if (name === "STENCIL_TEST") p.stencil.test = on;
    if (name === "BLEND") p.blend = on;
  };
  const buffer = (p, number) => {
    if (!(number in p.buffers)) throw new Fault(`there is no color map ${number}`);
    return p.buffers[number];
  };

  /** What each call does to a pixel (`p`), by its arguments. Draws and depth units are the pixel's own. */
  const CALLS = {
    glClearColor: (p, a) => (p.clear.color = channels(a).map((text) => f32(Number(text)))),
    glClearDepth: (p, a) => (p.clear.depth = Number(a.depth)),
    glClearStencil: (p, a) => (p.clear.stencil = Number(a.s)),
    glClear: (p, a) => p.clearMaps(a.mask),
    glClearBufferfv: (p, a) => p.clearColor(a.drawbuffer, { ...EMPTY, color: a.value.match(/[-\d.]+/g).map((text) => f32(Number(text))) }),
    glEnable: enable(true),
    glDisable: enable(false),
    glDepthFunc: (p, a) => (p.depth.func = word(a.func, COMPARE)),
    glDepthMask: (p, a) => (p.depth.mask = flag(a.flag)),
    glColorMask: (p, a) => p.buffers.forEach((it) => (it.mask = channels(a).map(flag))),
    glColorMaski: (p, a) => (buffer(p, a.buf).mask = channels(a).map(flag)),
    glStencilMask: (p, a) => (p.stencil.write = Number(a.mask)),
    glStencilFunc: (p, a) => Object.assign(p.stencil, { func: word(a.func, COMPARE), ref: Number(a.ref), mask: Number(a.mask) }),
    glStencilOp: (p, a) => (p.stencil.ops = [a.sfail, a.dpfail, a.dppass].map((op) => word(op, STENCIL))),
    glBlendFunc: (p, a) => p.buffers.forEach((it) => Object.assign(it, factors(a.sfactor, a.dfactor, a.sfactor, a.dfactor))),
    glBlendFuncSeparate: (p, a) => p.buffers.forEach((it) => Object.assign(it, factors(a.srcRGB, a.dstRGB, a.srcAlpha, a.dstAlpha))),
    glBlendFunci: (p, a) => Object.assign(buffer(p, a.buf), factors(a.src, a.dst, a.src, a.dst)),
    glBlendEquationi: (p, a) => (buffer(p, a.buf).equation = word(a.mode, EQUATION)),
    glSamplerParameteri: (p, a) => (p.compare = word(a.param, COMPARE)),
    glActiveTexture: (p, a) => (p.active = Number(a.texture.replace("GL_TEXTURE", ""))),
    glBindTexture: (p, a) => (p.textures[p.active] = p.plane(a.texture)),
    glUseProgram: (p, a) => (p.shader = a.program),
    glBindFramebuffer: (p, a) => (p.target = a.framebuffer),
    glFramebufferTexture2D: (p, a) => {
      if (/COLOR/.test(a.attachment)) p.attached().colors[0] = p.plane(a.texture);
      else p.attached().depth = p.plane(a.texture);
    },
    activeDepthUnit: (p, a) => (p.units.active = Number(word(a.unit, ["0", "1"]))),
    bindDepthBuffer: (p, a) => (p.attached().depth = p.plane(a.buffer)),
    glBeginQuery: (p, a) => {
      p.samples = { ...p.samples, [a.id]: 0 };
      p.counting = a.id;
    },
    glEndQuery: (p) => (p.counting = null),
    glCopyImageSubData: (p, a) => {
      const { format, texel } = p.planes[p.plane(a.src)];
      p.allocate(a.dst, format);
      p.set(p.plane(a.dst), texel);
    },
    swap: (p, a) => {
      [p.names[a.a], p.names[a.b]] = [p.plane(a.b), p.plane(a.a)];
      p.snapshot = null;
    },
    // A pixel's part of a buffer is kept with the pixel, and every write is seen at once.
    glBindBufferBase: () => {},
    glMemoryBarrier: () => {},
  };

  // ---- Walking a program ------------------------------------------------------------------------------------------------

  const operate = {
    "+": (a, b) => a + b, "-": (a, b) => a - b, "*": (a, b) => a * b, "%": (a, b) => ((a % b) + Math.abs(b)) % Math.abs(b),
  };
  /** The arguments that name maps, and those that are numbers. Either may have a variable. */
  const MAPS = ["texture", "src", "dst", "a", "b", "buffer"];
  const NUMBERS = ["ref", "N"];

  class Walk {
    constructor(program, surfaces, options) {
      const variables = { ...program.variables, ...options.variables };
      for (const name in variables) variables[name] ??= Infinity;
      Object.assign(this, { program, surfaces, variables });
      this.events = [];
      this.calls = 0;
      this.limit = options.limit ?? 20000;
      this.array = options.array ?? program.array;
      this.pass = 0;
      this.stopped = null;
      this.pixel = new Pixel(program, order(program, surfaces, options.order));
      this.composited = [];
      this.rounds = 0;
      this.lists = null;
    }

    tell(step, path, kind, more) {
      this.events.push({
        line: step.line ?? null, path, pass: this.pass, kind, call: null, fates: null,
        samples: this.pixel.samples, variables: this.variables, maps: this.pixel.maps(), ...more,
      });
    }

    /** Before a call. */
    count() {
      if (this.calls === this.limit) throw LIMIT;
      this.calls += 1;
    }

    let(name, value) {
      this.variables = { ...this.variables, [name]: value };
    }

    value(expr) {
      if (typeof expr === "number") return expr;
      if (typeof expr === "string") {
        if (!(expr in this.variables)) throw new Fault(`the listing reads the variable ${expr} before it is set`);
        return this.variables[expr];
      }
      if (expr === null) return Infinity;
      if (Array.isArray(expr)) return operate[expr[0]](this.value(expr[1]), this.value(expr[2]));
      if (!(expr.samples in this.pixel.samples)) throw new Fault(`the listing asks the query '${expr.samples}' before it is made`);
      return this.pixel.samples[expr.samples];
    }

    holds([compare, a, b]) {
      return holds(compare, this.value(a), this.value(b));
    }

    /** A call's arguments with values in the places of variables. */
    resolved(given) {
      const known = { ...given };
      const whole = (name) => String(Math.trunc(this.variables[name]));
      for (const name in known) {
        const text = known[name];
        const last = text.slice(text.lastIndexOf(" ") + 1);
        if (NUMBERS.includes(name) && text in this.variables) known[name] = whole(text);
        if (MAPS.includes(name) && last !== text && last in this.variables) known[name] = text.slice(0, -last.length) + whole(last);
      }
      return known;
    }

    call(step, path, name, given) {
      this.count();
      const known = this.resolved(given);
      const fates = this.pixel.perform(name, known);
      this.tell(step, path, "call", { call: { name, arguments: known }, fates });
      if (fates) this.pass += 1;
    }

    /** Whether a loop is left. */
    steps(steps, path) {
      return steps.some((step, at) => this.step(step, `${path}/${at}`));
    }

    step(step, path) {
      const into = (part) => this.steps(step[part], `${path}/${part}`);
      const round = (number) => {
        this.let(step.variable, number);
        this.tell(step, path, "loop");
        return into("body");
      };
      switch (step.step) {
        case "call":
          this.call(step, path, step.name, step.arguments);
          break;
        case "depth-unit":
          this.call(step, path, "activeDepthUnit", { unit: String(step.unit) });
          return into("body");
        case "let":
          this.let(step.variable, this.value(step.value));
          this.tell(step, path, "let");
          break;
        case "if": {
          const isSo = this.holds(step.when);
          this.tell(step, path, "if", { holds: isSo });
          return into(isSo ? "then" : "otherwise");
        }
        case "for":
          for (let number = this.value(step.from); number < this.value(step.to); number += 1) if (round(number)) break;
          break;
        case "for-down":
          for (let number = this.value(step.from) - 1; number >= 0; number -= 1) if (round(number)) break;
          break;
        case "stop": {
          const isSo = this.holds(step.when);
          if (isSo) this.stopped = step.why;
          this.tell(step, path, "stop", { holds: isSo });
          return isSo;
        }
        case "run":
          into("body");
          break;
        case "resolve":
          this.resolve(step, path);
          break;
        case "line":
          this.line(step, path, null);
      }
      return false;
    }

    /** Resolves the pixel's list between two texts. */
    resolve(step, path) {
      const lists = new Lists(this, step.array);
      lists.all(step.body, `${path}/body`);
      const behind = this.pixel.planes[this.pixel.plane(step.behind)];
      this.pixel.allocate(step.into, behind.format);
      this.pixel.set(this.pixel.plane(step.into), compositedOver(this.surfaces, lists.composited, behind.texel));
      this.tell(step, path, "list", { lists: lists.told() });
    }

    // ---- Pseudocode on fragments as they are rasterised (src/emulator/pseudo.rs) ------------------------------------------

    get(name) {
      if (name === "true" || name === "false") return name === "true" ? 1 : 0;
      if (name === "before zNear") return -1;
      if (!(name in this.variables)) throw new Fault(`the algorithm reads ${name} before it is set`);
      return this.variables[name];
    }

    line(step, path, surface) {
      const a = step.arguments;
      const on = surface === null ? {} : { surface: surface.order };
      const tell = (kind, more) => this.tell(step, path, kind, { call: { name: step.name, arguments: a }, ...on, ...more });
      const drawn = (objects) => this.pixel.drawn.filter(({ group }) => GROUPS[`draw${objects}Objects`](group));
      const into = (part, of = surface) => (step[part] ?? []).forEach((line, at) => this.line(line, `${path}/${part}/${at}`, of));
      if (step.step !== "line") return;
      this.count();
      switch (step.name) {
        case "for pixels":
          tell("loop");
          into("body");
          break;
        case "for fragments":
          for (const of of drawn(a.of)) {
            this.let("zFragment", of.depth);
            tell("loop", { surface: of.order });
            into("body", of);
          }
          if (drawn(a.of).length > 0) this.pass += 1;
          break;
        case "while":
          while (this.get(a.flag) !== 0) {
            if (this.rounds === this.variables.rounds) {
              this.stopped = "limit";
              break;
            }
            this.rounds += 1;
            tell("loop");
            into("body");
          }
          break;
        case "if": {
          const pairs = [[a.a, a.ab, a.b], [a.b, a.bc, a.c], [a.c, a.cd, a.d]];
          const isSo = pairs.every(([x, compare, y]) => compare === undefined || holds(compare, this.get(x), this.get(y)));
          tell("if", { holds: isSo });
          into(isSo ? "body" : "otherwise");
          break;
        }
        case "set":
          this.let(a.variable, this.get("if" in a && this.get(a.if) === 0 ? a.else : a.value));
          tell("let");
          break;
        case "swap":
          this.variables = { ...this.variables, [a.a]: this.get(a.b), [a.b]: this.get(a.a) };
          tell("let");
          break;
        case "composite":
          this.composited = [...this.composited, surface.order];
          tell("call", { composited: this.composited });
          break;
      }
    }
  }

  /** The surfaces as they are drawn: those of a given order, opaque ones first, or else as the program asks for. */
  function order(program, surfaces, given) {
    if (given) return [...surfaces.filter(({ group }) => group === "opaque"), ...given.map((number) => surfaces[number]).filter(({ group }) => group !== "opaque")];
    if (program.order !== "sorted front to back") return surfaces;
    const isSorted = ({ group }) => group === "sorted";
    return [...surfaces.filter((it) => !isSorted(it)), ...surfaces.filter(isSorted).sort((a, b) => a.depth - b.depth)];
  }

  // ---- Pseudocode on the pixel's finished list (src/emulator/lists.rs) ----------------------------------------------------

  const last = (list) => list[list.length - 1];
  const numbers = (surfaces) => surfaces.map(({ order }) => order);

  class Lists {
    /** The list that the Fill Step leaves: what no opaque surface hides, in the order of submission. */
    constructor(walk, array) {
      const opaque = opaqueDepthOf(walk.surfaces);
      walk.lists = this;
      this.walk = walk;
      this.array = array;
      this.list = walk.surfaces.filter(({ group, depth }) => group !== "opaque" && depth < opaque);
      Object.assign(this, { complexity: 0, stencil: 0, marked: false, peel: null, composited: [], passes: [] });
      Object.assign(this, { times: 0, records_read: 0, slots: [0, 0] });
    }

    told() {
      const { list, peel, complexity, stencil, marked, composited, passes, times, records_read, slots } = this;
      const counts = { complexity, stencil, marked, times, records_read, slots };
      return { list: numbers(list), buffer: peel && numbers(peel.buffer), min: peel && peel.min, composited, walk: last(passes), ...counts };
    }

    begin() {
      this.passes.push({ skipped: [], dropped: [], array: [], composited: [] });
      this.walk.pass = this.passes.length;
    }

    /** Adds to the walk that was begun last. Like texels, walks are never changed, only replaced. */
    add(to, surfaces) {
      if (this.passes.length === 0) this.begin();
      const pass = last(this.passes);
      this.passes[this.passes.length - 1] = { ...pass, [to]: [...pass[to], ...numbers(surfaces)] };
    }

    composite(surfaces) {
      this.walk.composited = this.composited = [...this.composited, ...numbers(surfaces)];
      this.add("composited", surfaces);
    }

    reserve(size) {
      this.times += 1;
      this.slots = [this.slots[0] + size, this.slots[1] + Math.min(size, this.list.length)];
    }

    /** Runs a whole algorithm. One for a single pixel begins with its input. */
    all(lines, path) {
      if (lines.some(({ name }) => name === "input")) this.reserve(this.array);
      this.lines(lines, path, { size: this.array, fragment: null });
    }

    lines(lines, path, here) {
      lines.forEach((line, at) => this.line(line, `${path}/${at}`, here));
    }

    peeling(step) {
      if (!this.peel) throw new Fault(`there is nothing for '${step.text}' to work on`);
      return this.peel;
    }

    line(step, path, here) {
      if (step.step !== "line") return;
      this.walk.count();
      const { size, fragment } = here;
      const tell = (kind, more) => this.walk.tell(step, path, kind, {
        call: { name: step.name, arguments: step.arguments }, surface: fragment && fragment.order, lists: this.told(), size, ...more,
      });
      const into = (part, inside = here) => this.lines(step[part] ?? [], `${path}/${part}`, inside);
      switch (step.name) {
        case "for pixels":
        case "for unresolved pixels":
          if (step.name !== "for pixels" && this.marked) break;
          tell("loop");
          into("body");
          break;
        case "for segments":
          if (this.array < 8) throw new Fault(`the last segment cannot be ${this.array}: the first is 8`);
          for (let i = 8; i <= this.array; i *= 2) {
            this.walk.let("i", i);
            tell("loop", { size: i });
            into("body", { ...here, size: i });
          }
          break;
        case "for fragments":
          this.begin();
          for (const f of this.list) {
            this.records_read += 1;
            tell("loop", { surface: f.order });
            into("body", { ...here, fragment: f });
          }
          break;
        case "repeat":
          this.repeat(step, path, here, tell);
          break;
        case "if": {
          const isSo = this.test(step, size, fragment);
          tell("if", { holds: isSo });
          into(isSo ? "body" : "otherwise");
          break;
        }
        case "run":
          tell("list");
          this.reserve(size);
          into("body", { size, fragment: null });
          break;
        default:
          this.statement(step, size, fragment);
          if (step.name !== "nothing" && step.name !== "input") tell("list");
      }
    }

    repeat(step, path, here, tell) {
      for (let round = 0; ; round += 1) {
        if (round === this.walk.variables.subpasses) {
          this.walk.stopped = "limit";
          return;
        }
        this.peeling(step).dropped = false;
        tell("loop");
        step.body.forEach((line, at) => line.name !== "until" && this.line(line, `${path}/body/${at}`, here));
        const at = step.body.findIndex(({ name }) => name === "until");
        const until = step.body[at];
        const { resolved, dropped } = this.peeling(step);
        const isSo = until.arguments.end === "all resolved" ? resolved === this.list.length : !dropped;
        this.walk.tell(until, `${path}/body/${at}`, "stop", { holds: isSo, lists: this.told(), size: here.size });
        if (isSo) return;
      }
    }

    /** A statement that has no others inside. */
    statement(step, size, fragment) {
      const a = step.arguments;
      const peel = () => this.peeling(step);
      const DO = {
        nothing: () => {},
        input: () => {},
        skip: () => this.add("skipped", [fragment]),
        count: () => {
          this.complexity = this.list.length;
          if (a.by !== "integer") for (const _ of this.list) this.stencil = STENCIL[word(a.by, STENCIL)](this.stencil, 0);
        },
        mark: () => {
          if (a.by === "flag") this.marked = true;
          else this.stencil = STENCIL[word(a.by, STENCIL)](this.stencil, Math.min(size, 255));
        },
        resolve: () => this.resolve(size),
        "create buffer": () => (this.peel = { n: size, buffer: [], min: null, dropped: false, resolved: 0, last: null }),
        "set min": () => (peel().min = a.to === "0" ? [0, Infinity] : [-Infinity, -1]),
        insert: () => this.insert(peel(), fragment, a.by),
        "resolve buffer": () => {
          const { n, buffer, dropped } = peel();
          const taken = dropped && a.taken !== "all" ? buffer.slice(0, n - 1) : buffer;
          peel().resolved += taken.length;
          peel().last = last(taken) ?? peel().last;
          this.add("array", buffer);
          this.composite(taken);
        },
        store: () => {
          const element = a.of === "last" ? last(peel().buffer) : peel().last;
          // Depth alone stands for every id at that depth.
          if (element) peel().min = [element.depth, a.by === "depth" ? Infinity : element.order];
        },
        "clear buffer": () => (peel().buffer = []),
      };
      if (!(step.name in DO)) throw new Fault(`'${step.text}' is not performed`);
      DO[step.name]();
    }

    /** Resolves the list by a static array, for which only its first fragments have room. */
    resolve(size) {
      this.reserve(size);
      this.begin();
      const fits = this.list.slice(0, size);
      this.records_read += fits.length;
      fits.sort((a, b) => a.depth - b.depth || a.order - b.order);
      this.add("dropped", this.list.slice(size));
      this.add("array", fits);
      this.composite(fits);
    }

    insert(peel, f, by) {
      const isBefore = (other) => f.depth < other.depth || (by === "depth, id" && f.depth === other.depth && f.order < other.order);
      const at = peel.buffer.findIndex(isBefore);
      const place = at < 0 ? peel.buffer.length : at;
      peel.buffer = [...peel.buffer.slice(0, place), f, ...peel.buffer.slice(place)];
      if (peel.buffer.length <= peel.n) return;
      peel.dropped = true;
      this.add("dropped", peel.buffer.slice(peel.n));
      peel.buffer = peel.buffer.slice(0, peel.n);
    }

    test(step, size, f) {
      const { is, by } = step.arguments;
      if (is === "not behind min") {
        const { min } = this.peeling(step);
        if (!min) throw new Fault(`'${step.text}' reads a min depth that nothing has set`);
        return f.depth < min[0] || (f.depth === min[0] && (by === "depth" || f.order <= min[1]));
      }
      if (is === "stencil fits") return this.stencil <= Math.min(size, 255);
      if (is === "overflows") return this.complexity > size;
      return this.complexity <= size || (is === "complexity fits or last" && size > Math.floor(this.array / 2));
    }
  }

  // ---- The whole run ------------------------------------------------------------------------------------------------------

  const opaqueDepthOf = (surfaces) => Math.min(1, ...surfaces.filter(({ group }) => group === "opaque").map(({ depth }) => depth));

  /** These surfaces, nearest first, over what lies behind them. */
  function compositedOver(surfaces, composited, behind) {
    let color = ZERO;
    const put = (layer) => {
      const visible = f32(1 - color[3]);
      color = color.map((channel, at) => f32(channel + f32(layer[at] * visible)));
    };
    for (const number of composited) put(times(surfaces[number].color));
    put(behind.color);
    return { color, from: both(composited, behind.from), how: "over" };
  }

  /** Every surface, nearest first. Of equal depths an opaque one hides the others, and the first submitted comes first. */
  function sorted(surfaces) {
    const hides = ({ group }) => (group === "opaque" ? 0 : 1);
    return surfaces.slice().sort((a, b) => a.depth - b.depth || hides(a) - hides(b) || a.order - b.order);
  }

  /** The exact composite, in 64-bit floats. */
  function exactly(surfaces) {
    const all = sorted(surfaces);
    const opaque = all.findIndex(({ group }) => group === "opaque");
    const seen = opaque < 0 ? all : all.slice(0, opaque + 1);
    const color = [0, 0, 0, 0];
    for (const { color: [r, g, b, alpha], group } of seen) {
      const part = (1 - color[3]) * (group === "opaque" ? 1 : alpha);
      [r, g, b, 1].forEach((channel, at) => (color[at] += part * channel));
    }
    return { color, order: numbers(seen) };
  }

  /** By how much the colours of an image may be off that is exact: four roundings of 2^-24 a layer, for eight layers. */
  const ROUNDING = 32 / 2 ** 24;

  function run(program, given, options = {}) {
    const surfaces = given.map(({ depth, color, group }, order) => ({ depth: f32(depth), color: color.map(f32), group, order }));
    const walk = new Walk(program, surfaces, options);
    let error = null;
    if (program.on === "fragments") {
      walk.let("zNear", 0);
      walk.let("zOpaque", opaqueDepthOf(surfaces));
      walk.let("gChanged", 0);
    }
    try {
      if (program.on === "lists") new Lists(walk, walk.array).all(program.steps, "/steps");
      else walk.steps(program.steps, "/steps");
    } catch (thrown) {
      if (thrown === LIMIT) walk.stopped = "limit";
      else if (thrown instanceof Fault) error = { what: thrown.message, event: walk.events.length };
      else throw thrown;
    }
    const { events, stopped, variables, rounds, pass, lists } = walk;
    const exact = exactly(surfaces);
    const opaque = surfaces[last(exact.order)];
    const behind = opaque?.group === "opaque" ? { color: opaque.color, from: [opaque.order] } : EMPTY;
    const image = program.on === "calls" ? walk.pixel.maps().image ?? EMPTY : compositedOver(surfaces, walk.composited, behind);
    const parts = partsAt(program, surfaces, events, image, exact);
    return {
      events, image: image.color, composited: image.from ?? [], exact, parts, stopped, error, variables, rounds, passes: pass, lists: lists && { ...lists.told(), passes: lists.passes },
    };
  }

  /**
   * The index of the first event that spoils the image, or null if it is exact. That it is takes the colours, and the alpha or
   * the order: a blending function may leave an alpha that no screen shows.
   */
  function partsAt(program, surfaces, events, image, exact) {
    const isNear = (channel) => Math.abs(image.color[channel] - exact.color[channel]) < ROUNDING;
    const inOrder = image.from && exact.order.every((number, at) => image.from[at] === number);
    if ([0, 1, 2].every(isNear) && (isNear(3) || inOrder)) return null;
    // Each surface's place among all, and that of the last transparent one that is seen.
    const places = [];
    sorted(surfaces).forEach(({ order }, place) => (places[order] = place));
    const farthest = Math.max(-1, ...exact.order.filter((number) => surfaces[number].group !== "opaque").map((number) => places[number]));
    const isBad = (name, { from, how }) => {
      if (how === "mixed") return true;
      if (!from || from.length === 0) return false;
      const are = from.map((number) => places[number]);
      if (are.some((place, at) => at > 0 && place !== are[at - 1] + 1)) return true;
      // Dual peeling gathers each farthest layer by itself.
      if (how === "under" && name !== "farthest") return are[0] !== 0;
      return how === "over" && last(are) < farthest;
    };
    const first = events.findIndex(({ maps, composited, lists }) => {
      const list = composited ?? lists?.composited;
      if (program.on !== "calls") return list?.some((number, at) => number !== exact.order[at]);
      return Object.entries(maps).some(([name, texel]) => texel.how && isBad(name, texel));
    });
    return first < 0 ? events.length - 1 : first;
  }

  return { run, words };
})();
if (typeof module !== "undefined") module.exports = onionskin;
