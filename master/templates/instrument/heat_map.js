// The temperature rise over chainage and depth, in colours that have the paper's at zero.

import { nearest, roundUp, shownUnit, withUnit } from "./numbers.js";
import { actualTime, snapshot } from "./run.js";
import { css, diverging, theme } from "./colours.js";
import { addPanel, verticalLine } from "./panel.js";

/** Adds the heat map of a rail; gives the function that shows another time. */
export function addHeatMap(group, parent, run, state, rail) {
  const { field, side } = rail;
  const bottom = 1e3 * bottomOf(field.depth);
  const value = (plot, chainage) => riseAt(field, state, chainage);
  const panel = addPanel(group, parent, {
    title: `Temperature rise above the initial state over depth, ${side} rail`, height: 240, x: field.chainage,
    curves: [{ label: "rise at the chosen depth", unit: "1", value: field.chainage.map(() => -1) }],
    range: () => [0, bottom], downwards: true,
    under: (plot) => paint(plot, field, state, bottom),
    draw: (plot) => {
      horizontalLine(plot, 1e3 * field.depth[state.depth]);
      verticalLine(plot, state.chainage ?? NaN, theme().faint);
    },
    onClick: (chainage) => state.chooseChainage(chainage),
  });
  // The curve lies outside the picture; the legend tells the rise under the cursor.
  panel.plot.series[1].value = (_, _number, _series, index) => index == null ? "–" : withUnit(value(panel.plot, field.chainage[index]), "K");
  const scale = addScale(panel.figure);
  return () => {
    panel.plot.redraw(false);
    panel.setNote(`depth in mm; ${actualTime(field, state.time)}`);
    showScale(scale, state.heatLimit);
  };
}

/** Depth at which the lowest row ends, m. */
function bottomOf(depth) {
  return depth.length > 1 ? depth.at(-1) + (depth.at(-1) - depth.at(-2)) / 2 : 2 * depth[0];
}

/** The rise at the chosen depth, K. */
export function riseAt(field, state, chainage) {
  return snapshot(field, state.time).rows[state.depth][nearest(field.chainage, chainage)];
}

/** A limit of the colours that shows most of what is warm or cold at some time: 1, 2 or 5 times a power of ten, K. */
export function heatLimits(rails) {
  const sizes = [];
  for (const { field } of rails) for (const row of field?.rows ?? []) for (const rise of row) {
    if (Math.abs(rise) > 1e-6) sizes.push(Math.abs(rise));
  }
  if (!sizes.length) return { limits: [1e-3], chosen: 0 };
  sizes.sort((a, b) => a - b);
  const [highest, usual] = [sizes.at(-1), sizes[Math.floor(0.95 * sizes.length)]].map(roundUp);
  const limits = [highest];
  while (limits.at(-1) > 2e-6 && limits.length < 18) limits.push(roundUp(limits.at(-1) / 2.6));
  return { limits, chosen: Math.max(0, limits.findIndex((limit) => limit <= usual * (1 + 1e-6))) };
}

/** Paints the field: a column for each element or some, a row for each depth. */
function paint(plot, field, state, bottom) {
  const { rows } = snapshot(field, state.time);
  const [columns, depths] = [field.chainage.length, field.depth.length];
  const picture = new ImageData(columns, depths);
  rows.forEach((row, depth) => row.forEach((rise, column) => {
    picture.data.set([...diverging(rise / state.heatLimit), 255], 4 * (depth * columns + column));
  }));
  const small = new OffscreenCanvas(columns, depths);
  small.getContext("2d").putImageData(picture, 0, 0);
  const { ctx, bbox } = plot;
  const x = (chainage) => plot.valToPos(chainage, "x", true);
  const y = (millimetres) => plot.valToPos(millimetres, "y", true);
  const half = columns > 1 ? (field.chainage[1] - field.chainage[0]) / 2 : 0.5;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.imageSmoothingEnabled = false;
  const [left, right] = [x(field.chainage[0] - half), x(field.chainage.at(-1) + half)];
  // Rows are as high as their cells, whose edges lie midway between their middles.
  for (let depth = 0; depth < depths; depth++) {
    const edge = (above) => 500 * (field.depth[above] + field.depth[above + 1]);
    const top = y(depth ? edge(depth - 1) : 0);
    const base = y(depth + 1 < depths ? edge(depth) : bottom);
    ctx.drawImage(small, 0, depth, columns, 1, left, top, right - left, base - top + 0.5);
  }
  ctx.restore();
}

function horizontalLine(plot, millimetres) {
  const { ctx, bbox } = plot;
  const y = plot.valToPos(millimetres, "y", true);
  ctx.save();
  ctx.strokeStyle = theme().faint;
  ctx.setLineDash([6 * devicePixelRatio, 4 * devicePixelRatio]);
  ctx.lineWidth = devicePixelRatio;
  ctx.beginPath();
  ctx.moveTo(bbox.left, y);
  ctx.lineTo(bbox.left + bbox.width, y);
  ctx.stroke();
  ctx.restore();
}

/** Adds the place of a colour scale to a figure. */
export function addScale(figure) {
  const scale = figure.appendChild(document.createElement("div"));
  scale.className = "colour-scale";
  return scale;
}

/** The colours between the limits, with their numbers. */
export function showScale(element, limit) {
  const { factor, symbol } = shownUnit("K", limit);
  const stops = Array.from({ length: 21 }, (_, index) => css(diverging(index / 10 - 1)));
  element.innerHTML = "<span></span><span class=\"colours\" role=\"img\"></span><span></span>";
  const [low, colours, high] = element.children;
  const number = Number((limit / factor).toPrecision(3));
  low.textContent = `−${number} ${symbol}`;
  high.textContent = `+${number} ${symbol}`;
  colours.style.background = `linear-gradient(90deg, ${stops.join(", ")})`;
  colours.setAttribute("aria-label", `Colours from ${low.textContent} over zero to ${high.textContent}`);
}
