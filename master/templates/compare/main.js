// Curves of two or more runs on each other, over time and along the rails, and below them their differences.

import { seconds, unpacked } from "../instrument/numbers.js";
import { onTheme } from "../instrument/colours.js";
import { addPanel, Group } from "../instrument/panel.js";

const byId = (id) => document.getElementById(id);
const { names, curves, along } = JSON.parse(byId("numbers").textContent);

/** Adds the curves of all runs to a group, and below them their differences from the first. */
function addCurves(group, place, { title, unit, x, values, height }) {
  const all = values.map((packed) => packed && unpacked(packed));
  const curve = (value, index) => value && { value, unit, label: names[index], line: index };
  addPanel(group, place, { title, x, curves: all.map(curve), height });
  const differences = all.map((value, index) => index && value && value.map((number, at) => number - all[0][at]));
  addPanel(group, place, { title: `Difference from ${names[0]}`, x, curves: differences.map(curve), height: 0.7 * height });
}

/** Makes the panels of a group as wide as their place, whenever that changes, and anew when the colours do. */
function keepFitting(group, place, show) {
  onTheme((printing) => {
    show();
    if (printing === true) for (const panel of group.panels) panel.fit(680);
  });
  new ResizeObserver(() => { for (const panel of group.panels) panel.fit(); }).observe(place);
}

/** The rises along the rails. */
class AlongRails {
  constructor() {
    const chainages = along.flatMap(({ chainage }) => { const x = unpacked(chainage); return [x[0], x.at(-1)]; });
    this.group = new Group("along-rails", "chainage in m", [Math.min(...chainages), Math.max(...chainages)]);
    byId("whole-rail").addEventListener("click", () => this.group.show(this.group.whole));
    keepFitting(this.group, byId("along-rails"), () => this.show());
    this.show();
  }

  show() {
    this.group.clear();
    const place = byId("along-rails");
    place.replaceChildren();
    for (const { field, level, depth, time, chainage, values } of along) {
      const title = `Rise of the ${level} (${(1e3 * depth).toFixed(1)} mm deep) in ${field} at ${seconds(time)}`;
      addCurves(this.group, place, { title, unit: "K", x: unpacked(chainage), values, height: 200 });
    }
  }
}

/** The curves of the chosen column. */
class Overlay {
  constructor() {
    this.group = new Group("compare", "time in s", [0, 1]);
    this.fillChoice();
    keepFitting(this.group, byId("overlay"), () => this.show());
    byId("whole").addEventListener("click", () => this.group.show(this.group.whole));
    this.show();
  }

  /** Lists the columns by their tables, and chooses the one that differs most. */
  fillChoice() {
    const select = byId("signal");
    const size = ({ relative }) => relative ?? Infinity;
    const worst = curves.reduce((best, curve) => size(curve) > size(best) ? curve : best);
    for (const table of new Set(curves.map((curve) => curve.table))) {
      const group = Object.assign(document.createElement("optgroup"), { label: table });
      curves.forEach((curve, index) => {
        if (curve.table === table) group.append(new Option(curve.column, index, false, curve === worst));
      });
      select.append(group);
    }
    select.addEventListener("change", () => this.show());
    for (const button of document.querySelectorAll("button[data-column]")) {
      const index = curves.findIndex(({ table, column }) => `${table}.${column}` === button.dataset.column);
      button.disabled = index < 0;
      button.addEventListener("click", () => {
        select.value = index;
        this.show();
        byId("curves").scrollIntoView();
      });
    }
  }

  show() {
    const { signal, unit, time, values } = curves[byId("signal").value];
    const x = unpacked(time);
    const end = x.at(-1) > x[0] ? x.at(-1) : x[0] + 1;
    Object.assign(this.group, { whole: [x[0], end], shown: [x[0], end] });
    this.group.clear();
    const place = byId("overlay");
    place.replaceChildren();
    addCurves(this.group, place, { title: signal, unit, x, values, height: 260 });
  }
}

if (curves.length) {
  byId("curves").hidden = false;
  window.overlay = new Overlay();
}
if (along.length) {
  byId("along").hidden = false;
  window.alongRails = new AlongRails();
}
