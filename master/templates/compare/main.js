// Curves of two or more runs on each other, and below them their differences.

import { unpacked } from "../instrument/numbers.js";
import { onTheme } from "../instrument/colours.js";
import { addPanel, Group } from "../instrument/panel.js";

const byId = (id) => document.getElementById(id);
const { names, curves } = JSON.parse(byId("numbers").textContent);

/** The curves of the chosen column. */
class Overlay {
  constructor() {
    this.group = new Group("compare", "time in s", [0, 1]);
    this.fillChoice();
    onTheme((printing) => {
      this.show();
      if (printing === true) for (const panel of this.group.panels) panel.fit(680);
    });
    new ResizeObserver(() => { for (const panel of this.group.panels) panel.fit(); }).observe(byId("overlay"));
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
    const all = values.map((packed) => packed && unpacked(packed));
    const end = x.at(-1) > x[0] ? x.at(-1) : x[0] + 1;
    Object.assign(this.group, { whole: [x[0], end], shown: [x[0], end] });
    this.group.clear();
    const place = byId("overlay");
    place.replaceChildren();
    const curve = (value, index) => ({ value, unit, label: names[index], line: index });
    addPanel(this.group, place, { title: signal, x, curves: all.map(curve), height: 260 });
    const differences = all.map((value, index) => index && value && value.map((number, at) => number - all[0][at]));
    const title = `Difference from ${names[0]}`;
    addPanel(this.group, place, { title, x, curves: differences.map((value, index) => value && curve(value, index)), height: 180 });
  }
}

if (curves.length) {
  byId("curves").hidden = false;
  window.overlay = new Overlay();
}
