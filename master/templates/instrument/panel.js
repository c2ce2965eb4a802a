// A panel of the linked view: a drawing of uPlot with title, legend and the cursor and zoom of its group.

import { digits, largest, nearest, shownUnit } from "./numbers.js";
import { band, dashName, line, theme } from "./colours.js";

/** Panels that share their horizontal axis, its cursor and its zoom. */
export class Group {
  /** The axis has the ends `whole` and shows the ends `shown` at first; `label` names it. */
  constructor(name, label, whole, shown = whole) {
    Object.assign(this, { name, label, whole, shown, panels: [] });
  }

  /** Shows a part of the axis in all panels. */
  show(extent) {
    this.shown = extent;
    for (const { plot } of this.panels) this.hold(plot);
  }

  /** Makes a drawing show what the group shows. */
  hold(plot) {
    const [min, max] = this.shown;
    plot.setScale("x", { min, max });
  }

  /** Paints all panels again, whose legends say the values at an abscissa while nobody points at them. */
  repaint(at) {
    for (const panel of this.panels) {
      panel.resting = at == null ? null : nearest(panel.plot.data[0], at);
      panel.plot.redraw(false);
      panel.rest();
    }
  }

  /** Shows a part that is so many times as long, about its middle, within the whole. */
  zoom(times) {
    const [middle, half] = [(this.shown[0] + this.shown[1]) / 2, (this.shown[1] - this.shown[0]) / 2];
    const [min, max] = [middle - times * half, middle + times * half];
    this.show([Math.max(min, this.whole[0]), Math.min(max, this.whole[1])]);
  }

  clear() {
    for (const { plot } of this.panels) plot.destroy();
    this.panels = [];
  }
}

/** Width that a drawing has in its figure. */
function widthOf(figure) {
  return Math.max(240, Math.floor(figure.clientWidth));
}

/**
 * Adds a panel to a group.
 *
 * `x` are the abscissae, `curves` have label, unit, value and perhaps lowest and highest, `right` (shown on the
 * right axis), `stepped` or `points`. `draw` paints over or under the curves; `note` stands behind the title.
 */
export function addPanel(group, parent, { title, note, x, curves, height, draw, under, onClick, range, downwards }) {
  const figure = document.createElement("figure");
  figure.className = "panel";
  const caption = figure.appendChild(document.createElement("figcaption"));
  const place = figure.appendChild(document.createElement("div"));
  place.setAttribute("role", "img");
  parent.append(figure);
  const shown = curves.filter((curve) => curve?.value);
  const units = [false, true].map((right) => unitOf(shown.filter((curve) => Boolean(curve.right) === right)));
  const { series, bands, data } = lines(shown, units);
  const [left, right] = units.map(({ symbol }) => symbol);
  const text = title + (left && `, ${left}`) + (right && `; right axis ${right}`);
  caption.innerHTML = "<strong></strong> <span></span>";
  caption.firstChild.textContent = text;
  caption.lastChild.textContent = note ?? "";
  place.setAttribute("aria-label", `${text}, over ${group.label}: ${shown.map((curve) => curve.label).join(", ")}`);
  const edge = innerWidth < 600 ? 44 : 56;
  const axis = (scale, side) => ({
    scale, side, stroke: () => theme().ink, font: "12px sans-serif",
    grid: { show: side !== 1, stroke: () => theme().grid, width: 1 }, ticks: { stroke: () => theme().grid, width: 1 },
  });
  const vertical = (scale, side) => ({
    ...axis(scale, side), values: (_, ticks) => ticks.map(tick),
    // All vertical axes are equally wide, so that panels lie below each other.
    size: edge, space: 24,
  });
  const usesRight = shown.some((curve) => curve.right);
  const options = {
    width: widthOf(place), height: height ?? 150, padding: [8, usesRight ? 0 : edge, 0, 0],
    scales: { x: { time: false, auto: false }, y: { range: range ?? padded, dir: downwards ? -1 : 1 }, right: { range: padded } },
    axes: [
      { ...axis("x", 2), label: group.label, labelSize: 18, labelFont: "12px sans-serif", size: 30, space: 60,
        values: (_, ticks) => ticks.map(tick) },
      vertical("y", 3), ...(usesRight ? [vertical("right", 1)] : []),
    ],
    series: [{ label: group.label, value: (_, value) => digits(value) }, ...series],
    bands, legend: { live: true, markers: { width: 3, dash: (plot, index) => dashName(plot.series[index].dash) } },
    cursor: {
      sync: { key: group.name, scales: ["x", null] }, drag: { x: true, y: false }, points: { size: 6 },
      bind: { dblclick: () => () => group.show(group.whole) },
    },
    hooks: {
      drawAxes: under ? [under] : [], draw: draw ? [draw] : [],
      setScale: [(plot, key) => {
        const { min, max } = plot.scales.x;
        const [begin, end] = group.shown;
        if (key === "x" && min != null && (min !== begin || max !== end)) group.show([min, max]);
      }],
      setCursor: [(plot) => plot.cursor.idx == null && panel?.rest()],
    },
  };
  let panel = null;
  const plot = new uPlot(options, [x, ...data], place);
  group.hold(plot);
  if (onClick) plot.over.addEventListener("click", () => plot.cursor.left >= 0 && onClick(plot.posToVal(plot.cursor.left, "x")));
  panel = {
    plot, figure, resting: null, height: options.height,
    /** Replaces the curves by others of the same units. */
    setCurves(abscissae, next) {
      plot.setData([abscissae, ...lines(next.filter((curve) => curve?.value), units).data], false);
      plot.redraw();
      // A redrawing keeps the axis as it is, which is not yet what it shall be while the panel is new.
      group.hold(plot);
    },
    /** Says the resting values, once uPlot has said that it has none. */
    rest() { queueMicrotask(() => plot.cursor.idx == null && plot.setLegend({ idx: panel.resting }, false)); },
    setNote(words) { caption.lastChild.textContent = words; },
    fit(width) { plot.setSize({ width: width ?? widthOf(place), height: options.height }); },
  };
  group.panels.push(panel);
  return panel;
}

/** The unit in which curves are shown. */
function unitOf(curves) {
  if (!curves.length) return { factor: 1, symbol: "" };
  const sizes = curves.map(({ size, value, lowest, highest }) => size ?? largest(value, lowest, highest));
  return shownUnit(curves[0].unit, Math.max(...sizes));
}

/** Series, bands and data of uPlot for curves with their extremes. */
function lines(curves, units) {
  const [series, bands, data] = [[], [], []];
  curves.forEach((curve, index) => {
    const { factor, symbol } = units[curve.right ? 1 : 0];
    const scaled = (values) => Array.from(values, (value) => Number.isFinite(value) ? value / factor : null);
    const style = { ...line(curve.line ?? index), scale: curve.right ? "right" : "y", spanGaps: false };
    if (curve.stepped) style.paths = uPlot.paths.stepped({ align: 1 });
    style.points = { show: curve.points ?? false, size: 5 };
    const value = (_, number) => number == null ? "–" : `${digits(number)} ${symbol}`.trim();
    series.push({ ...style, label: curve.label, value });
    data.push(scaled(curve.value));
    if (curve.lowest && curve.highest) {
      const edge = { ...style, width: 0, dash: [], points: { show: false }, value };
      series.push({ ...edge, label: "highest" }, { ...edge, label: "lowest" });
      data.push(scaled(curve.highest), scaled(curve.lowest));
      bands.push({ series: [series.length - 1, series.length], fill: band(curve.line ?? index) });
    }
  });
  return { series, bands, data };
}

/** A range with a little room, never empty. */
function padded(_, min, max) {
  if (min == null) return [0, 1];
  const room = Math.max(0.06 * (max - min), 1e-3 * Math.max(Math.abs(min), Math.abs(max)), max === min ? 0.5 : 0);
  return [min - room, max + room];
}

/** A number of an axis, with no more digits than it needs. */
function tick(value) {
  return value == null ? "" : String(Number(value.toPrecision(6))).replace("-", "−");
}

/** Paints a vertical line at an abscissa, in the pixels of the drawing. */
export function verticalLine(plot, at, colour) {
  const { ctx, bbox } = plot;
  const left = plot.valToPos(at, "x", true);
  if (left < bbox.left || left > bbox.left + bbox.width) return;
  ctx.save();
  ctx.strokeStyle = colour;
  ctx.lineWidth = 1.5 * devicePixelRatio;
  ctx.beginPath();
  ctx.moveTo(left, bbox.top);
  ctx.lineTo(left, bbox.top + bbox.height);
  ctx.stroke();
  ctx.restore();
}
