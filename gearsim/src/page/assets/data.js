// The numbers of the page: decodes embedded columns, and reduces curves to what the screen can show.

// Values in a block of a column, as in data.rs.
const BLOCK = 1024;
// Counts in a group, as in pack.rs.
const GROUP = 64;
// Number of rows for which the lowest and the highest value are computed in advance.
const STEP = 64;

const decoded = new Map();
// Columns in base64 that came after the page was loaded. A page that shows many runs in turn has them here, not in elements.
const received = new Map();

/** The column of a specification: its values, and the indices of the extremes of every STEP values. Decoded once, when first drawn. */
function column({ id, length, bits }) {
  if (!decoded.has(id)) {
    const bytes = fromBase64(received.get(id) ?? document.getElementById(id).textContent);
    const blocks = Math.ceil(length / BLOCK);
    const head = new Float64Array(bytes.buffer, 0, 2 * blocks);
    const counts = unpack(bytes, 16 * blocks, length);
    const none = 2 ** bits - 1;
    const values = new Float64Array(length);
    for (let block = 0; block < blocks; block++) {
      const offset = head[2 * block], scale = head[2 * block + 1];
      const end = Math.min(length, (block + 1) * BLOCK);
      for (let i = block * BLOCK; i < end; i++) values[i] = counts[i] === none ? NaN : offset + scale * counts[i];
    }
    decoded.set(id, { values, ...level(values) });
  }
  return decoded.get(id);
}

/** Unpacks `length` counts that pack.rs has packed, from the byte `at` on. */
function unpack(bytes, at, length) {
  const counts = new Uint32Array(length);
  let last = 0, before = 0;
  for (let i = 0; i < length;) {
    const end = Math.min(length, i + GROUP), order = bytes[at] >> 6, width = bytes[at] & 63;
    at++;
    // The bits that are read but not yet used, as a number, and how many they are. If entries are wide, they may be more than 32 bits,
    // which is too many for bitwise operators.
    let open = 0, have = 0;
    const wide = width > 24, size = 2 ** width;
    for (; i < end; i++) {
      let entry;
      if (wide) {
        for (; have < width; have += 8) open += bytes[at++] * 2 ** have;
        entry = open % size;
        open = Math.floor(open / size);
      } else {
        for (; have < width; have += 8) open |= bytes[at++] << have;
        entry = open & (size - 1);
        open >>>= width;
      }
      have -= width;
      const difference = (entry >>> 1) ^ -(entry & 1);
      const count = order === 0 ? entry : order === 1 ? last + difference : 2 * last - before + difference;
      counts[i] = count;
      before = last;
      last = count;
    }
  }
  return counts;
}

function fromBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

/** The indices of the lowest and of the highest value in every STEP values. */
function level(values) {
  const steps = Math.ceil(values.length / STEP);
  const low = new Uint32Array(steps), high = new Uint32Array(steps);
  for (let k = 0; k < steps; k++) {
    const end = Math.min(values.length, (k + 1) * STEP);
    [low[k], high[k]] = scan(values, k * STEP, end);
  }
  return { low, high };
}

/** The indices of the lowest and of the highest value from a to before b; a if no value is a number. */
function scan(values, a, b) {
  let low = a, high = a;
  for (let i = a + 1; i < b; i++) {
    if (values[i] < values[low] || Number.isNaN(values[low])) low = i;
    if (values[i] > values[high] || Number.isNaN(values[high])) high = i;
  }
  return [low, high];
}

/** The indices of the extremes from a to before b, from the extremes computed in advance where possible. */
function extremes({ values, low, high }, a, b) {
  const first = Math.ceil(a / STEP), last = Math.floor(b / STEP);
  if (first >= last) return scan(values, a, b);
  let [lowest, highest] = scan(values, a, first * STEP === a ? a + 1 : first * STEP);
  const consider = (i, j) => {
    if (values[i] < values[lowest] || Number.isNaN(values[lowest])) lowest = i;
    if (values[j] > values[highest] || Number.isNaN(values[highest])) highest = j;
  };
  for (let k = first; k < last; k++) consider(low[k], high[k]);
  if (last * STEP < b) consider(...scan(values, last * STEP, b));
  return [lowest, highest];
}

/** The first index whose value is not below x, in values that do not decrease. */
function lowerBound(values, x) {
  let a = 0, b = values.length;
  while (a < b) {
    const middle = (a + b) >> 1;
    if (values[middle] < x) a = middle + 1; else b = middle;
  }
  return a;
}

/** The index of the value nearest to x; of equal values the last, which is the state after an event. */
function nearest(values, x) {
  let i = Math.min(lowerBound(values, x), values.length - 1);
  if (i > 0 && x - values[i - 1] < values[i] - x) i--;
  while (i + 1 < values.length && values[i + 1] === values[i]) i++;
  return i;
}

/**
 * The points to draw of a curve between two abscissae: every row while there are few, else the lowest and the highest value of
 * each of `pixels` parts. One row beyond each end is included, so that the curve reaches the frame.
 */
function visible(x, y, from, to, pixels) {
  const a = Math.max(0, lowerBound(x.values, from) - 1);
  const b = Math.min(x.values.length, lowerBound(x.values, to) + 2);
  const points = { x: [], y: [], rows: b - a, all: b - a <= 4 * pixels };
  const add = (i) => { points.x.push(x.values[i]); points.y.push(y.values[i]); };
  if (points.all) {
    for (let i = a; i < b; i++) add(i);
    return points;
  }
  for (let k = 0; k < pixels; k++) {
    const begin = a + Math.floor(k * (b - a) / pixels), end = a + Math.floor((k + 1) * (b - a) / pixels);
    const [low, high] = extremes(y, begin, end);
    add(Math.min(low, high));
    if (low !== high) add(Math.max(low, high));
  }
  return points;
}
