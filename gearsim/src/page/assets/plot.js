// A plot: its check boxes, its curves and its cursor. Drawn by plotly.js when it is first in sight.

// Units that a reader may choose instead of the SI unit, with their factors. Those before null are chosen by the size of the numbers.
const UNITS = {
  "rad/s": [["rad/s", 1], null, ["rpm", 30 / Math.PI], ["deg/s", 180 / Math.PI]],
  "rad": [["rad", 1], ["mrad", 1e3], ["µrad", 1e6], null, ["deg", 180 / Math.PI]],
  "m": [["m", 1], ["mm", 1e3], ["µm", 1e6]],
  "m/s": [["m/s", 1], ["mm/s", 1e3], ["µm/s", 1e6]],
  "N": [["N", 1], ["kN", 1e-3], ["MN", 1e-6]],
  "N*m": [["N*m", 1], ["kN*m", 1e-3], ["MN*m", 1e-6]],
  "W": [["W", 1], ["kW", 1e-3], ["MW", 1e-6]],
  "J": [["J", 1], ["mJ", 1e3], ["kJ", 1e-3], ["MJ", 1e-6]],
};

/** The unit in which the number `largest` (SI) is from 1 to 1000; else the SI unit. */
function suitable(units, largest) {
  const end = units.indexOf(null);
  const sized = end < 0 ? units : units.slice(0, end);
  return sized.find(([, factor]) => factor * largest >= 1 && factor * largest < 1000) ?? units[0];
}

// Dashes of the curves, so that they differ without colours too.
const DASHES = ["solid", "7px,3px", "2px,4px", "8px,3px,2px,3px", "12px,4px"];
const COLOURS = 7;
// While a view or a run changes, curves are reduced to parts of this many pixels. plotly.js then takes half the time.
const COARSE = 4;
// Labels of vertical lines: their font, the height of a row of them [px], and most rows.
const LABELS = { font: 11, row: 14, rows: 4 };
// Height of the frames, and of the space above and below them [px].
const HEIGHT = 196, TOP = 10, BOTTOM = 44;
// Most height of the frame of a plot whose axes have the same scale.
const SQUARE = 420;
// Size of the numbers and names at the axes, and of their titles.
const FONT = 12, TITLE = 14;
// Least width of an upright name along x [px].
const UPRIGHT = 18;
// Screens narrower than this [px] are those of phones.
const NARROW = 600;
// Width left of the frames, the same for all plots so that their times stand below each other.
const MARGIN = 78;
// Width right of them: half of a number of five digits, which stands below the end of a frame.
const RIGHT = 20;

/** `text` with the content of `_{...}` as a subscript, in the HTML that plotly.js reads. */
const formula = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replace(/_\{([^}]*)\}/g, "<sub>$1</sub>");
/** The same as elements of the page. */
const formulaElements = (text) => text.split(/_\{([^}]*)\}/).map((part, i) => i % 2 ? element("sub", { textContent: part }) : part);

const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
/** The CSS colour of a style. A number stands for one of the colours of curves of the page. */
const colour = (which) => typeof which === "number" ? css(`--curve-${which % COLOURS}`) : which;
/** The default style of the i-th curve. */
const styleOf = (i) => ({ colour: i % COLOURS, dash: DASHES[i % DASHES.length], width: i === 0 ? 1.7 : 1.3, marker: null });

// Outlines of the markers, about the middle of a field of 22 by 10 pixels.
const OUTLINES = {
  "circle": "M7.5 5a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0Z", "square": "M7.8 1.8h6.4v6.4h-6.4Z", "diamond": "M11 0.5l4.5 4.5l-4.5 4.5l-4.5 -4.5Z",
  "triangle-up": "M11 0.8l4.4 7.6h-8.8Z", "x-thin-open": "M7.8 1.8l6.4 6.4m0 -6.4l-6.4 6.4",
};

/** A sample of a curve as SVG: its line and its marker; only the marker if the curve has no line. */
function pattern({ colour, dash, width, marker }) {
  const ink = typeof colour === "number" ? `var(--curve-${colour % COLOURS})` : colour;
  const dashes = dash === "solid" ? "none" : dash.replaceAll("px", "");
  const line = width > 0 ? `<line x1="0" y1="5" x2="22" y2="5" style="stroke: ${ink}; stroke-dasharray: ${dashes}"/>` : "";
  const outline = marker ? `<path d="${OUTLINES[marker]}" style="fill: ${ink}; stroke: ${ink}"/>` : "";
  return `<svg width="22" height="10" aria-hidden="true">${line}${outline}</svg>`;
}

/** A number with five digits. */
function short(x) {
  if (!Number.isFinite(x)) return "-";
  const size = Math.abs(x);
  return size === 0 || (size >= 1e-3 && size < 1e6) ? String(Number(x.toPrecision(5))) : x.toExponential(4);
}

/** The width of a text in the font of the page [px]. */
function textWidth(text, size) {
  textWidth.context ??= document.createElement("canvas").getContext("2d");
  textWidth.context.font = `${size}px ${getComputedStyle(document.body).fontFamily}`;
  return textWidth.context.measureText(text).width;
}

/** Places at least `gap` apart, near the `wanted` ones, which are in ascending order, and between `low` and `high` if they fit there. */
function apart(wanted, gap, low, high) {
  const places = [];
  for (const at of wanted) places.push(Math.max(at, places.length ? places.at(-1) + gap : low));
  for (let i = places.length - 1; i >= 0; i--) places[i] = Math.min(places[i], i + 1 < places.length ? places[i + 1] - gap : high);
  return places;
}

/** A new element with attributes or properties, and children. */
function element(name, properties = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (key in made) made[key] = value; else made.setAttribute(key, value);
  }
  made.append(...children);
  return made;
}

class Panel {
  /** Further settings of axes. */
  static axis = {};
  /** Width [px] of the parts in each of which a curve has its lowest and its highest value. */
  static part = 1;
  /** End of the axes over time while the beginning of a run is shown. */
  static until = -Infinity;
  /** Draws the curves of a plot without plotly.js if it looks almost as before. Returns whether it did. */
  static sketch = () => false;

  constructor(figure) {
    this.figure = figure;
    this.plot = JSON.parse(figure.querySelector("script").textContent);
    this.shown = this.plot.curves.map((curve) => curve.shown);
    this.styles = this.plot.curves.map((curve, i) => curve.style ?? styleOf(i));
    this.factor = 1;
    this.unit = this.plot.y.unit;
    this.inSight = false;
    this.yRevision = 0;
    this.group = Group.of(this);
    this.build();
  }

  /** The limits of all its abscissae. */
  limits() {
    const ends = this.plot.curves.map((curve) => column(curve.x).values).filter((x) => x.length > 0);
    const until = this.plot.group === "time" ? Panel.until : -Infinity;
    return [Math.min(...ends.map((x) => x[0])), Math.max(until, ...ends.map((x) => x[x.length - 1]))];
  }

  build() {
    const caption = this.figure.querySelector("figcaption");
    this.values = [];
    // Up to two descriptions stand beside their curves; more are in a list that opens.
    const inline = this.plot.curves.length <= 2;
    const boxes = this.plot.curves.map((curve, i) => {
      if (!curve.name) return null;
      const box = element("input", { type: "checkbox", checked: this.shown[i] });
      box.addEventListener("change", () => {
        this.plot.curves.forEach((other, j) => { if (j === i || other.with === i) this.shown[j] = box.checked; });
        this.draw();
      });
      const value = element("output", { className: "value" });
      this.values[i] = value;
      const swatch = element("span", { className: "swatch", innerHTML: pattern(this.styles[i]) });
      const name = element("span", { className: "name" }, ...formulaElements(curve.name));
      const doc = element("span", { className: "doc", textContent: inline ? curve.doc : "" });
      return element("label", { title: curve.doc }, box, swatch, name, value, doc);
    }).filter((label) => label);
    const head = element("div", { className: "head" }, caption);
    this.units = UNITS[this.unit] ?? [];
    if (this.units.length > 1) head.append(this.unitMenu());
    const doc = this.plot.curves.filter((curve) => curve.doc && !inline).map((curve) => `${curve.name}: ${curve.doc}`).join("\n");
    const key = element("div", { className: "curves", role: "group", ariaLabel: `Curves of ${caption.textContent}` }, ...boxes);
    this.frame = element("div", {
      className: "frame", tabIndex: 0, role: "group",
      ariaLabel: `${caption.textContent}. Arrow keys move the cursor, plus and minus zoom, 0 shows all.`,
    });
    this.canvas = element("div", { className: "canvas" });
    // Names along x need a width each; a narrow screen scrolls.
    const names = this.plot.x.names?.length ?? 0;
    if (names) {
      this.canvas.style.minWidth = `${names * UPRIGHT + MARGIN + RIGHT}px`;
      this.frame.style.overflow = "auto hidden";
    }
    this.line = element("div", { className: "cursor", hidden: true });
    this.frame.append(this.canvas, this.line);
    this.figure.append(head, key, this.frame);
    if (doc) this.figure.append(element("details", { className: "meaning" }, element("summary", { textContent: "What the curves are" }), element("pre", { textContent: doc })));
    this.listen();
  }

  unitMenu() {
    this.menu = element("select", { ariaLabel: `Unit of ${this.plot.title}` });
    for (const unit of this.units) if (unit) this.menu.append(element("option", { textContent: unit[0] }));
    this.menu.addEventListener("change", () => {
      this.choose(this.units.find((unit) => unit?.[0] === this.menu.value));
      this.draw();
    });
    return this.menu;
  }

  /** Selects a unit of the menu. */
  choose([name, factor]) {
    [this.unit, this.factor] = [name, factor];
    this.menu.value = name;
    this.yRevision++;
  }

  /** Selects the unit that suits the curves that are drawn. */
  suit() {
    let largest = 0;
    this.plot.curves.filter((_, i) => this.shown[i]).forEach((curve) => {
      const y = column(curve.y);
      if (y.values.length === 0) return;
      const size = (value) => this.plot.y.log ? 10 ** value : Math.abs(value);
      extremes(y, 0, y.values.length).forEach((i) => { largest = Math.max(largest, size(y.values[i]) || 0); });
    });
    const usual = this.units.find((unit) => unit && unit[0] === this.plot.y.usual);
    this.choose(usual ?? suitable(this.units, largest));
  }

  listen() {
    const place = (event) => {
      const axis = this.canvas._fullLayout?.xaxis;
      if (!axis) return;
      const x = event.clientX - this.canvas.getBoundingClientRect().left - axis._offset;
      if (x >= 0 && x <= axis._length) this.group.point(axis.p2r(x));
    };
    this.frame.addEventListener("pointermove", place);
    this.frame.addEventListener("pointerdown", place);
    this.frame.addEventListener("keydown", (event) => this.group.key(event));
    new IntersectionObserver((entries) => {
      this.inSight = entries.some((entry) => entry.isIntersecting);
      if (this.inSight && this.stale) this.draw();
    }, { rootMargin: "200px" }).observe(this.figure);
  }

  /** Draws the part of its curves that the group shows; later, if it is out of sight. */
  draw() {
    this.stale = !this.inSight;
    this.frame.hidden = !this.shown.some((shown) => shown);
    if (this.menu) this.menu.hidden = this.frame.hidden;
    if (this.stale || this.frame.hidden) return;
    // Curves that were not visible when the run was requested have no values yet. They follow in a second answer.
    this.stale = this.plot.curves.some((curve, i) => this.shown[i] && curve.y.length < curve.x.length);
    if (this.stale) return;
    this.part = Panel.part;
    if (this.menu && !this.drawn) this.suit();
    const range = this.group.range;
    const pixels = this.pixels();
    const traces = this.plot.curves.map((curve, i) => this.trace(curve, i, range, pixels)).filter((trace) => trace);
    traces.push(...this.events(range, pixels / Panel.part));
    const layout = this.layout(range);
    const look = JSON.stringify({ layout, styles: traces.map(({ x, y, ...rest }) => rest) });
    if (this.look && Panel.sketch(this, traces, look)) return this.mark();
    // New points in a plot that looks the same take half the time of a new plot.
    const done = look === this.look
      ? Plotly.restyle(this.canvas, { x: traces.map(({ x }) => x), y: traces.map(({ y }) => y) })
      : Plotly.react(this.canvas, traces, layout, { ...settings, displayModeBar: touch() ? false : "hover" });
    this.look = look;
    if (!this.drawn) {
      this.drawn = true;
      done.then(() => this.follow());
    }
    this.mark();
  }

  /** Width of the plot. */
  pixels() { return Math.max(100, Math.round(this.canvas.clientWidth - MARGIN - this.right())); }

  /** A value of a column in the chosen unit. */
  shownAs(value) { return this.factor * (this.plot.y.log ? 10 ** value : value); }

  trace(curve, i, [from, to], pixels) {
    if (!this.shown[i]) return null;
    const points = visible(column(curve.x), column(curve.y), from, to, Math.ceil(pixels / Panel.part));
    const y = points.y.map((value) => this.shownAs(value));
    const x = this.plot.x.log ? points.x.map((value) => 10 ** value) : points.x;
    const style = this.styles[i];
    const few = !curve.style && points.all && points.rows < pixels / 8;
    const mode = [style.width > 0 && "lines", (few || style.marker) && "markers"].filter((part) => part).join("+") || "none";
    const line = { color: colour(style.colour), dash: style.dash, width: style.width, simplify: false };
    const marker = style.marker ? { symbol: style.marker, size: 7, color: line.color, line: { color: line.color, width: 1.5 } } : { size: 4 };
    // Markers at the ends of the frame are whole.
    return { x, y, name: formula(curve.name), mode, marker, line, cliponaxis: !style.marker, hoverinfo: "skip" };
  }

  /** The texts at the last points of curves, placed as in notes.rs. */
  notes() {
    const noted = this.plot.curves.map((curve, i) => [curve, i]).filter(([{ note }, i]) => note && this.shown[i]).map(([curve, i]) => {
      const [x, y] = [column(curve.x).values.at(-1), column(curve.y).values.at(-1)];
      const ink = colour(this.styles[i].colour);
      const look = { x, y: this.plot.y.log ? y + Math.log10(this.factor) : this.factor * y, text: formula(curve.note.text), showarrow: false, borderpad: 0, font: { size: LABELS.font, color: ink } };
      return { place: curve.note.place, look, x, y, ink };
    });
    const placed = (place, of) => noted.filter((note) => note.place === place).sort((one, two) => of(one) - of(two));
    const leader = (ink) => ({ showarrow: true, arrowhead: 0, arrowwidth: 0.7, arrowcolor: ink });
    // Pixels from the lower left corner of the frame.
    const [low, high] = this.plot.y.range ?? [0, 1];
    const up = ({ y }) => (y - low) / (high - low) * this.height();
    const right = ({ x }) => (x - this.group.all[0]) / (this.group.all[1] - this.group.all[0]) * this.pixels();
    const fits = (note) => right(note) > textWidth(note.look.text, LABELS.font);
    const before = placed("before", up);
    const levels = apart(before.map(up), LABELS.row, 0, this.height() - LABELS.row);
    const after = placed("after", up);
    const rows = apart(after.map(up), LABELS.row, LABELS.row / 2, this.height());
    const above = placed("above", right);
    const width = Math.max(...above.map(({ look }) => textWidth(look.text, LABELS.font))) + 8;
    const columns = apart(above.map(right), width, width / 2, this.pixels());
    return [
      ...before.map((note, i) => ({ ...note.look, xanchor: fits(note) ? "right" : "left", yanchor: "bottom", yshift: levels[i] - up(note), bgcolor: css("--ground"), opacity: 0.85 })),
      ...after.map((note, i) => ({ ...note.look, ...leader(note.ink), xanchor: "left", ax: 12, ay: up(note) - rows[i] })),
      ...above.map((note, i) => ({ ...note.look, ...leader(note.ink), yanchor: "bottom", ax: columns[i] - right(note), ay: -6 })),
    ];
  }

  /** Height of the frame: more where many notes stand one above the other. */
  height() {
    if (this.plot.square) return Math.min(SQUARE, this.pixels());
    const before = this.plot.curves.filter(({ note }) => note?.place === "before").length;
    return Math.max(HEIGHT, 2 * LABELS.row * Math.max(before, this.after().length));
  }

  /** The middle part of the width, as wide as the frame is high [relative to the width]. */
  middle() {
    const half = this.height() / this.pixels() / 2;
    return [0.5 - half, 0.5 + half];
  }

  /** The curves with a note to their right. */
  after() { return this.plot.curves.filter(({ note }) => note?.place === "after"); }

  /** Width right of the frame: more where notes stand there on a narrow screen. */
  right() { return this.canvas.clientWidth < NARROW && this.after().length > 0 ? 40 : RIGHT; }

  /** The title of the abscissae, in lines that are no wider than the frame. */
  titleLines(text) {
    const lines = [""];
    for (const word of text.split(" ")) {
      const longer = `${lines.at(-1)} ${word}`.trim();
      if (textWidth(longer, TITLE) > this.pixels() && lines.at(-1)) lines.push(word); else lines[lines.length - 1] = longer;
    }
    return lines;
  }

  /** The height [px] of the names along x if they stand upright, because they would cover each other side by side; 0 if they do not. */
  upright() {
    const widest = Math.max(0, ...(this.plot.x.names ?? []).map((name) => textWidth(name.replace(/_\{([^}]*)\}/g, "$1"), FONT)));
    return (widest + 8) * this.plot.x.names?.length > this.pixels() ? widest : 0;
  }

  /** The labels of vertical lines on a linear axis. Each label is right of its line, or left of it at the end of the frame, in the first
   * row in which it covers no other label. If there is no such row, the line has no label; the table below has its number. */
  labels(lines, [from, to]) {
    const pixels = this.pixels();
    const rows = Array.from({ length: LABELS.rows }, () => []);
    return [...lines].sort((one, two) => one.x - two.x).map(({ x, name }) => {
      const at = (x - from) / (to - from) * pixels;
      const width = textWidth(name, LABELS.font) + 6;
      const left = at + width > pixels;
      const [begin, end] = left ? [at - width, at] : [at, at + width];
      const row = rows.findIndex((taken) => taken.every(([first, last]) => end <= first || begin >= last));
      if (row < 0) return null;
      rows[row].push([begin, end]);
      return {
        x, y: 1, yref: "paper", yshift: -LABELS.row * row, xanchor: left ? "right" : "left", yanchor: "top", text: formula(name), showarrow: false,
        borderpad: 0, bgcolor: css("--ground"), opacity: 0.85, font: { size: LABELS.font, color: css("--muted") },
      };
    }).filter((label) => label);
  }

  /** The marks of events, at most one per pixel. They are a single line that runs below the plot from mark to mark: it is drawn faster. */
  events([from, to], pixels) {
    if (!this.plot.events) return [];
    const t = column(this.plot.events).values;
    const x = [], y = [];
    for (let i = lowerBound(t, from); i < t.length && t[i] <= to;) {
      x.push(t[i], t[i], t[i]);
      y.push(-0.1, 0.04, -0.1);
      i = Math.max(i + 1, lowerBound(t, t[i] + (to - from) / pixels));
    }
    if (x.length === 0) return [];
    const line = { color: css("--muted"), width: 1, simplify: false };
    return [{ x, y, yaxis: "y2", mode: "lines", line, hoverinfo: "skip", name: "events" }];
  }

  layout(range) {
    const [grid, ink] = [css("--grid"), css("--text")];
    const names = (names) => names?.length ? { tickvals: names.map((_, i) => i), ticktext: names.map(formula) } : {};
    const axis = { gridcolor: grid, linecolor: grid, zerolinecolor: grid, exponentformat: "power", minexponent: 4, ticks: "outside", tickcolor: grid, ...Panel.axis };
    const titled = (text, unit) => unit && unit !== "1" ? `${text} [${unit}]`.trim() : text;
    const words = this.titleLines(titled(this.plot.x.label, this.plot.x.unit));
    const below = this.upright() + TITLE * 1.3 * (words.length - 1);
    const title = (lines) => ({ text: lines.map(formula).join("<br>"), standoff: 6, font: { size: TITLE } });
    const y = { ...axis, title: title([titled(this.plot.y.label, this.unit)]), uirevision: this.yRevision };
    const logarithmic = { type: "log", dtick: undefined, nticks: 7, exponentformat: "power", minexponent: 2 };
    if (this.plot.y.log) Object.assign(y, logarithmic);
    if (this.plot.y.range) y.range = this.plot.y.range.map((value) => this.plot.y.log ? Math.log10(this.factor * value) : this.factor * value);
    if (this.plot.square) {
      // A zoom of x also zooms y, about the middle of y.
      const [low, high] = this.plot.y.range;
      const half = (high - low) / 2 * (range[1] - range[0]) / (this.group.all[1] - this.group.all[0]);
      Object.assign(y, { range: [(low + high) / 2 - half, (low + high) / 2 + half], uirevision: this.group.revision });
    }
    const line = ({ x }) => ({ type: "line", x0: x, x1: x, y0: 0, y1: 1, yref: "paper", line: { color: css("--muted"), width: 1, dash: "dot" } });
    const data = (x) => this.plot.x.log ? 10 ** x : x;
    const lines = this.plot.lines.filter(({ x }) => x > range[0] && x < range[1]);
    const shapes = lines.map(line);
    if (this.plot.shaded_from !== null) {
      shapes.push({ type: "rect", x0: this.plot.shaded_from, x1: data(this.group.all[1]), y0: 0, y1: 1, yref: "paper", line: { width: 0 }, fillcolor: css("--muted"), opacity: 0.15, layer: "below" });
    }
    return {
      margin: { l: MARGIN, r: this.right(), t: TOP, b: BOTTOM + below }, height: TOP + this.height() + BOTTOM + below, showlegend: false, hovermode: false, shapes, annotations: [...this.notes(), ...this.labels(lines, range)],
      dragmode: touch() ? false : "zoom", paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: "rgba(0,0,0,0)",
      font: { family: getComputedStyle(document.body).fontFamily, size: FONT, color: ink },
      modebar: { bgcolor: "rgba(0,0,0,0)", color: css("--muted"), activecolor: ink },
      xaxis: { ...axis, ...(this.plot.x.log ? logarithmic : {}), ...names(this.plot.x.names), ...(this.upright() ? { tickangle: 90 } : {}), range: [...range], ...(this.plot.square ? { domain: this.middle() } : {}), title: title(words), fixedrange: touch(), uirevision: this.group.revision },
      yaxis: { ...y, fixedrange: touch() },
      yaxis2: { overlaying: "y", range: [0, 1], fixedrange: true, visible: false },
    };
  }

  /** Follows zooms that begin in this plot. */
  follow() {
    const follow = (change) => {
      const [from, to] = change["xaxis.range"] ?? [change["xaxis.range[0]"], change["xaxis.range[1]"]];
      if (Number.isFinite(from) && Number.isFinite(to)) this.group.show(from, to);
    };
    this.canvas.on("plotly_relayout", follow);
    this.canvas.on("plotly_doubleclick", () => this.group.reset());
  }

  /** Shows the cursor and the values there. */
  mark() {
    const x = this.group.cursor;
    const axis = this.canvas._fullLayout?.xaxis;
    const inside = x !== null && axis && x >= this.group.range[0] && x <= this.group.range[1];
    this.line.hidden = !inside;
    if (inside) this.line.style.transform = `translateX(${axis._offset + axis.r2p(x)}px)`;
    this.plot.curves.forEach((curve, i) => {
      if (this.values[i]) this.values[i].textContent = this.shown[i] && x !== null ? this.at(curve, x) : "";
    });
  }

  /** The value of a curve in the row nearest to x, in the chosen unit. */
  at(curve, x) {
    const y = column(curve.y).values[nearest(column(curve.x).values, x)];
    return short(this.shownAs(y));
  }
}

// plotly.js measures the time between two clicks when it handles them. A page that is busy with drawing handles the second click late.
const settings = { displaylogo: false, responsive: true, scrollZoom: false, doubleClick: false, doubleClickDelay: 600, showTips: false, modeBarButtons: [["zoom2d", "pan2d", "toImage"]] };

/** Whether fingers are the pointer: a finger scrolls the page, and buttons zoom. */
const touch = () => matchMedia("(pointer: coarse)").matches;
