// What happens over time: the driver, the chosen vehicle, the chosen wheel, and the foot.

import { largest, nearest } from "./numbers.js";
import { actualTime, snapshot, vehicleOverTime } from "./run.js";
import { rmsInWords, wheelName } from "./along_track.js";
import { addPanel, verticalLine } from "./panel.js";
import { theme } from "./colours.js";

/** Adds the panels over the time of the run. */
export function addOverTime(group, parent, run, state) {
  const draw = (plot) => verticalLine(plot, state.time, theme().ink);
  const onClick = (time) => state.chooseTime(time);
  const add = (title, x, curves, more) => {
    const there = curves.filter((curve) => curve?.value);
    if (there.length) addPanel(group, parent, { title, x, curves: there, draw, onClick, ...more });
  };
  const { time, of } = run.driver;
  const train = (name, label, more) => of.has(name) && { ...of.get(name), label, ...more };
  add("Speed of the leading vehicle", time, [
    train("velocity", "simulated"), train("driver.target_speed", "target of the driver", { stepped: true }), train("driver.measured_speed", "measured"),
  ], { note: rmsInWords(run) });
  add("Driver", time, [
    train("driver.in_force.notch", "notch", { stepped: true }),
    train("driver.in_force.dynamic_brake", "dynamic brake (right axis)", { stepped: true, right: true }),
    train("driver.in_force.train_brake", "train brake (right axis)", { stepped: true, right: true }),
    train("driver.in_force.locomotive_brake", "locomotive brake (right axis)", { stepped: true, right: true }),
  ], { height: 130 });
  add("Largest coupler forces of the whole train", time, [train("train.coupler.tension", "tension"), train("train.coupler.buff", "buff")]);
  addVehicle(add, run, state);
  addWheel(add, run, state);
  addOutputs(add, run, state);
}

/** Curves in one panel, at most; more could not be told apart. */
const MOST_CURVES = 6;

/** Adds the further outputs of the chosen vehicle, those of one unit together. */
function addOutputs(add, run, { vehicle }) {
  const outputs = [...run.outputs.of.get(vehicle)?.values() ?? []];
  for (const unit of new Set(outputs.map((output) => output.unit))) {
    const ofUnit = outputs.filter((output) => output.unit === unit);
    for (let first = 0; first < ofUnit.length; first += MOST_CURVES) {
      const curves = ofUnit.slice(first, first + MOST_CURVES).map((output) => ({ ...output, label: output.name }));
      // Bands of several curves would hide each other.
      if (curves.length > 1) for (const curve of curves) curve.lowest = curve.highest = undefined;
      const part = ofUnit.length > MOST_CURVES ? ` ${first + 1} to ${first + curves.length} of ${ofUnit.length}` : "";
      add(`Further outputs${part}`, run.outputs.time, curves, { note: `vehicle ${vehicle}` });
    }
  }
}

function addVehicle(add, run, { vehicle }) {
  const { time, of } = vehicleOverTime(run, vehicle);
  const note = `vehicle ${vehicle}`;
  const curve = (name, label, more) => of.has(name) && { ...of.get(name), label, ...more };
  add("Rear coupler force (tension positive)", time, [curve("coupler_rear_force", "force")], { note });
  add("Longitudinal creep force of all wheels", time, [curve("creep_force", "force")], { note });
  add("Friction power of all wheels", time, [curve("friction_power", "power")], { note });
  add("Synchronisation", time, [curve("sync_force", "force"), curve("position_error", "position error (right axis)", { right: true })], { note });
  add("Residual power of the coupling: what the train gives less what the vehicle takes", time, [curve("coupling_residual", "power")], { note });
}

function addWheel(add, run, { wheel }) {
  const chosen = run.wheels[wheel];
  if (!chosen) return;
  const note = wheelName(chosen);
  const curve = (name, label, more) => ({ ...chosen.of.get(name), label, ...more });
  add("Creepage of the wheel", run.wheelTime, [
    curve("creepage_longitudinal", "longitudinal"), curve("creepage_lateral", "lateral"), curve("creepage_spin", "spin in 1/m (right axis)", { right: true }),
  ], { note });
  add("Friction power of the wheel", run.wheelTime, [curve("friction_power", "power")], { note });
  add("Normal force of the wheel", run.wheelTime, [curve("force_normal", "force")], { note });
}

/** Adds the rise over the depth at the chosen chainage, now and at the times that the scenario asks for. */
export function addOverDepth(group, parent, run, state) {
  const field = run.rails[state.rail]?.field;
  if (!field) return () => {};
  const size = largest(...field.rows);
  const end = Math.max(field.time.at(-1), run.all.time.at(-1));
  const wanted = run.wanted_times.filter((time) => time <= end).slice(0, 3);
  const curves = () => {
    const column = nearest(field.chainage, state.chainage);
    const curve = (time, label) => ({ label, unit: "K", size, value: snapshot(field, time).rows.map((row) => row[column]) });
    return [curve(state.time, "at the chosen time"), ...wanted.map((time) => curve(time, `${time} s`))];
  };
  const title = `Rise over the depth at the chosen chainage, ${run.rails[state.rail].side} rail`;
  const panel = addPanel(group, parent, { title, x: field.depth.map((depth) => 1e3 * depth), curves: curves() });
  return () => {
    panel.setCurves(field.depth.map((depth) => 1e3 * depth), curves());
    panel.setNote(`chainage ${field.chainage[nearest(field.chainage, state.chainage)].toFixed(1)} m, ${actualTime(field, state.time)}`);
  };
}

/** Adds the foot of each rail over the whole time, in minutes. */
export function addFoot(group, parent, run, state) {
  for (const { side, foot } of run.rails) {
    if (!foot) continue;
    const curve = (name, label, line) => ({ value: foot[name], unit: "K", label, line });
    const threshold = { value: foot.time.map(() => run.threshold), unit: "K", label: "threshold of detection", line: 5 };
    addPanel(group, parent, {
      title: `Rise of the foot over untouched rail, ${side} rail`, x: Array.from(foot.time, (time) => time / 60),
      curves: [curve("highest", "highest along the track", 1), curve("under_train", "under the last wheel", 0), threshold],
      draw: (plot) => verticalLine(plot, state.time / 60, theme().ink),
      onClick: (minutes) => state.chooseTime(60 * minutes),
    });
  }
}
