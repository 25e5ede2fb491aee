// A map: values as colours over two axes. Drawn by plotly.js when it is first in sight.

/** The middles of cells, from edges that lie half-way between neighbouring middles. */
function middles(edges) {
  const found = [(edges[0] + edges[1]) / 2];
  for (let i = 1; i + 1 < edges.length; i++) found.push(2 * edges[i] - found[i - 1]);
  return found;
}

class HeatMap {
  constructor(figure) {
    this.figure = figure;
    this.map = JSON.parse(figure.querySelector("script").textContent);
    this.revision = 0;
    this.build();
  }

  build() {
    const caption = this.figure.querySelector("figcaption");
    const button = (text, label, act) => element("button", { type: "button", textContent: text, title: label, ariaLabel: label, onclick: act });
    this.readout = element("output", { className: "readout" });
    const bar = element("div", { className: "bar", role: "toolbar", ariaLabel: `View of ${caption.textContent}` },
      button("+", "Zoom in", () => this.zoom(0.5)), button("\u2212", "Zoom out", () => this.zoom(2)), button("All", "Show all", () => this.reset()), this.readout);
    this.canvas = element("div", { className: "canvas tall" });
    this.figure.append(bar, this.canvas);
    new IntersectionObserver((entries) => {
      this.inSight = entries.some((entry) => entry.isIntersecting);
      if (this.inSight && this.stale) this.draw();
    }, { rootMargin: "200px" }).observe(this.figure);
  }

  /** The numbers of a column on an axis. */
  numbers(of, axis) {
    const values = Array.from(column(of).values);
    return axis.log ? values.map((value) => 10 ** value) : values;
  }

  draw() {
    this.stale = !this.inSight;
    if (this.stale) return;
    const done = Plotly.react(this.canvas, [this.trace()], this.layout(), { ...settings, modeBarButtons: [["zoom2d", "pan2d", "toImage"]], displayModeBar: touch() ? false : "hover" });
    if (this.drawn) return;
    this.drawn = true;
    done.then(() => {
      this.canvas.on("plotly_hover", ({ points }) => this.tell(points[0]));
      this.canvas.on("plotly_click", ({ points }) => this.tell(points[0]));
      this.canvas.on("plotly_doubleclick", () => this.reset());
    });
  }

  trace() {
    const { x, y, colour } = this.map;
    const values = Array.from(column(this.map.values).values, (value) => Number.isNaN(value) ? null : value);
    const [places, heights] = [this.numbers(this.map.across, x), this.numbers(this.map.up, y)];
    const low = colour.range ? (colour.log ? Math.log10(colour.range[0]) : colour.range[0]) : undefined;
    const high = colour.range ? (colour.log ? Math.log10(colour.range[1]) : colour.range[1]) : undefined;
    const unit = colour.unit && colour.unit !== "1" ? ` [${colour.unit}]` : "";
    const colorbar = { title: { text: formula(colour.label + unit), side: "right" }, thickness: 16, outlinewidth: 0, ...(colour.log ? this.decades(values) : {}) };
    if (this.map.cells) {
      const width = places.length - 1;
      const rows = Array.from({ length: heights.length - 1 }, (_, row) => values.slice(row * width, (row + 1) * width));
      this.at = ({ pointIndex: [row, i] }) => {
        const middle = (of, axis, k) => axis.log ? 10 ** middles(column(of).values)[k] : middles(column(of).values)[k];
        return [middle(this.map.across, x, i), middle(this.map.up, y, row), rows[row][i]];
      };
      return { type: "heatmap", x: places, y: heights, z: rows, zmin: low, zmax: high, colorscale: "Viridis", colorbar, hoverinfo: "none", hoverongaps: false };
    }
    this.at = ({ pointIndex }) => [places[pointIndex], heights[pointIndex], values[pointIndex]];
    const known = values.filter((value) => value !== null);
    const marker = { color: values, cmin: low ?? Math.min(...known), cmax: high ?? Math.max(...known), colorscale: "Viridis", colorbar, showscale: true, size: 8, symbol: "square" };
    return { type: "scatter", mode: "markers", x: places, y: heights, marker, hoverinfo: "none" };
  }

  /** Ticks of a logarithmic colour bar: whole decades, or the ends of a shorter one. */
  decades(values) {
    const known = values.filter((value) => value !== null);
    const [low, high] = [Math.min(...known), Math.max(...known)];
    const step = Math.max(1, Math.ceil((high - low) / 8));
    const tickvals = [];
    for (let n = Math.ceil(low); n <= high; n += step) tickvals.push(n);
    if (tickvals.length < 2) tickvals.splice(0, 1, low, high);
    return { tickvals, ticktext: tickvals.map((value) => Number.isInteger(value) ? `10<sup>${value}</sup>` : short(10 ** value)) };
  }

  layout() {
    const [grid, ink] = [css("--grid"), css("--text")];
    const axis = ({ label, unit, log }) => ({
      title: { text: formula(unit && unit !== "1" ? `${label} [${unit}]` : label), standoff: 6 }, type: log ? "log" : "linear",
      gridcolor: grid, linecolor: grid, zeroline: false, ticks: "outside", tickcolor: grid, exponentformat: "power", minexponent: 4, fixedrange: touch(), uirevision: this.revision,
    });
    return {
      margin: { l: MARGIN, r: RIGHT, t: 10, b: 44 }, height: 440, showlegend: false, hovermode: "closest", dragmode: touch() ? false : "zoom",
      paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: css("--raised"), uirevision: this.revision,
      font: { family: getComputedStyle(document.body).fontFamily, size: 12, color: ink },
      modebar: { bgcolor: "rgba(0,0,0,0)", color: css("--muted"), activecolor: ink }, xaxis: axis(this.map.x), yaxis: axis(this.map.y),
    };
  }

  /** Shows the place and the value of a point. */
  tell(point) {
    const [x, y, value] = this.at(point);
    const number = (value, { unit }) => `${short(value)} ${unit === "1" ? "" : unit}`.trim();
    const here = value === null ? "no value" : number(this.map.colour.log ? 10 ** value : value, this.map.colour);
    this.readout.textContent = `${number(x, this.map.x)} \u00b7 ${number(y, this.map.y)}: ${here}`;
  }

  /** Zooms by a factor round the middle. */
  zoom(factor) {
    if (!this.drawn) return;
    const change = {};
    for (const name of ["xaxis", "yaxis"]) {
      const [from, to] = this.canvas._fullLayout[name].range;
      const [middle, half] = [(from + to) / 2, (to - from) / 2 * factor];
      change[`${name}.range`] = [middle - half, middle + half];
    }
    Plotly.relayout(this.canvas, change);
  }

  reset() {
    if (this.drawn) Plotly.relayout(this.canvas, { "xaxis.autorange": true, "yaxis.autorange": true });
  }
}
