// The linked view: one time, one chainage, one vehicle, one wheel and one rail for all of its panels.

import { nearest, seconds, withUnit } from "./numbers.js";
import { WARMEST, actualTime, firstSection, instant, leftOut, readRun, sectionAt, snapshot, vehicleOverTime, warmest, warmestFoot } from "./run.js";
import { onTheme } from "./colours.js";
import { Group } from "./panel.js";
import { addAlongTrack, extentsAlong, wheelName } from "./along_track.js";
import { heatLimits, riseAt } from "./heat_map.js";
import { addSection } from "./section.js";
import { addFoot, addOverDepth, addOverTime } from "./over_time.js";

const byId = (id) => document.getElementById(id);

/** The linked view of the page. */
class View {
  constructor(run) {
    const end = run.all.time.at(-1);
    const { limits, chosen } = heatLimits(run.rails);
    Object.assign(this, { run, time: end, vehicle: run.recorded.keys().next().value ?? 1, wheel: 0, rail: 0, depth: 0, limits, heatLimit: limits[chosen] });
    const field = run.rails[0]?.field;
    const foot = field && warmestFoot(field);
    // The first look is at the warmest foot, if it warms after the run, else at the end of the run.
    if (foot?.time > end) this.time = foot.time;
    if (foot) this.depth = field.depth.length - 1;
    this.probe = field?.sections ? firstSection(field.sections) : 0;
    this.chainage = field ? (foot ?? warmest(field, 0))?.chainage ?? field.chainage[0] : null;
    const times = [run.all.time[0], end];
    const { whole, shown } = extentsAlong(run);
    this.along = new Group("along", "chainage in m", whole, shown);
    this.over = new Group("over", "time in s", times[1] > times[0] ? times : [times[0], times[0] + 1]);
    const feet = run.rails.flatMap((rail) => rail.foot?.time.at(-1) ?? []);
    this.whole = new Group("whole", "time in min", [0, Math.max(...feet, 60) / 60]);
    const deepest = Math.max(...run.rails.flatMap(({ field }) => field?.depth.at(-1) ?? []), 0.01);
    this.deep = new Group("deep", "depth below the running surface in mm", [0, 1e3 * deepest]);
    this.groups = [this.along, this.over, this.whole, this.deep];
    this.fillChoices();
    this.rebuild();
    byId("left-out").textContent = leftOut(run);
  }

  /** Lists what can be chosen, and listens to the choices. */
  fillChoices() {
    const { run } = this;
    const fill = (id, options, chosen, choose) => {
      const select = byId(id);
      select.replaceChildren(...options.map(([value, text]) => new Option(text, value, false, value === chosen)));
      select.closest("label").hidden = options.length < 2;
      select.addEventListener("change", () => choose(Number(select.value)));
    };
    const vehicles = Array.from({ length: run.vehicles }, (_, index) => index + 1);
    const kind = (number) => `${number}${run.locomotives.includes(number) ? " locomotive" : ""}${run.recorded.has(number) ? ", all records" : ""}`;
    fill("vehicle", vehicles.map((number) => [number, kind(number)]), this.vehicle, (number) => this.chooseVehicle(number));
    fill("rail", run.rails.map(({ side }, index) => [index, side]), this.rail, (rail) => { this.rail = rail; this.fillField(); this.rebuild(); });
    fill("wheel", run.wheels.map((wheel, index) => [index, wheelName(wheel)]), this.wheel, (wheel) => { this.wheel = wheel; this.rebuild(); });
    fill("heat-limit", this.limits.map((limit) => [limit, `±${withUnit(limit, "K")}`]), this.heatLimit, (limit) => { this.heatLimit = limit; this.update(); });
    const { chainage: probes = [], warmest: hasWarmest } = run.rails[0]?.field?.sections ?? {};
    const places = [...probes].map((chainage, probe) => [probe, `${chainage.toFixed(2)} m`]);
    if (hasWarmest) places.unshift([WARMEST, "warmest foot"]);
    fill("probe", places, this.probe, (probe) => { this.probe = probe; this.update(); });
    byId("depth").addEventListener("change", ({ target }) => { this.depth = Number(target.value); this.update(); });
    this.fillField();
    const slider = byId("time");
    slider.max = run.moments.length - 1;
    slider.addEventListener("input", () => this.setTime(run.moments[slider.value]));
    byId("zoom").addEventListener("click", ({ target }) => this.zoom(target.dataset.zoom));
    onTheme((printing) => {
      this.rebuild();
      // Paper is narrower than a window: two panels beside each other fit on it.
      if (printing === true) for (const { panels } of this.groups) for (const panel of panels) panel.fit(340);
    });
    new ResizeObserver(() => { for (const { panels } of this.groups) for (const panel of panels) panel.fit(); }).observe(byId("along-track"));
  }

  /** Lists depths and times of the chosen rail's field. */
  fillField() {
    const { run } = this;
    const field = run.rails[this.rail]?.field;
    byId("depth").closest("label").hidden = !field;
    const shortcuts = byId("times");
    shortcuts.replaceChildren();
    if (!field) return;
    const depths = [...field.depth].map((depth, index) => new Option(`${(1e3 * depth).toFixed(1)} mm`, index, false, index === this.depth));
    byId("depth").replaceChildren(...depths);
    const foot = warmestFoot(field);
    const last = Math.max(field.time.at(-1), run.all.time.at(-1));
    const times = new Map([[run.all.time.at(-1), "end of the run"]]);
    if (foot) times.set(foot.time, "foot warmest");
    for (const wanted of run.wanted_times) {
      if (times.has(wanted)) times.set(wanted, `${wanted} s, ${times.get(wanted)}`);
      else if (wanted <= last) times.set(wanted, `${wanted} s`);
      else shortcuts.append(Object.assign(document.createElement("span"), { textContent: `The field ends at ${seconds(last)}; ${wanted} s was asked for. ` }));
    }
    for (const [time, text] of [...times].sort(([a], [b]) => a - b)) {
      const button = Object.assign(document.createElement("button"), { type: "button", textContent: text });
      button.addEventListener("click", () => this.chooseTime(time));
      shortcuts.append(button);
    }
  }

  zoom(what) {
    const groups = { in: [0.5, this.groups], out: [2, this.groups] }[what];
    if (groups) for (const group of groups[1]) group.zoom(groups[0]);
    if (what === "whole") for (const group of this.groups) group.show(group.whole);
    if (what === "train") {
      const positions = instant(this.run, "position", this.time);
      this.along.show([positions.at(-1) - 50, positions[0] + 50]);
    }
  }

  chooseVehicle(number) {
    this.vehicle = number;
    const wheel = this.run.wheels.findIndex((one) => one.vehicle === number);
    if (wheel >= 0) byId("wheel").value = this.wheel = wheel;
    this.rebuild();
  }

  chooseChainage(chainage) {
    this.chainage = chainage;
    this.update();
  }

  /** Takes the moment nearest to a time. */
  chooseTime(time) {
    this.setTime(this.run.moments[nearest(this.run.moments, time)]);
  }

  setTime(time) {
    this.time = time;
    this.update();
  }

  /** Makes all panels anew, for another vehicle, wheel or rail. */
  rebuild() {
    for (const group of this.groups) group.clear();
    const places = ["along-track", "over-time", "foot-over-time", "over-depth", "section-picture"].map(byId);
    for (const place of places) place.replaceChildren();
    this.updates = addAlongTrack(this.along, places[0], this.run, this);
    addOverTime(this.over, places[1], this.run, this);
    addFoot(this.whole, places[2], this.run, this);
    this.updates.push(addOverDepth(this.deep, places[3], this.run, this), addSection(places[4], this.run, this));
    this.update();
  }

  /** Shows the chosen time in all panels and in numbers. */
  update() {
    const { run, time } = this;
    byId("time").value = nearest(run.moments, time);
    const after = time > run.all.time.at(-1) ? ", after the run" : "";
    byId("time-text").textContent = `${seconds(time)}${after}`;
    byId("time").setAttribute("aria-valuetext", byId("time-text").textContent);
    for (const update of this.updates) update();
    this.over.repaint(time);
    this.whole.repaint(time / 60);
    this.along.repaint(this.chainage ?? instant(run, "position", time)[this.vehicle - 1]);
    this.deep.repaint(1e3 * (run.rails[this.rail]?.field?.depth[this.depth] ?? 0));
    this.showReadout();
  }

  /** The numbers at the chosen time. */
  showReadout() {
    const { run, time, vehicle } = this;
    const rows = [];
    const { time: times, of } = vehicleOverTime(run, vehicle);
    const at = nearest(times, time);
    const value = (quantity, index) => withUnit(quantity.value[index], quantity.unit);
    rows.push(["Time of the train", seconds(times[at])]);
    const driver = nearest(run.driver.time, time);
    const speed = run.driver.of.get("velocity").value[driver];
    rows.push(["Leading vehicle", `${speed.toFixed(2)} m/s, ${(3.6 * speed).toFixed(1)} km/h`]);
    rows.push([`Middle of vehicle ${vehicle}`, `chainage ${instant(run, "position", time)[vehicle - 1].toFixed(1)} m`]);
    const names = { coupler_rear_force: "rear coupler", creep_force: "creep force", friction_power: "friction power", sync_force: "synchronisation force", position_error: "position error", coupling_residual: "residual power" };
    for (const [name, words] of Object.entries(names)) {
      if (of.has(name)) rows.push([`Vehicle ${vehicle}: ${words}`, value(of.get(name), at)]);
    }
    if (run.speed_rms != null) {
      const measured = run.driver.of.get("driver.measured_speed").value[driver];
      rows.push(["Measured speed", `${measured.toFixed(2)} m/s, ${(3.6 * measured).toFixed(1)} km/h`]);
      rows.push(["Simulated less measured, root mean square", `${run.speed_rms.toFixed(3)} m/s, ${(3.6 * run.speed_rms).toFixed(2)} km/h`]);
    }
    const rail = run.rails[this.rail];
    if (rail?.field) {
      const { field, side } = rail;
      rows.push([`${side} rail`, actualTime(field, time)]);
      const where = field.chainage[nearest(field.chainage, this.chainage)];
      rows.push([`Rise at ${where.toFixed(1)} m, ${(1e3 * field.depth[this.depth]).toFixed(1)} mm deep`, withUnit(riseAt(field, this, this.chainage), "K")]);
      const foot = snapshot(field, time).rows.at(-1)[nearest(field.chainage, this.chainage)];
      rows.push([`Rise of the foot there`, withUnit(foot, "K")]);
      if (field.sections) {
        const { chainage, rises } = sectionAt(field.sections, this.probe, time);
        rows.push([`Section at ${chainage.toFixed(2)} m: warmest`, withUnit(Math.max(...rises), "K")]);
      }
    }
    listRows(byId("readout"), rows);
    const outputs = [...run.outputs.of.get(vehicle) ?? []];
    const record = nearest(run.outputs.time, time);
    byId("further").hidden = !outputs.length;
    listRows(byId("further").querySelector("dl"), outputs.map(([name, quantity]) => [`Vehicle ${vehicle}: ${name}`, value(quantity, record)]));
  }
}

/** Makes the rows of a list: what, and its value. */
function listRows(list, rows) {
  list.replaceChildren(...rows.map(([name, text]) => {
    const row = document.createElement("div");
    row.append(Object.assign(document.createElement("dt"), { textContent: name }), Object.assign(document.createElement("dd"), { textContent: text }));
    return row;
  }));
}

const section = byId("linked-view");
section.hidden = false;
window.view = new View(readRun(byId("numbers")));
