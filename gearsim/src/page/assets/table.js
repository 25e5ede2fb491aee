// Tables that are sorted by the column whose head is clicked.

function sortable(table) {
  const heads = [...table.querySelectorAll("th")];
  const body = table.tBodies[0];
  const original = [...body.rows];
  heads.forEach((head, column) => head.querySelector("button").addEventListener("click", () => {
    const next = { none: "ascending", ascending: "descending", descending: "none" }[head.ariaSort ?? "none"];
    heads.forEach((other) => other.removeAttribute("aria-sort"));
    if (next !== "none") head.setAttribute("aria-sort", next);
    const sign = next === "descending" ? -1 : 1;
    const rows = next === "none" ? original : [...original].sort((a, b) => sign * compare(a.cells[column], b.cells[column]));
    body.append(...rows);
  }));
}

/** Compares numbers by value, with those that are NaN last, and texts alphabetically. */
function compare(a, b) {
  if (!("value" in a.dataset) || !("value" in b.dataset)) return a.textContent.localeCompare(b.textContent, "en", { numeric: true });
  const [x, y] = [Number(a.dataset.value), Number(b.dataset.value)];
  if (Number.isNaN(x) || Number.isNaN(y)) return Number.isNaN(x) - Number.isNaN(y);
  return x - y;
}
