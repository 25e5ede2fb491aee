// Starts the page.

const panels = [...document.querySelectorAll("figure.plot")].map((figure) => new Panel(figure));
const maps = [...document.querySelectorAll("figure.map")].map((figure) => new HeatMap(figure));
for (const group of groups.values()) group.begin();

// One bar per group in each section, before the first plot of the group there.
for (const section of document.querySelectorAll("section")) {
  const seen = new Set();
  for (const panel of panels.filter((panel) => section.contains(panel.figure))) {
    if (seen.has(panel.group)) continue;
    seen.add(panel.group);
    panel.figure.before(panel.group.bar());
    panel.group.tell();
  }
}
const drawings = [...document.querySelectorAll("figure.gears")].map((figure) => new Gears(figure));
const draw = () => [...panels, ...maps, ...drawings].forEach((plot) => plot.draw());
draw();
document.querySelectorAll("table.sortable").forEach(sortable);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
addEventListener("resize", draw);
document.body.dataset.ready = "true";
