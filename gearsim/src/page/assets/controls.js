// The controls of a scene. What a person chose is in `choice`, which every request sends whole.

const choice = { values: {}, effects: null, solver: null };
const rows = new Map();
// Number of places of a slider.
const PLACES = 1000;

const byId = (id) => document.getElementById(id);

/** A number with four digits, as a slider gives it. */
const rounded = (x) => Number(x.toPrecision(4));

/** A slider and a field for one number of the scene. */
class Row {
  constructor(control) {
    this.control = control;
    const id = `value-${rows.size}-${control.key.replace(/\W/g, "-")}`;
    this.slider = element("input", { type: "range", min: 0, max: PLACES, step: 1, ariaLabel: `${control.label}, slider`, tabIndex: 0 });
    this.field = element("input", { type: "number", step: "any", id, inputMode: "decimal" });
    this.wrong = element("p", { className: "wrong", id: `${id}-wrong`, hidden: true });
    this.field.setAttribute("aria-describedby", this.wrong.id);
    const name = element("label", { htmlFor: id, textContent: control.label, title: control.doc || control.key });
    const unit = element("span", { className: "unit", textContent: control.unit });
    this.back = element("button", { type: "button", className: "back", textContent: "\u21ba", title: "As in the scene", ariaLabel: `${control.label} as in the scene` });
    this.element = element("div", { className: "row" }, name, this.back, this.field, unit, this.slider, this.wrong);
    this.slider.addEventListener("input", () => this.take(this.at(Number(this.slider.value)), true));
    this.field.addEventListener("input", () => this.type());
    this.back.addEventListener("click", () => { delete choice.values[control.key]; changed(); });
    this.show(control.value);
    this.say("");
  }

  /** The number at a place of the slider. */
  at(place) {
    const { low, high, log, whole } = this.control;
    const x = log ? low * (high / low) ** (place / PLACES) : low + (high - low) * place / PLACES;
    return whole ? Math.round(x) : rounded(x);
  }

  /** The place of a number on the slider. */
  place(x) {
    const { low, high, log } = this.control;
    const part = log ? Math.log(x / low) / Math.log(high / low) : (x - low) / (high - low);
    return Math.round(PLACES * Math.min(1, Math.max(0, Number.isNaN(part) ? 0 : part)));
  }

  take(x, slid) {
    choice.values[this.control.key] = x;
    if (slid) this.field.value = String(x); else this.slider.value = this.place(x);
    this.mark();
    changed();
  }

  type() {
    const x = this.field.valueAsNumber;
    if (Number.isFinite(x)) return this.take(x, false);
    this.say(this.field.value === "" && !this.field.validity.badInput ? "give a number" : "this is not a number");
  }

  show(x) {
    this.field.value = String(x);
    this.slider.value = this.place(x);
    this.mark();
  }

  mark() {
    this.back.hidden = !(this.control.key in choice.values);
    this.slider.setAttribute("aria-valuetext", `${this.field.value} ${this.control.unit}`);
  }

  /** Shows the number of the scene, unless a person has set another one. */
  renew(control) {
    this.control = control;
    if (!(control.key in choice.values)) this.show(control.value); else this.mark();
  }

  say(text) {
    this.wrong.textContent = text;
    this.wrong.hidden = !text;
    if (text) this.field.setAttribute("aria-invalid", "true"); else this.field.removeAttribute("aria-invalid");
  }
}

/** Shows the numbers of the scene; those that are new get a row, those that are gone lose it. */
function showValues(controls) {
  const keys = new Set(controls.map(({ key }) => key));
  for (const [key, row] of rows) {
    if (keys.has(key)) continue;
    row.element.remove();
    rows.delete(key);
    delete choice.values[key];
  }
  for (const control of controls) {
    const row = rows.get(control.key);
    if (row) { row.renew(control); continue; }
    const made = new Row(control);
    rows.set(control.key, made);
    groupOf(control.group, controls).append(made.element);
  }
  document.querySelectorAll("#values > details").forEach((group) => { if (!group.querySelector(".row")) group.remove(); });
}

/** The element for the rows of a group. Large groups are closed at first. */
function groupOf(title, controls) {
  const known = [...document.querySelectorAll("#values > details")].find((group) => group.dataset.title === title);
  if (known) return known;
  const open = controls.filter(({ group }) => group === title).length <= 16;
  const made = element("details", { open }, element("summary", { textContent: title }));
  made.dataset.title = title;
  byId("values").append(made);
  return made;
}

/** Shows a check box for each effect. */
function showEffects(effects) {
  const boxes = byId("effects").querySelectorAll("input");
  if (boxes.length !== effects.length) {
    byId("effects").querySelectorAll("label, p").forEach((old) => old.remove());
    for (const { name, doc } of effects) {
      const box = element("input", { type: "checkbox", name });
      box.addEventListener("change", () => {
        choice.effects = [...byId("effects").querySelectorAll("input:checked")].map((each) => each.name);
        changed();
      });
      const verdict = element("span", { className: "verdict" });
      byId("effects").append(element("label", { title: doc }, box, element("span", { textContent: name }), verdict));
    }
    byId("effects").append(element("p", { className: "wrong", id: "wrong-effects", hidden: true, role: "alert" }));
  }
  if (choice.effects === null) {
    for (const box of byId("effects").querySelectorAll("input")) box.checked = effects.some(({ name, on }) => on && name === box.name);
  }
}

const ADAPTIVE = ["dopri5", "dop853", "radau"];
const FIXED = ["rk4", "rk4_grid"];

/** Shows the menu of methods, and the field for the tolerance or the step of the chosen method. */
function showSolver({ methods, method, tolerance, step }, used) {
  if (!byId("menu")) buildSolver(methods);
  if (choice.solver === null) {
    byId("menu").value = method ?? "";
    byId("tolerance").value = tolerance ?? "";
    byId("step").value = step ?? "";
  }
  const here = byId("menu").value || used || "";
  byId("tolerance").closest("div").hidden = !ADAPTIVE.includes(here);
  byId("step").closest("div").hidden = !FIXED.includes(here);
  byId("menu").options[0].textContent = used && !byId("menu").value ? `chosen: ${used}` : "chosen by gearsim";
}

function buildSolver(methods) {
  const menu = element("select", { id: "menu", ariaLabel: "Method" }, element("option", { value: "" }));
  methods.forEach((name) => menu.append(element("option", { value: name, textContent: name })));
  const field = (id, name, unit, placeholder) => {
    const input = element("input", { id, type: "number", step: "any", min: 0, placeholder });
    input.addEventListener("input", chooseSolver);
    return element("div", { className: "row", hidden: true }, element("label", { htmlFor: id, textContent: name }), input, element("span", { className: "unit", textContent: unit }));
  };
  menu.addEventListener("change", () => {
    // A method with fixed steps needs one: a ten-thousandth of the run.
    if (FIXED.includes(menu.value) && !byId("step").value) byId("step").value = String(rounded(length / 1e4));
    chooseSolver();
  });
  byId("solver").append(menu, field("tolerance", "tolerance", "", "1e-9"), field("step", "step", "s", ""));
  byId("solver").append(element("p", { className: "wrong", id: "wrong-solver", hidden: true, role: "alert" }));
}

// Length of the last run [s].
let length = 1;

function chooseSolver() {
  const method = byId("menu").value || null;
  const number = (id, methods) => {
    const x = byId(id).valueAsNumber;
    return Number.isFinite(x) && methods.includes(method) ? x : null;
  };
  choice.solver = { method, tolerance: number("tolerance", [null, ...ADAPTIVE]), step: number("step", FIXED) };
  changed();
}

/** Shows each mistake beside its control, and mistakes without a control above the plots. */
function showMistakes(mistakes) {
  rows.forEach((row) => row.say(""));
  const places = new Map([["effects", byId("wrong-effects")], ["solver", byId("wrong-solver")]]);
  places.forEach((place) => { place.textContent = ""; place.hidden = true; });
  const others = [];
  for (const { key, message, help } of mistakes) {
    const text = help ? `${message}: ${help}` : message;
    const row = rows.get(key) ?? (key ? [...rows].find(([other]) => other.startsWith(`${key}.`))?.[1] : null);
    const solver = ["run.method", "run.tolerance", "run.step"].includes(key);
    const place = key.split(".")[0] === "effects" ? places.get("effects") : solver ? places.get("solver") : null;
    if (row) {
      row.say(text);
      row.element.closest("details").open = true;
    } else if (place) {
      place.textContent = [place.textContent, text].filter((part) => part).join("\n");
      place.hidden = false;
    } else others.push(text);
  }
  byId("mistakes").replaceChildren(...others.map((text) => element("p", { className: "note", textContent: text })));
}
