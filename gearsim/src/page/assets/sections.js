// Sections that show many runs in turn. Plots with the same curves keep their view; everything else is replaced.

const panels = [];
// The prefix of the identifiers of the arrays of each section. Arrays with other prefixes are deleted.
const names = new Map();
let drawings = [];
// By default plotly.js looks for labels that are cut off, which takes a quarter of the time of drawing.
Panel.axis = { ticklabeloverflow: "allow" };

/** The title, the unit and the names of the curves of a plot, as one text. A plot with the same text is kept. */
const subject = (plot) => [plot.title, plot.y.unit, plot.y.log, ...plot.curves.map((curve) => curve.name)].join("\n");

/** The identifiers of the sections on the screen. */
function inSight(main) {
  const seen = [...main.children].filter((section) => onScreen({ figure: section }));
  return seen.length ? seen.map(({ id }) => id) : ["motion"];
}

/** The visible part of the plots, for an answer with only this part; null if no plot is visible. */
function inView() {
  const seen = panels.filter((panel) => panel.drawn && onScreen(panel));
  if (seen.length === 0) return null;
  // The common limits of spectra over frequency depend on all spectra.
  const wanted = panels.filter((panel) => seen.includes(panel) || panel.plot.group === "frequency");
  const curves = wanted.flatMap(({ plot, shown }) => plot.curves.filter((_, i) => shown[i]).map(({ name }) => [plot.title, name]));
  const { range, first } = seen.find(({ plot }) => plot.group === "time")?.group ?? {};
  // The next run may have another length. If the whole of this run is in view, the whole of the next run is requested.
  const whole = !range || (range[0] === first[0] && range[1] === first[1]);
  const tables = [...document.querySelectorAll("main table")].filter((table) => onScreen({ figure: table }));
  const captions = tables.map((table) => table.caption?.textContent ?? "");
  return { range: whole ? null : range, parts: Math.max(...seen.map((panel) => panel.pixels())), curves, tables: captions };
}

/**
 * Shows the sections `of` a run in place of those of the run before. `order` has the identifiers of all sections from top to bottom. The
 * identifiers of the arrays begin with `name`.
 */
function showSections(main, { order, of, html, arrays }, name) {
  of.forEach((id) => names.set(id, name));
  const used = new Set(names.values());
  for (const known of [received, decoded]) for (const id of known.keys()) if (!used.has(id.slice(0, id.indexOf("-") + 1))) known.delete(id);
  for (const [id, base64] of Object.entries(arrays)) received.set(id, base64);
  const fresh = element("template");
  fresh.innerHTML = html;
  const sections = [...fresh.content.children];
  const known = (id) => [...main.children].find((section) => section.id === id);
  of.filter((id) => !sections.some((section) => section.id === id)).forEach((id) => known(id)?.remove());
  for (const section of sections) {
    const old = known(section.id);
    const place = order.indexOf(section.id);
    if (old) renew(old, section);
    else main.insertBefore(section, [...main.children].find(({ id }) => order.indexOf(id) > place) ?? null);
  }
  const own = of.map(known).filter((section) => section);
  leave();
  for (const section of own) {
    for (const figure of section.querySelectorAll("figure.plot")) {
      if (!panels.some((panel) => panel.figure === figure)) panels.push(new Panel(figure));
    }
    section.querySelectorAll("table.sortable").forEach((table) => { if (!table.dataset.sorts) { sortable(table); table.dataset.sorts = "1"; } });
  }
  for (const group of groups.values()) regroup(group);
  bars(main);
  drawings.filter(({ figure }) => !figure.isConnected).forEach((gone) => gone.leave());
  drawings = [...main.querySelectorAll("figure.gears")].map((figure) => drawings.find((drawing) => drawing.figure === figure) ?? new Gears(figure));
  drawAll(panels.filter(({ figure, part }) => part > Panel.part || own.some((section) => section.contains(figure))));
}

// Largest error of the ends of an axis while a run changes [relative to its length]. When the run no longer changes, they are exact.
const OFF = 0.1;

Panel.sketch = (panel, traces, look) => Panel.part === COARSE && alike(panel, look) && sketch(panel.canvas, traces);

/** Whether a plot looks as it is drawn now, except for less than a pixel along x and a small part of the range of y. */
function alike(panel, look) {
  if (look === panel.look) return true;
  const looks = [look, panel.look].map((text) => JSON.parse(text));
  const [form, formBefore] = looks.map((look) => JSON.stringify(look, (key, value) => ["range", "x", "x0", "x1"].includes(key) ? undefined : value));
  if (form !== formBefore) return false;
  const near = (now, before, apart) => now.every((x, i) => Math.abs(x - before[i]) <= apart);
  const [along, alongBefore] = looks.map(({ layout: { xaxis, shapes, annotations } }) => [
    ...xaxis.range, ...shapes.flatMap(({ x0, x1 }) => [x0, x1]), ...annotations.map(({ x }) => x),
  ]);
  const [up, upBefore] = looks.map(({ layout }) => layout.yaxis.range ?? [0, 0]);
  return near(along, alongBefore, (along[1] - along[0]) / panel.pixels()) && near(up, upBefore, OFF * (upBefore[1] - upBefore[0]));
}

/**
 * Gives the lines of a plot new points, and their markers new places, if its axes suit them. Returns whether it did. plotly.js would take
 * ten times as long.
 */
function sketch(canvas, traces) {
  const { xaxis, yaxis, yaxis2 } = canvas._fullLayout;
  const paths = canvas.querySelectorAll(".scatterlayer path.js-line");
  const lines = traces.every(({ mode }) => mode.startsWith("lines")) && paths.length === traces.length;
  if (!lines || !suits(yaxis, traces.filter((trace) => !trace.yaxis))) return false;
  const places = traces.map(({ x, y, yaxis: name }) => x.map((x, i) => [xaxis.d2p(x), (name ? yaxis2 : yaxis).d2p(y[i])]));
  const markers = traces.map(({ mode }, i) => mode === "lines" ? [] : [...paths[i].closest(".trace").querySelectorAll(".points path.point")]);
  const marked = places.map((places, i) => traces[i].mode === "lines" ? [] : places.filter(([, down]) => Number.isFinite(down)));
  if (markers.some((markers, i) => markers.length !== marked[i].length)) return false;
  traces.forEach((_, i) => {
    paths[i].setAttribute("d", curvePath(places[i]));
    markers[i].forEach((marker, j) => marker.setAttribute("transform", `translate(${marked[i][j]})`));
  });
  return true;
}

/** Whether an axis shows all of some curves, and they take at least half of it. A fixed axis always suits. */
function suits(axis, traces) {
  if (!axis.autorange) return true;
  let [low, high] = [Infinity, -Infinity];
  for (const { y } of traces) for (const value of y) { if (value < low) low = value; if (value > high) high = value; }
  const [bottom, top] = axis.range.map((value) => axis.r2c(value));
  return low >= bottom && high <= top && high - low >= 0.5 * (top - bottom);
}

/** The path of a curve through some places on the screen. */
function curvePath(places) {
  let path = "", pen = "M";
  for (const [right, down] of places) {
    if (!Number.isFinite(down)) { pen = "M"; continue; }
    path += `${pen}${right.toFixed(1)},${down.toFixed(1)}`;
    pen = "L";
  }
  return path;
}

const onScreen = ({ figure }) => {
  const { top, bottom } = figure.getBoundingClientRect();
  return bottom > 0 && top < innerHeight;
};

// Pause [ms] before a plot that is not visible is drawn. The browser uses it to paint and to handle input.
const PAUSE = 50;
let turn = null;

/** Of the plots `some`, draws those on the screen at once, and those near the screen later, one after the other. */
function drawAll(some) {
  const near = some.map((panel) => [panel, onScreen(panel)]);
  near.filter(([, here]) => here).forEach(([panel]) => panel.draw());
  for (const [panel] of near.filter(([, here]) => !here)) {
    panel.stale = true;
    panel.frame.hidden = !panel.shown.some((shown) => shown);
  }
  const later = near.filter(([panel, here]) => !here && panel.inSight).map(([panel]) => panel);
  clearTimeout(turn);
  const next = () => {
    const panel = later.shift();
    if (!panel) return;
    if (panel.stale && panel.figure.isConnected) panel.draw();
    turn = setTimeout(next, PAUSE);
  };
  turn = setTimeout(next, PAUSE);
}

/** Gives a section the content of a new one. Plots with the same `subject` stay where they are, and get the new curves. */
function renew(old, section) {
  const open = new Set([...old.querySelectorAll(":scope > details[open] > summary")].map((summary) => summary.textContent));
  const known = panels.filter(({ figure }) => old.contains(figure));
  const wanted = [...section.children].map((child) => {
    // A table that is not visible comes with the next answer; until then the old table stays.
    if (child.dataset.later) return [...old.children].find((known) => known.querySelector("caption")?.textContent === child.dataset.later) ?? child;
    if (child.matches("details")) child.open = open.has(child.querySelector("summary").textContent);
    if (!child.matches("figure.plot")) return child;
    const plot = JSON.parse(child.querySelector("script").textContent);
    const panel = known.find((panel) => subject(panel.plot) === subject(plot));
    if (!panel) return child;
    panel.plot = plot;
    return panel.figure;
  });
  [...old.children].filter((child) => !wanted.includes(child) && !child.matches(".bar")).forEach((child) => child.remove());
  let place = old.firstChild;
  for (const child of wanted) {
    while (place && (place.nodeType !== 1 || place.matches(".bar"))) place = place.nextSibling;
    if (place === child) place = place.nextSibling; else old.insertBefore(child, place);
  }
}

/** Forgets the plots that are gone. */
function leave() {
  const gone = panels.filter((panel) => !panel.figure.isConnected);
  for (const panel of gone) {
    panels.splice(panels.indexOf(panel), 1);
    panel.group.panels = panel.group.panels.filter((other) => other !== panel);
    if (panel.drawn) Plotly.purge(panel.canvas);
  }
  for (const [name, group] of groups) if (group.panels.length === 0) groups.delete(name);
}

/** Finds the limits of a group again. A view that a reader chose is kept as far as there are data. */
function regroup(group) {
  const [range, first] = [group.range, group.first];
  group.begin();
  group.first = [...group.range];
  const chosen = range && first && (range[0] !== first[0] || range[1] !== first[1]);
  if (chosen && range[0] < group.all[1] && range[1] > group.all[0]) {
    group.range = [Math.max(range[0], group.all[0]), Math.min(range[1], group.all[1])];
  }
  if (!range || range[0] !== group.range[0] || range[1] !== group.range[1]) group.revision++;
}

/** One bar per group in each section, before the first plot of the group there. */
function bars(main) {
  for (const section of main.children) {
    const before = new Map();
    for (const figure of section.querySelectorAll(":scope > figure.plot")) {
      const { group } = panels.find((panel) => panel.figure === figure);
      if (!before.has(group)) before.set(group, figure);
    }
    const old = [...section.querySelectorAll(":scope > .bar")];
    const right = old.length === before.size && [...before.values()].every((figure) => figure.previousElementSibling?.matches(".bar"));
    if (!right) {
      old.forEach((bar) => bar.remove());
      for (const [group, figure] of before) figure.before(group.bar());
    }
  }
  for (const group of groups.values()) {
    group.bars = group.bars.filter((bar) => bar.isConnected);
    group.tell();
  }
}
