// Plots with common limits of x and a common cursor.

const groups = new Map();
// Time [ms] without a change after which curves are drawn in all detail.
const STILL_FOR = 120;

class Group {
  /** The group of a panel, with the panel added. A plot without a group is alone in a group of its own. */
  static of(panel) {
    const name = panel.plot.group ?? panel.figure;
    if (!groups.has(name)) groups.set(name, new Group(panel.plot.x));
    groups.get(name).panels.push(panel);
    return groups.get(name);
  }

  constructor(x) {
    this.x = x;
    this.panels = [];
    this.bars = [];
    // Functions to call when the cursor moves.
    this.followers = [];
    this.cursor = null;
    this.revision = 0;
    // The timer after which all detail is drawn.
    this.detail = null;
  }

  /** Finds the limits of its panels. */
  begin() {
    const limits = this.panels.map((panel) => panel.limits());
    const first = this.x.range?.map((x) => this.x.log ? Math.log10(x) : x);
    if (first) limits.push(first);
    this.all = [Math.min(...limits.map(([from]) => from)), Math.max(...limits.map(([, to]) => to))];
    if (!(this.all[1] > this.all[0])) this.all[1] = this.all[0] + 1;
    this.range = first ?? [...this.all];
    const events = this.panels.find((panel) => panel.plot.events)?.plot.events;
    this.events = events ? column(events).values : null;
  }

  /** Shows the abscissae between two values, within those of the data, in all panels. */
  show(from, to) {
    const smallest = 1e-12 * Math.max(Math.abs(this.all[0]), Math.abs(this.all[1]));
    from = Math.max(from, this.all[0]);
    to = Math.min(to, this.all[1]);
    if (!(to - from > smallest)) return;
    this.range = [from, to];
    this.revision++;
    this.later();
  }

  reset() {
    this.panels.forEach((panel) => panel.yRevision++);
    this.show(...this.all);
  }

  /** Zooms by a factor round the cursor, or round the middle. */
  zoom(factor) {
    const [from, to] = this.range;
    const held = this.cursor !== null && this.cursor >= from && this.cursor <= to ? this.cursor : (from + to) / 2;
    this.show(held - (held - from) * factor, held + (to - held) * factor);
  }

  /** Moves the view by a fraction of its width. */
  pan(fraction) {
    const width = this.range[1] - this.range[0];
    const from = Math.min(Math.max(this.range[0] + fraction * width, this.all[0]), this.all[1] - width);
    this.show(from, from + width);
  }

  /** Puts the cursor at x. */
  point(x) {
    this.cursor = Math.min(Math.max(x, this.all[0]), this.all[1]);
    this.markLater();
  }

  /** Puts the cursor at the next event, or at the one before, and moves the view there. */
  step(direction) {
    if (!this.events) return;
    const here = this.cursor ?? this.range[0];
    const after = lowerBound(this.events, here);
    let i = direction < 0 ? after - 1 : after;
    while (direction > 0 && this.events[i] <= here) i++;
    if (!(i >= 0 && i < this.events.length)) return;
    this.point(this.events[i]);
    const [from, to] = this.range;
    if (this.cursor < from || this.cursor > to) this.show(this.cursor - (to - from) / 2, this.cursor + (to - from) / 2);
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = (this.range[1] - this.range[0]) / (event.shiftKey ? 20 : 200);
    const here = this.cursor ?? (this.range[0] + this.range[1]) / 2;
    const actions = {
      ArrowLeft: () => this.point(here - step), ArrowRight: () => this.point(here + step),
      "+": () => this.zoom(0.5), "=": () => this.zoom(0.5), "-": () => this.zoom(2), "0": () => this.reset(),
      ",": () => this.pan(-0.25), ".": () => this.pan(0.25), n: () => this.step(1), p: () => this.step(-1),
    };
    if (!actions[event.key]) return;
    actions[event.key]();
    event.preventDefault();
  }

  /** A bar of buttons for readers without a keyboard, with the view and the cursor in numbers. */
  bar() {
    const button = (text, label, act) => {
      const made = element("button", { type: "button", textContent: text, title: label, ariaLabel: label });
      made.addEventListener("click", act);
      return made;
    };
    const readout = element("output", { className: "readout" });
    const buttons = [
      button("+", "Zoom in", () => this.zoom(0.5)), button("\u2212", "Zoom out", () => this.zoom(2)),
      button("\u25c2", "Earlier", () => this.pan(-0.25)), button("\u25b8", "Later", () => this.pan(0.25)),
      button("All", "Show all", () => this.reset()),
    ];
    if (this.events) buttons.push(button("\u25c2 event", "Cursor to the event before", () => this.step(-1)), button("event \u25b8", "Cursor to the next event", () => this.step(1)));
    this.bars.push(readout);
    return element("div", { className: "bar", role: "toolbar", ariaLabel: `View over ${this.x.label}` }, ...buttons, readout);
  }

  /** Draws at most once per frame, however often the view changes. Draws in all detail when the view has not changed for some time. */
  later() {
    clearTimeout(this.detail);
    this.detail = setTimeout(() => {
      this.detail = null;
      this.draw(1);
    }, STILL_FOR);
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      if (this.detail) this.draw(COARSE);
      this.tell();
    });
  }

  /** Draws its panels with curves reduced to parts of `part` pixels. */
  draw(part) {
    const before = Panel.part;
    Panel.part = part;
    this.panels.forEach((panel) => panel.draw());
    Panel.part = before;
  }

  markLater() {
    if (this.marking) return;
    this.marking = true;
    requestAnimationFrame(() => {
      this.marking = false;
      this.panels.filter((panel) => panel.inSight).forEach((panel) => panel.mark());
      this.followers.forEach((follow) => follow());
      this.tell();
    });
  }

  tell() {
    const [from, to] = this.range;
    const unit = this.x.unit === "1" ? "" : this.x.unit;
    const digits = Math.max(5, Math.min(12, Math.ceil(Math.log10(Math.abs(to) / (to - from))) + 4));
    const number = (x) => Number((this.x.log ? 10 ** x : x).toPrecision(digits));
    const parts = [`${number(from)} to ${number(to)} ${unit}`];
    if (this.cursor !== null) parts.push(`cursor ${number(this.cursor)} ${unit}`);
    if (this.events) parts.push(`${lowerBound(this.events, to) - lowerBound(this.events, from)} events in view`);
    this.bars.forEach((bar) => { bar.textContent = parts.join(" \u00b7 "); });
  }
}
