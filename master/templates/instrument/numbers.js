// Numbers as they come in the page, and as people read them.

/** The bytes of a text in base64. */
function bytes(text) {
  return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer;
}

/** Numbers in single precision. */
export function unpacked(text) {
  return new Float32Array(bytes(text));
}

/** Rows of numbers, each in steps of its own: what `rows[row][column]` is. */
export function unpackedRows({ step, steps }) {
  const [ofRows, all] = [unpacked(step), new Int16Array(bytes(steps))];
  const columns = all.length / ofRows.length;
  return Array.from(ofRows, (ofRow, row) =>
    Float32Array.from(all.subarray(row * columns, (row + 1) * columns), (count) => count * ofRow));
}

const PREFIXES = [[1e-9, "n"], [1e-6, "µ"], [1e-3, "m"], [1, ""], [1e3, "k"], [1e6, "M"], [1e9, "G"]];

/** How numbers of a unit up to `largest` are shown: what one shown unit is in SI, and its symbol. */
export function shownUnit(unit, largest) {
  const own = { "1": [1, ""], "1/m": [1, "1/m"], "m/s": [1 / 3.6, "km/h"] }[unit];
  if (own) return { factor: own[0], symbol: own[1] };
  const fitting = PREFIXES.filter(([factor]) => factor <= largest * (1 + 1e-12)).at(-1);
  const [factor, prefix] = largest > 0 && Number.isFinite(largest) ? fitting ?? PREFIXES[0] : [1, ""];
  return { factor, symbol: prefix + unit };
}

/** A number with four digits, without a power of ten. */
export function digits(value) {
  if (value == null || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const decimals = Math.max(0, Math.min(9, 3 - Math.floor(Math.log10(Math.abs(value)))));
  return value.toFixed(decimals).replace("-", "−");
}

/** A number with its unit, such as `173.2 kN`. */
export function withUnit(value, unit) {
  if (value == null || !Number.isFinite(value)) return "–";
  const { factor, symbol } = shownUnit(unit, Math.abs(value));
  return `${digits(value / factor)} ${symbol}`.trim();
}

/** A time in seconds as people read it: to the millisecond, since the page's numbers are in single precision. */
export function seconds(time) {
  return `${Number(time.toFixed(3))} s`;
}

/** The largest size of finite numbers in lists. */
export function largest(...lists) {
  let size = 0;
  for (const list of lists) for (const value of list ?? []) {
    if (Math.abs(value) > size && Number.isFinite(value)) size = Math.abs(value);
  }
  return size;
}

/** The index of the number nearest to `value` in a rising list. */
export function nearest(list, value) {
  let [low, high] = [0, list.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (list[middle] <= value) low = middle; else high = middle;
  }
  return high >= 0 && Math.abs(list[high] - value) < Math.abs(list[low] - value) ? high : low;
}

/** The next 1, 2 or 5 times a power of ten that is not below `value`. */
export function roundUp(value) {
  const decade = 10 ** Math.floor(Math.log10(value));
  return [1, 2, 5, 10].map((step) => step * decade).find((step) => value <= step * (1 + 1e-6));
}
