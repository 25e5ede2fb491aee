// Sends each choice, and shows the run that comes back.

// Before this time [ms] a newer choice waits for the run of an older one. After it, the newer choice ends that run.
const PATIENCE = 250;
// Time [ms] without a change before the invisible sections are requested, before the run is judged, and before advice begins.
const REST = 150, QUIET = 120, CALM = 700;

let flight = null;
let waiting = false;
let since = 0;
let number = 0;
let timer = null;
// Processor time of the run that is shown [s], for tests/browser/latency.py.
let seconds = 0;

async function post(what) {
  const response = await fetch(what, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(choice) });
  if (!response.ok) throw new Error((await response.text()).trim());
  return response;
}

/** A person changed the choice. */
function changed() {
  since = performance.now();
  delete document.body.dataset.latency;
  delete document.body.dataset.judged;
  number++;
  clearTimeout(timer);
  advised(null);
  if (!flight) return send();
  waiting = true;
  if (flight.whole || since - flight.began > PATIENCE) send();
}

/**
 * Sends the choice. While an answer is under way, only the newest choice waits for it. The first answer to a long run has only the
 * beginning of the run; the `whole` run is requested after it.
 */
async function send(whole = false) {
  waiting = false;
  const mine = { began: performance.now(), since, whole };
  flight = mine;
  Object.assign(choice, { seen: inSight(byId("sections")), view: inView(), number, whole });
  const slow = setTimeout(() => { if (flight === mine) status("running ..."); }, PATIENCE);
  let answer = null;
  try {
    answer = await (await post("run")).json();
  } catch (error) {
    if (flight === mine) lost(error);
  }
  clearTimeout(slow);
  if (flight !== mine) return;
  flight = null;
  if (answer?.superseded) waiting = true;
  else if (answer) show(answer, mine.since);
  if (waiting || answer?.beginning) return send(!waiting);
  if (answer?.run) timer = setTimeout(rest, REST);
}

/** Requests the parts of the run that are not visible. */
async function rest() {
  const mine = number;
  let parts = null;
  try { parts = await (await post("rest")).json(); } catch (error) { if (mine === number) lost(error); }
  if (mine !== number || flight) return;
  Panel.part = 1;
  if (parts?.others) byId("remarks").prepend(note(parts.others));
  if (parts?.of) showSections(byId("sections"), parts, `rest${choice.number}-`);
  else drawAll(panels);
  whole();
  timer = setTimeout(judge, QUIET);
}

function whole() {
  document.body.dataset.whole = String(number);
  document.body.dataset.ready = "true";
}

const status = (text) => { byId("status").textContent = text; };

function lost(error) {
  status(error instanceof TypeError ? "gearsim does not answer: it has ended, or was stopped" : `refused: ${error.message}`);
}

function show(answer, from) {
  status("");
  showValues(answer.controls);
  showEffects(answer.effects);
  showSolver(answer.solver, answer.run?.method);
  showMistakes(answer.mistakes);
  const { run, beginning } = answer;
  document.body.classList.toggle("old", !run && !beginning);
  document.body.classList.toggle("begun", Boolean(beginning));
  Panel.part = COARSE;
  Panel.until = beginning ? beginning.length : -Infinity;
  if (run) showRun(run);
  else if (beginning) showSections(byId("sections"), beginning.page, `beginning${choice.number}-`);
  else status("the plots are those of the last choice without a mistake");
  requestAnimationFrame(() => setTimeout(() => {
    // The latency of a long run is the time until its beginning is on the screen.
    document.body.dataset.latency ??= String(performance.now() - from);
    document.body.dataset.shown = beginning ? String(beginning.reached / beginning.length) : "1";
    if (beginning) return;
    document.body.dataset.drawn = String(number);
    if (!run) whole();
  }));
}

function showRun(run) {
  seconds = run.seconds;
  byId("about").textContent = run.subtitle;
  put("time", run.time, "");
  put("error", "\u2026", "");
  put("unaccounted", run.unaccounted, run.share ? `${run.share} of the largest part` : "");
  put("digits", "\u2026", "");
  put("method", run.method, run.why);
  byId("remarks").replaceChildren(...run.remarks.map(note));
  length = run.length;
  const head = element("tr", {}, ...["", "value", "unit"].map((text) => element("th", { scope: "col", textContent: text })));
  const lines = run.state.map(([name, unit, x, text]) => {
    const value = element("td", { className: "number", textContent: text });
    value.dataset.value = String(x);
    return element("tr", {}, element("th", { scope: "row", textContent: name }), value, element("td", { textContent: unit }));
  });
  byId("state").replaceChildren(element("div", { className: "scroll" }, element("table", {}, head, ...lines)));
  showSections(byId("sections"), run.page, `run${choice.number}-`);
}

const MORE = { time: "ratio", error: "against", unaccounted: "share", digits: "gone", method: "why" };

const note = (text) => element("p", { className: "note", textContent: text });

function put(id, text, more) {
  byId(id).textContent = text;
  byId(MORE[id]).textContent = more;
  byId(MORE[id]).title = more;
}

/** Asks for cost and error of the run that is shown. */
async function judge() {
  const mine = number;
  let judgement = null;
  try { judgement = await (await post("judge")).json(); } catch (error) { if (mine === number) lost(error); return; }
  if (mine !== number || flight) return;
  // Advice begins after the judgement, because the judgement measures time. A newer choice cancels the advice.
  timer = setTimeout(advise, CALM);
  if (!judgement || "superseded" in judgement) {
    put("error", "-", judgement?.superseded ? "" : "the reference takes too long");
    put("digits", "-", "");
    return;
  }
  put("time", judgement.time, judgement.ratio);
  put("error", judgement.error, judgement.against);
  put("digits", judgement.digits, judgement.none_from === null ? "of the end state" : `none from ${short(judgement.none_from)} s on (shaded)`);
  if (judgement.none_from !== null) {
    for (const panel of panels.filter((panel) => panel.plot.group === "time")) {
      panel.plot.shaded_from = judgement.none_from;
      panel.draw();
    }
  }
  document.body.dataset.judged = String(mine);
}

async function advise() {
  const mine = number;
  byId("advising").textContent = "running with and without each effect ...";
  let advice = null;
  try { advice = await (await post("advise")).json(); } catch (error) { if (mine === number) lost(error); }
  if (mine !== number) return;
  byId("advising").textContent = advice && !("superseded" in advice) ? "" : "this takes longer than a page waits: use `gearsim advise`";
  if (advice?.rows) advised(advice);
}

/** Shows which effects matter: a table, and a word beside each check box. Without advice, the advice on the page is marked as old. */
function advised(advice) {
  document.body.classList.toggle("unadvised", !advice);
  byId("advising").textContent = "";
  if (!advice) return;
  const says = ({ truth, estimate }) => {
    const small = truth ?? estimate;
    return small === null ? "unknown" : small ? "negligible" : "needed";
  };
  const head = element("tr", {}, ...["without", "", ...advice.names, "time"].map((text) => element("th", { scope: "col", textContent: text })));
  const lines = advice.rows.map((row) => element("tr", {},
    element("th", { scope: "row", textContent: row.without }), element("td", { className: says(row), textContent: says(row), title: row.note }),
    ...(row.deviations ?? advice.names.map(() => "-")).map((text) => element("td", { className: "number", textContent: text })),
    element("td", { className: "number", textContent: row.time })));
  const limits = element("tr", { className: "limits" }, element("th", { scope: "row", textContent: "limits" }), element("td"),
    ...advice.limits.map((text) => element("td", { className: "number", textContent: text })), element("td"));
  const notes = advice.rows.filter((row) => row.note).map((row) => element("p", { textContent: `${row.without}: ${row.note}` }));
  const why = advice.why_not ? [note(advice.why_not)] : [];
  const table = element("div", { className: "scroll" }, element("table", {}, element("thead", {}, head), element("tbody", {}, ...lines, limits)));
  byId("advised").replaceChildren(...why, ...(advice.rows.length ? [table] : []), ...notes);
  for (const label of byId("effects").querySelectorAll("label")) {
    const name = label.querySelector("input").name;
    const row = advice.rows.find(({ effect }) => effect === name || name.startsWith(`${effect}_`));
    const verdict = label.querySelector(".verdict");
    // These two effects leave terms out. The verdict is on the terms, not on the effect.
    const terms = row?.without.startsWith("jump terms") ? "terms " : "";
    verdict.textContent = row ? terms + says(row) : "";
    verdict.title = row?.without ?? "";
    verdict.className = `verdict ${row ? says(row) : ""}`;
  }
}

async function save() {
  try {
    const text = await (await post("save")).text();
    const url = URL.createObjectURL(new Blob([text], { type: "application/toml" }));
    const link = element("a", { href: url, download: `${document.querySelector("h1").textContent}_explored.toml` });
    link.click();
    setTimeout(() => URL.revokeObjectURL(url));
  } catch (error) { lost(error); }
}

byId("controls").addEventListener("submit", (event) => event.preventDefault());
byId("save").addEventListener("click", save);
byId("reset").addEventListener("click", () => {
  Object.assign(choice, { values: {}, effects: null, solver: null });
  changed();
});
const narrow = matchMedia("(max-width: 60rem)");
const fold = () => { byId("side").open = !narrow.matches; };
narrow.addEventListener("change", fold);
fold();
const draw = () => [...panels, ...drawings].forEach((drawn) => drawn.draw());
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
addEventListener("resize", draw);
changed();
