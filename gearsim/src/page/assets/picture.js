// Draws a mesh at an instant on a canvas.

class Picture {
  /** `high`: height in base pitches about the pitch point; null: both gears are drawn whole. */
  constructor(context, mesh, state, high, [width, height]) {
    Object.assign(this, { context, mesh, state, width, height });
    const pitchPoint = mesh.gears[0].base / Math.cos(mesh.angle);
    this.whole = high === null;
    if (!this.whole) {
      this.scale = height / (high * mesh.pitch);
      this.middle = [pitchPoint, 0];
    } else {
      const reach = mesh.gears.map(({ tip, root }) => Math.max(tip, root) + (mesh.internal ? this.rim() : 0));
      const [low, end] = [Math.min(-reach[0], centre(mesh, 1) - reach[1]), Math.max(reach[0], centre(mesh, 1) + reach[1])];
      this.scale = 0.96 * Math.min(width / (end - low), height / (2 * Math.max(...reach)));
      this.middle = [(low + end) / 2, 0];
    }
    // The part of each gear that is in view, as an angle about its centre [rad], with a margin.
    const diagonal = 0.55 * Math.hypot(width, height) / this.scale;
    this.reach = mesh.gears.map(({ base }) => {
      const radius = base / Math.cos(mesh.angle);
      return high === null || diagonal >= radius ? Math.PI : 1.2 * Math.asin(diagonal / radius) + 2 * mesh.pitch / radius;
    });
  }

  /** Thickness of the rim outside the teeth of a ring. */
  rim() {
    const { tip, root } = this.mesh.gears[1];
    return 1.2 * Math.abs(root - tip);
  }

  /** The place on the screen. */
  at([x, y]) {
    return [this.width / 2 + (x - this.middle[0]) * this.scale, this.height / 2 - (y - this.middle[1]) * this.scale];
  }

  draw() {
    const { mesh, state } = this;
    // The ring first: the other gear is inside it.
    for (const i of [1, 0]) this.gear(i);
    this.line(false);
    if (mesh.play !== null) this.line(true);
    for (const contact of state.contacts) this.contact(contact);
  }

  gear(i) {
    const { context, mesh, state } = this;
    const gear = mesh.gears[i], ring = i === 1 && mesh.internal;
    const { points, whole } = outline(mesh, i, state, this.reach[i]);
    const teeth = new Path2D();
    points.forEach((point, k) => { const [x, y] = this.at(point); k === 0 ? teeth.moveTo(x, y) : teeth.lineTo(x, y); });
    if (whole) teeth.closePath();
    const body = new Path2D(teeth);
    const [x, y] = this.at([centre(mesh, i), 0]);
    if (ring && whole) {
      body.moveTo(x + (gear.root + this.rim()) * this.scale, y);
      body.arc(x, y, (gear.root + this.rim()) * this.scale, 0, 2 * Math.PI);
    } else if (ring) {
      // Out to the rim and back along it.
      const ends = [points[points.length - 1], points[0]].map((point) => Math.atan2(point[1], point[0] - centre(mesh, 1)));
      body.arc(x, y, (gear.root + this.rim()) * this.scale, -ends[0], -ends[1], false);
    } else if (!whole) {
      body.lineTo(x, y);
    }
    context.globalAlpha = 0.2;
    context.fillStyle = css(i === 0 ? "--curve-0" : "--curve-1");
    context.fill(body, "evenodd");
    context.globalAlpha = 1;
    context.strokeStyle = context.fillStyle;
    context.lineWidth = 1.4;
    context.setLineDash([]);
    context.stroke(teeth);
    this.circle(i, gear.base / Math.cos(mesh.angle), [6, 4]);
    this.mark([x, y]);
  }

  circle(i, radius, dashes) {
    const { context } = this;
    const [x, y] = this.at([centre(this.mesh, i), 0]);
    context.strokeStyle = css("--muted");
    context.globalAlpha = 0.6;
    context.lineWidth = 1;
    context.setLineDash(dashes);
    context.beginPath();
    context.arc(x, y, radius * this.scale, 0, 2 * Math.PI);
    context.stroke();
    context.globalAlpha = 1;
  }

  /** The centre of a gear. */
  mark([x, y]) {
    const { context } = this;
    context.setLineDash([]);
    context.beginPath();
    context.moveTo(x - 5, y);
    context.lineTo(x + 5, y);
    context.moveTo(x, y - 5);
    context.lineTo(x, y + 5);
    context.stroke();
  }

  /** The line of action, or that of the coast flanks, and on it the path of contact. */
  line(coasts) {
    const { context, mesh } = this;
    const ends = (from, to) => [this.at(onLine(mesh, from, coasts)), this.at(onLine(mesh, to, coasts))];
    const stroke = ([[a, b], [c, d]], width, dashes) => {
      context.lineWidth = width;
      context.setLineDash(dashes);
      context.beginPath();
      context.moveTo(a, b);
      context.lineTo(c, d);
      context.stroke();
    };
    context.strokeStyle = css("--text");
    context.globalAlpha = coasts ? 0.45 : 0.9;
    stroke(ends(-mesh.approach - mesh.pitch, mesh.recess + mesh.pitch), 1, [7, 5]);
    stroke(ends(-mesh.approach, mesh.recess), 2.5, []);
    context.globalAlpha = 1;
  }

  /** A contact: a circle on drive flanks, a square on coast flanks, in the colour of its force. */
  contact({ point, force }) {
    const { context, mesh, state } = this;
    const [x, y] = this.at(point);
    const size = this.whole ? 4 : 6.5;
    context.setLineDash([]);
    context.beginPath();
    if (state.coasts) context.rect(x - size, y - size, 2 * size, 2 * size); else context.arc(x, y, size, 0, 2 * Math.PI);
    // A rim in the colour of the ground, so that it is seen on outlines.
    context.strokeStyle = css("--ground");
    context.lineWidth = 5;
    context.stroke();
    context.fillStyle = force === null ? css("--ground") : forceColour(Math.abs(force) / mesh.force.largest);
    context.fill();
    context.strokeStyle = css("--text");
    context.lineWidth = 1.8;
    context.stroke();
  }
}
