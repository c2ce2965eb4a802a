// The section of a rail where its foot is warmest or at a probe: the rise of each of its cells, in the colours of the heat map.

import { withUnit } from "./numbers.js";
import { WARMEST, sectionAt, timeInWords } from "./run.js";
import { css, diverging, theme } from "./colours.js";
import { addScale, showScale } from "./heat_map.js";

/** Widest picture, and the room above and below it for words, in CSS pixels. */
const WIDEST = 380;
const ROOM = 22;

/** Adds the section of the chosen rail and probe; gives the function that shows another time or probe. */
export function addSection(parent, run, state) {
  const { field, side } = run.rails[state.rail] ?? {};
  const sections = field?.sections;
  if (!sections) return () => {};
  const figure = parent.appendChild(document.createElement("figure"));
  figure.className = "panel section";
  figure.innerHTML = "<figcaption><strong></strong> <span></span></figcaption><canvas role=\"img\"></canvas><output></output>";
  const [caption, canvas, said] = figure.children;
  const scale = addScale(figure);
  const place = placeCells(sections, Math.min(WIDEST, figure.clientWidth || WIDEST));
  canvas.width = place.width * devicePixelRatio;
  canvas.height = place.height * devicePixelRatio;
  canvas.style.width = `${place.width}px`;
  canvas.style.height = `${place.height}px`;
  const names = side === "right" ? ["gauge side", "field side"] : ["field side", "gauge side"];
  const now = () => sectionAt(sections, state.probe, state.time);
  canvas.addEventListener("pointermove", ({ offsetX, offsetY }) => {
    const cell = place.cellAt(offsetX, offsetY);
    said.textContent = cell == null ? "" : `${placeInWords(sections, cell, names)}: ${withUnit(now().rises[cell], "K")}`;
  });
  canvas.addEventListener("pointerleave", () => { said.textContent = ""; });
  return () => {
    const { time, chainage, rises } = now();
    const [where, kind] = state.probe === WARMEST ? [", where the foot is warmest then", "; the mean of left and right"] : ["", ""];
    const title = `Rise of the section at ${chainage.toFixed(2)} m${where}, ${side} rail, seen in the running direction`;
    caption.firstChild.textContent = title;
    caption.lastChild.textContent = timeInWords("section", time, state.time) + kind;
    canvas.setAttribute("aria-label", `${title}, from ${withUnit(Math.min(...rises), "K")} to ${withUnit(Math.max(...rises), "K")}`);
    paintSection(canvas, sections, rises, place, names, state.heatLimit);
    showScale(scale, state.heatLimit);
  };
}

/** Where a cell lies, in words. */
function placeInWords({ y, z }, cell, names) {
  const aside = Math.abs(1e3 * y[cell]).toFixed(1);
  return `${aside} mm to the ${names[y[cell] < 0 ? 0 : 1]}, ${(1e3 * z[cell]).toFixed(1)} mm deep`;
}

/** Where cells lie on a picture of some width, with the cells of each column and row. */
function placeCells({ y, z, width, height }, pictured) {
  const half = Math.max(...y) + width / 2;
  const deepest = Math.max(...z) + height / 2;
  const pixels = (pictured - 2) / (2 * half);
  const key = (column, row) => `${Math.round(column)} ${Math.round(row)}`;
  const grid = (cell) => [(y[cell] + half) / width - 0.5, z[cell] / height - 0.5];
  const cells = new Map([...y.keys()].map((cell) => [key(...grid(cell)), cell]));
  return {
    width: pictured, height: deepest * pixels + 2 * ROOM, pixels,
    box: (cell) => [1 + (y[cell] + half - width / 2) * pixels, ROOM + (z[cell] - height / 2) * pixels, width * pixels, height * pixels],
    cellAt: (left, top) => cells.get(key(((left - 1) / pixels) / width - 0.5, ((top - ROOM) / pixels) / height - 0.5)),
    neighbour: (cell, across, down) => { const [column, row] = grid(cell); return cells.get(key(column + across, row + down)); },
  };
}

/** Paints the cells, the outline around them, the names of the sides and a measure. */
function paintSection(canvas, sections, rises, place, names, limit) {
  const ctx = canvas.getContext("2d");
  const { ink, faint } = theme();
  ctx.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
  ctx.clearRect(0, 0, place.width, place.height);
  rises.forEach((rise, cell) => {
    const [left, top, width, height] = place.box(cell);
    ctx.fillStyle = css(diverging(rise / limit));
    // On whole pixels, so that no seams shine through.
    const [from, to] = [[left, top], [left + width, top + height]].map((ends) => ends.map((end) => Math.round(end * devicePixelRatio) / devicePixelRatio));
    ctx.fillRect(...from, to[0] - from[0], to[1] - from[1]);
  });
  ctx.strokeStyle = faint;
  ctx.beginPath();
  rises.forEach((_, cell) => {
    const [left, top, width, height] = place.box(cell);
    const [right, base] = [left + width, top + height];
    const side = (across, down, from, to) => {
      if (place.neighbour(cell, across, down) != null) return;
      ctx.moveTo(...from);
      ctx.lineTo(...to);
    };
    side(-1, 0, [left, top], [left, base]);
    side(1, 0, [right, top], [right, base]);
    side(0, -1, [left, top], [right, top]);
    side(0, 1, [left, base], [right, base]);
  });
  ctx.stroke();
  ctx.fillStyle = ink;
  ctx.font = "12px sans-serif";
  ctx.textAlign = "left";
  ctx.fillText(`← ${names[0]}`, 0, 13);
  ctx.textAlign = "right";
  ctx.fillText(`${names[1]} →`, place.width, 13);
  const measure = 0.05 * place.pixels;
  ctx.fillRect(0, place.height - 6, measure, 2);
  ctx.textAlign = "left";
  ctx.fillText("50 mm", measure + 6, place.height - 2);
}
