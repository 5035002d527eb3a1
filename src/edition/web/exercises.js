// When the exercises of exercises.json are solved. Each gets the player, whose run is that of the pixel as it is now.
"use strict";

onionskin.exercises = (() => {
  const isPrinted = (p) => !p.given.readings.includes("amended");
  const isUnchanged = (p) => p.changed.length === 0;
  /** What belongs in the image and is not in it. */
  const lost = (p) => p.run.exact.order.filter((it) => !p.run.composited.includes(it) && p.surfaces[it].group !== "opaque");
  const transparent = (p) => p.surfaces.filter((it) => it.group !== "opaque");
  const hasTie = (p) => new Set(transparent(p).map((it) => it.depth)).size < transparent(p).length;
  const losesTie = (p) => hasTie(p) && lost(p).length > 0;
  const names = (p) => p.surfaces.map((it) => it.name).join();
  const isMarked = (p) => p.run.events.some((it) => Object.values(it.maps).some((texel) => texel.stencil > 0));
  const inversions = (run) => run.events.flatMap((it) => it.fates ?? []).filter(({ stencil: [before, after] }) => after === 255 - before).length;
  const madeOf = (event) => Object.values(event.maps).filter((it) => it.how !== "data").map((it) => it.from ?? []);
  const depthOf = (p, name) => p.surfaces.find((it) => it.name === name)?.depth;

  return {
    "everitt-third-layer": (p) => Boolean(p.event?.fates) && madeOf(p.event).some((it) => it.length === 1 && it[0] === p.run.exact.order[2]),
    "everitt-tie": (p) => isUnchanged(p) && losesTie(p),
    "everitt-less": (p) => p.changed.length === 1 && p.run.parts !== null && p.run.composited.length > 0 && p.run.composited[0] !== p.run.exact.order[0],
    "vtk-peels": (p) => isUnchanged(p) && lost(p).length > 0 && !hasTie(p),
    "vtk-cull": (p) => isUnchanged(p) && p.run.passes < p.first.passes && p.surfaces.length >= p.scene.surfaces.length && p.run.parts === null,
    "vtk-under": (p) => p.changed.length === 1 && p.stepAt(p.changed[0].path).name.startsWith("glBlend") && p.run.parts !== null,
    "dual-middle": (p) => isUnchanged(p) && transparent(p).length > p.scene.surfaces.length && transparent(p).length % 2 === 1,
    "dual-tie": (p) => isUnchanged(p) && hasTie(p),
    "proof-fails": isMarked,
    "proof-holds-again": (p) => p.solved.has("proof-fails") && !isMarked(p) && p.surfaces.length >= p.scene.surfaces.length && names(p) !== p.first.names,
    "tie-with-a-peel": (p) => isPrinted(p) && losesTie(p),
    "opaque-ends-early": (p) => p.run.passes < p.first.passes && p.surfaces.length === p.scene.surfaces.length && p.run.parts === null,
    "pass-3-inverts": (p) => isUnchanged(p) && inversions(p.run) > p.first.inversions,
    "s9-before-s3": (p) => depthOf(p, "s9") < depthOf(p, "s3"),
    "longer-run": (p) => isUnchanged(p) && p.run.passes < p.first.passes && names(p) === p.first.names,
    "two-are-right": (p) => isPrinted(p) && p.surfaces.length > 1 && p.run.parts === null,
    "three-are-wrong": (p) => p.solved.has("two-are-right") && isPrinted(p) && p.run.parts !== null,
    "reversed": (p) => names(p) === p.first.names.split(",").reverse().join(),
    "printed-again": (p) => isPrinted(p) && p.run.parts === null,
    "drop-what-pp-dp-keeps": (p) => lost(p).length > 0 && p.run.lists.passes.some((it) => it.dropped.length > 0),
    "past-the-last-segment": (p) => isPrinted(p) && p.run.lists.list.length > p.array,
    "lose-a-tie": (p) => isPrinted(p) && losesTie(p),
    "save-the-tie": (p) => p.solved.has("lose-a-tie") && isPrinted(p) && hasTie(p) && lost(p).length === 0,
    "at-depth-0": (p) => isPrinted(p) && lost(p).some((it) => p.surfaces[it].depth === 0),
    /** What is remembered of the first run. */
    first: (p) => ({ passes: p.run.passes, names: names(p), inversions: inversions(p.run) }),
  };
})();
