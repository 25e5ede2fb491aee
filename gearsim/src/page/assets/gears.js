// The gears of a run, drawn as they stand at the cursor of the plots over time.

// Height of the drawing in base pitches; null: both gears are drawn whole.
const VIEWS = [["the mesh", 4], ["one pair", 1.6], ["whole gears", null]];
// Base pitches of a step, and time [ms] between steps for readers who prefer no motion.
const TENTH = 0.1, STILL = 600;
// Deflections are drawn at first with about this share of a base pitch, and with at most half of one.
const DRAWN = 0.12, MOST = 0.5;
// Mesh cycles a second at first.
const CYCLES = 0.4;
// Colours of forces from zero to the largest: viridis, whose lightness increases steadily.
const FORCES = ["#440154", "#414487", "#2a788e", "#22a884", "#7ad151", "#fde725"];

/** The largest number that is 1, 2 or 5 times a power of ten and at most x. */
function round125(x) {
  const power = 10 ** Math.floor(Math.log10(x) + 1e-9);
  return power * [5, 2, 1].find((n) => n * power <= x * (1 + 1e-9));
}

/** All 1, 2 and 5 times powers of ten from a to b. */
function steps125(a, b) {
  const found = [];
  for (let power = 10 ** Math.floor(Math.log10(a)); power <= b; power *= 10) found.push(...[1, 2, 5].map((n) => n * power));
  return found.filter((x) => x >= a * (1 - 1e-9) && x <= b * (1 + 1e-9));
}

/** The colour of a share of the largest force. */
function forceColour(share) {
  const place = Math.min(Math.max(share, 0), 1) * (FORCES.length - 1);
  const i = Math.min(Math.floor(place), FORCES.length - 2);
  const part = (colour, at) => parseInt(colour.slice(at, at + 2), 16);
  const mixed = [1, 3, 5].map((at) => Math.round(part(FORCES[i], at) + (place - i) * (part(FORCES[i + 1], at) - part(FORCES[i], at))));
  return `rgb(${mixed.join(", ")})`;
}

class Gears {
  // The choices of the reader, kept for the same drawing of another run.
  static chosen = { mesh: null, view: 0, slower: null, magnified: null, playing: false };

  constructor(figure) {
    this.figure = figure;
    this.drawing = JSON.parse(figure.querySelector("script").textContent);
    this.group = groups.get(this.drawing.group);
    this.t = this.group.cursor ?? this.group.all[0];
    this.playing = false;
    this.build();
    this.choose(this.drawing.meshes.find(({ name }) => name === Gears.chosen.mesh) ?? this.drawing.meshes[0]);
    this.follow = () => { if (this.group.cursor !== null) this.go(this.group.cursor); };
    this.group.followers.push(this.follow);
    if (Gears.chosen.playing) this.play();
  }

  get times() { return column(this.drawing.t).values; }

  build() {
    const caption = this.figure.querySelector("figcaption");
    const button = (text, label, act) => element("button", { type: "button", textContent: text, title: label, ariaLabel: label, onclick: act });
    const menu = (label, act) => element("select", { ariaLabel: label, onchange: act });
    const labelled = (text, input) => element("label", {}, text, input);
    this.button = button("\u25b6 Play", "Play", () => (this.playing ? this.pause() : this.play()));
    this.scrub = element("input", { type: "range", min: 0, max: 10000, step: 1, value: 0, ariaLabel: "Time", oninput: () => this.point(this.fraction(this.scrub.value / 10000)) });
    this.meshes = menu("Mesh", () => { Gears.chosen.mesh = this.meshes.value; Gears.chosen.magnified = null; this.choose(this.drawing.meshes[this.meshes.selectedIndex]); });
    this.meshes.append(...this.drawing.meshes.map(({ name }) => element("option", { value: name, textContent: name || "of the gears" })));
    this.view = menu("View", () => { Gears.chosen.view = this.view.selectedIndex; this.draw(); });
    this.view.append(...VIEWS.map(([name]) => element("option", { textContent: name })));
    this.view.selectedIndex = Gears.chosen.view;
    this.magnify = menu("Magnification of deflection and play", () => { Gears.chosen.magnified = Number(this.magnify.value); this.draw(); });
    this.slow = menu("Speed", () => { Gears.chosen.slower = Number(this.slow.value); });
    const mesh = labelled("mesh ", this.meshes);
    mesh.hidden = this.drawing.meshes.length < 2;
    const bar = element("div", { className: "drive", role: "toolbar", ariaLabel: "Motion of the gears" },
      this.button, button("\u25c2 step", "A tenth of a pitch back", () => this.step(-1)), button("step \u25b8", "A tenth of a pitch on", () => this.step(1)), this.scrub);
    const menus = element("div", { className: "drive" }, mesh, labelled("view ", this.view), labelled("deflection and play magnified ", this.magnify), labelled("speed ", this.slow));
    this.canvas = element("canvas", { role: "img" });
    this.frame = element("div", { className: "frame gearing", tabIndex: 0, role: "group", ariaLabel: `${caption.textContent}. Space plays and pauses, arrow keys move by a tenth of a pitch.` }, this.canvas);
    this.frame.addEventListener("keydown", (event) => this.key(event));
    this.readout = element("output", { className: "readout" });
    this.readout.setAttribute("aria-live", "off");
    this.scale = element("div", { className: "scale" });
    this.note = element("p", { className: "meaning" });
    this.figure.append(bar, menus, this.frame, this.scale, this.readout, this.note);
    this.observer = new IntersectionObserver((entries) => {
      this.inSight = entries.some((entry) => entry.isIntersecting);
      if (this.inSight) this.draw();
    }, { rootMargin: "100px" });
    this.observer.observe(this.figure);
  }

  /** Shows a mesh, with a magnification and a speed that suit it. */
  choose(mesh) {
    this.mesh = mesh;
    this.meshes.value = mesh.name;
    this.note.textContent = mesh.note;
    const reach = (part) => part * mesh.pitch / Math.max(mesh.largest_lead, (mesh.play ?? 0) / 2, 1e-9 * mesh.pitch);
    const most = Math.max(1, round125(reach(MOST)));
    const options = (menu, values, text, value) => {
      menu.replaceChildren(...values.map((value) => element("option", { value: String(value), textContent: text(value) })));
      menu.value = String(values.reduce((a, b) => (Math.abs(Math.log(b / value)) < Math.abs(Math.log(a / value)) ? b : a)));
    };
    options(this.magnify, steps125(1, most), (n) => `${n.toLocaleString("en")} times`, Gears.chosen.magnified ?? Math.max(1, round125(reach(DRAWN))));
    const slower = Math.max(1, round125(mesh.frequency / CYCLES));
    options(this.slow, steps125(Math.max(1, slower / 100), slower * 20), (n) => (n === 1 ? "real time" : `1/${n.toLocaleString("en")} of real time`), Gears.chosen.slower ?? slower);
    this.legend();
    this.draw();
  }

  /** Explains the colours of the contacts. */
  legend() {
    const { force } = this.mesh;
    this.scale.hidden = !force;
    if (!force) return;
    const [unit, factor] = suitable(UNITS[force.unit] ?? [[force.unit, 1]], force.largest);
    const bar = element("span", { className: "colours", ariaHidden: "true" });
    bar.style.background = `linear-gradient(to right, ${FORCES.join(", ")})`;
    const what = force.unit === "N" ? "force of a pair" : `${force.name} of a pair`;
    const sides = this.mesh.play === null ? "" : "Round: drive flanks, square: coast flanks. ";
    const ends = element("span", { className: "ends" }, `${what}: 0`, bar, `${short(factor * force.largest)} ${unit}`);
    this.scale.replaceChildren(ends, `${sides}Dashed: line of action; its thick part: path of contact.`);
  }

  fraction(part) {
    const times = this.times;
    return times[0] + part * (times[times.length - 1] - times[0]);
  }

  /** Moves to a time, and the cursor of the plots with it. */
  point(t) {
    this.group.point(t);
    this.go(this.group.cursor);
  }

  go(t) {
    if (t === this.t && this.seen) return;
    this.t = t;
    if (this.inSight) this.draw();
  }

  /** Moves by a tenth of a base pitch. */
  step(direction) {
    const { frequency } = this.mesh;
    if (frequency > 0) this.point(this.t + direction * TENTH / frequency);
  }

  play() {
    this.playing = Gears.chosen.playing = true;
    this.button.textContent = "\u275a\u275a Pause";
    this.button.title = this.button.ariaLabel = "Pause";
    const still = matchMedia("(prefers-reduced-motion: reduce)");
    let last = performance.now();
    const frame = (now) => {
      if (!this.playing) return;
      requestAnimationFrame(frame);
      const end = this.fraction(1);
      if (still.matches) {
        if (now - last < STILL) return;
        last = now;
        this.t >= end ? this.point(this.fraction(0)) : this.step(1);
        return;
      }
      // A page in the background gets no frames. Limit the time, so that the motion continues where it stopped.
      const passed = Math.min(now - last, 100) / 1000;
      last = now;
      this.point(this.t >= end ? this.fraction(0) : this.t + passed / Number(this.slow.value));
    };
    requestAnimationFrame(frame);
  }

  pause() {
    this.playing = Gears.chosen.playing = false;
    this.button.textContent = "\u25b6 Play";
    this.button.title = this.button.ariaLabel = "Play";
  }

  /** Stops the drawing before another one replaces it. */
  leave() {
    this.playing = false;
    this.observer.disconnect();
    this.group.followers = this.group.followers.filter((follow) => follow !== this.follow);
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const actions = { " ": () => (this.playing ? this.pause() : this.play()), ArrowLeft: () => this.step(-1), ArrowRight: () => this.step(1) };
    if (!actions[event.key]) return;
    actions[event.key]();
    event.preventDefault();
  }

  /** The state of the mesh at the present time. */
  now() {
    return instant(this.mesh, this.times, this.t, Number(this.magnify.value));
  }

  draw() {
    if (!this.inSight || !this.mesh) return;
    this.seen = true;
    const state = this.now();
    const times = this.times;
    const span = times[times.length - 1] - times[0];
    this.scrub.value = String(Math.round(10000 * (this.t - times[0]) / span));
    this.tell(state);
    const { clientWidth: width, clientHeight: height } = this.frame;
    const sharp = window.devicePixelRatio || 1;
    if (this.canvas.width !== Math.round(width * sharp) || this.canvas.height !== Math.round(height * sharp)) {
      [this.canvas.width, this.canvas.height] = [Math.round(width * sharp), Math.round(height * sharp)];
    }
    const context = this.canvas.getContext("2d");
    context.setTransform(sharp, 0, 0, sharp, 0, 0);
    context.clearRect(0, 0, width, height);
    new Picture(context, this.mesh, state, VIEWS[this.view.selectedIndex][1], [width, height]).draw();
  }

  /** Shows the state in numbers. */
  tell({ t, rotation, lead, force, contacts, coasts }) {
    const { mesh } = this;
    const number = (x, unit, largest) => {
      const [name, factor] = suitable(UNITS[unit] ?? [[unit, 1]], largest);
      return `${short(Number((factor * x).toPrecision(4)))} ${name}`;
    };
    const pairs = contacts.length === 0 ? "no contact" : `${contacts.length} ${contacts.length === 1 ? "pair" : "pairs"} in contact${coasts ? " on the coast flanks" : ""}`;
    const parts = [`t = ${short(t)} s`, `driving gear at ${short(rotation)} rad`, `ahead by ${number(lead, mesh.unit, mesh.largest_lead)}`, pairs];
    if (force !== null) parts.push(`${mesh.force.name} ${number(contacts.length ? force : 0, mesh.force.unit, mesh.force.largest)}`);
    this.readout.textContent = parts.join(" \u00b7 ");
    this.canvas.ariaLabel = `Teeth of both gears. ${this.readout.textContent}`;
  }
}
