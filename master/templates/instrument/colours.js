// Colours on a light and on a dark page, told apart without colour vision and in grey.

const dark = matchMedia("(prefers-color-scheme: dark)");
let isPrinting = false;

/** Whether the page is dark now; paper never is. */
function isDark() {
  return dark.matches && !isPrinting;
}

/** Colours of ink, grid and paper as the page has them now. */
export function theme() {
  return isDark()
    ? { ink: "#d6dade", faint: "#8b939b", grid: "#33393f", paper: [22, 25, 29], train: "#8b939b40" }
    : { ink: "#3c3c3c", faint: "#777777", grid: "#e4e4e4", paper: [255, 255, 255], train: "#77777730" };
}

/** Calls back when the page becomes dark or light, or is printed on white paper. */
export function onTheme(changed) {
  dark.addEventListener("change", changed);
  const print = (printing) => () => { isPrinting = printing; changed(printing); };
  addEventListener("beforeprint", print(true));
  addEventListener("afterprint", print(false));
}

// The set of Okabe and Ito (2008), on a dark page with its lighter colours first.
const ON_LIGHT = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00"];
const ON_DARK = ["#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#0072b2", "#f0e442"];
const DASHES = [[], [8, 4], [2, 4]];

function colour(index) {
  return (isDark() ? ON_DARK : ON_LIGHT)[index % ON_LIGHT.length];
}

/** Colour, pattern and width of the line with this number; one that may lie on others is thinner. */
export function line(index) {
  return { stroke: colour(index), dash: DASHES[index % 3], width: [2.5, 1.8, 1.8][index % 3] };
}

/** The pattern of a line as CSS names that of a border. */
export function dashName(dash) {
  return ["solid", "dashed", "dotted"][Math.max(0, DASHES.findIndex((pattern) => pattern[0] === dash?.[0]))];
}

/** The colour of a line as a band behind it. */
export function band(index) {
  return `${colour(index)}38`;
}

// From the paper outwards: cooling is blue, warming is orange to brown.
const COOL = [[158, 202, 225], [33, 113, 181], [8, 48, 107]];
const WARM = [[253, 208, 162], [230, 85, 13], [127, 39, 4]];

/** The colour of a share between −1 and 1 of the scale, the paper's at zero, as red, green and blue. */
export function diverging(share) {
  const { paper } = theme();
  const side = share < 0 ? COOL : WARM;
  const stops = paper[0] < 128 ? [paper, ...side.toReversed()] : [paper, ...side];
  const position = Math.min(Math.abs(share), 1) * (stops.length - 1);
  const before = Math.min(Math.floor(position), stops.length - 2);
  const weight = position - before;
  return stops[before].map((from, channel) => Math.round(from + weight * (stops[before + 1][channel] - from)));
}

/** A colour as CSS has it. */
export function css([red, green, blue]) {
  return `rgb(${red} ${green} ${blue})`;
}
