// The geometry of a mesh at an instant: where its outlines are, and where they touch. Lengths in the unit of the mesh; the driving gear
// turns about the origin, counterclockwise, and the centre of the other gear is on the x axis, as in gear/outline.rs.

// A mesh with less than this share of its largest force is not in contact. Embedded forces have rounding errors of 1/131,000 of the range
// of a block.
const NO_FORCE = 1e-4;

/** The value at `at`, by linear interpolation between the rows; at the time of an event, the value after it. */
function between(x, values, at) {
  const i = lowerBound(x, at);
  if (i === 0 || i === x.length || x[i] === at) return values[nearest(x, at)];
  const part = (at - x[i - 1]) / (x[i] - x[i - 1]);
  return values[i - 1] + part * (values[i] - values[i - 1]);
}

/** The angles of both gears, the positions of their flanks and their contacts at the time t; deflection and play `magnified` times. */
function instant(mesh, times, t, magnified) {
  const row = (of) => between(times, column(of).values, t);
  const [rotation, lead] = [row(mesh.rotation), row(mesh.lead)];
  const force = mesh.force ? row(mesh.force.values) : null;
  const [one, two] = mesh.gears;
  // X of the flanks of one pair on the line of action: of the driving gear, and of the other, which lags by the lead.
  const x = [one.base * rotation + mesh.begin, 0];
  x[1] = x[0] - magnified * lead;
  const angles = mesh.gears.map(({ base, place }, i) => x[i] / base + place);
  const thin = taken(mesh, magnified);
  const coasts = mesh.play !== null && (force ?? lead) < 0;
  const touches = force !== null ? Math.abs(force) > NO_FORCE * mesh.force.largest : mesh.play === null || Math.abs(lead) >= mesh.play / 2;
  const state = { t, rotation, lead, force, angles, thin, coasts, contacts: [] };
  if (!touches || !Number.isFinite(angles[0] + angles[1])) return state;
  // The middle between both flanks, `magnified` times. The pairs in contact are found without magnification.
  const middle = (magnified) => coasts
    ? -(x[0] + 2 * one.place * one.base) - taken(mesh, magnified).coast + magnified * (mesh.play / 2 + lead) / 2
    : x[0] - magnified * lead / 2;
  const [real, drawn] = [middle(1), middle(magnified)];
  const first = Math.ceil((-mesh.approach - real) / mesh.pitch);
  for (let n = first; real + n * mesh.pitch <= mesh.recess; n++) state.contacts.push({ x: drawn + n * mesh.pitch, point: onLine(mesh, drawn + n * mesh.pitch, coasts) });
  state.contacts.forEach((contact) => { contact.force = force === null ? null : force / state.contacts.length; });
  return state;
}

/**
 * The length by which each flank is thinned for the play: half of the play for each gear, shared by its two flanks. The given teeth may
 * already have some play (`clearance`), which is subtracted on the coast side.
 */
function taken(mesh, magnified) {
  if (mesh.play === null) return { drive: 0, coast: 0 };
  const quarter = magnified * mesh.play / 4;
  return { drive: quarter, coast: quarter - mesh.clearance / 2 };
}

/** The point of the line of action at x, or of the line of the coast flanks. */
function onLine(mesh, x, coasts) {
  const pitchPoint = mesh.gears[0].base / Math.cos(mesh.angle);
  return [pitchPoint + x * Math.sin(mesh.angle), (coasts ? -1 : 1) * x * Math.cos(mesh.angle)];
}

/** The x coordinate of the axis of gear i. */
function centre(mesh, i) {
  const [one, two] = mesh.gears.map(({ base }) => base / Math.cos(mesh.angle));
  return i === 0 ? 0 : mesh.internal ? one - two : one + two;
}

/** The point of gear i at a radius and an angle in its direction of rotation, from the line through both centres. */
function place(mesh, i, radius, angle) {
  const external = i === 1 && !mesh.internal;
  return [centre(mesh, i) + (external ? -1 : 1) * radius * Math.cos(angle), radius * Math.sin(angle)];
}

/** The outline of gear i over the teeth (of a ring: spaces) whose middles are at most `reach` from the line through both centres. */
function outline(mesh, i, state, reach) {
  const gear = mesh.gears[i], ring = i === 1 && mesh.internal;
  const { drive, coast } = state.thin;
  // Shifts of the flank behind and of the flank ahead. The driving gear is loaded on its flank ahead, the driven gear on its flank behind,
  // and a ring on the flank ahead of its space. A thinner tooth of a ring is a wider space.
  const [behind, ahead] = i === 0 ? [coast, -drive] : ring ? [-coast, drive] : [drive, -coast];
  const pitch = 2 * Math.PI / gear.teeth;
  const all = reach >= Math.PI;
  const middle = state.angles[i] - pitch * Math.round(state.angles[i] / pitch);
  const most = all ? Math.floor((gear.teeth - 1) / 2) : Math.min(Math.ceil(reach / pitch), Math.floor((gear.teeth - 1) / 2));
  const least = all ? most - gear.teeth + 1 : -most;
  const points = [];
  for (let k = least; k <= most; k++) {
    const at = middle + k * pitch;
    for (const [radius, half] of gear.half) points.push(place(mesh, i, radius, at - half + behind / gear.base));
    for (let j = gear.half.length - 1; j >= 0; j--) points.push(place(mesh, i, gear.half[j][0], at + gear.half[j][1] + ahead / gear.base));
  }
  return { points, whole: 2 * most + 1 >= gear.teeth || all };
}
