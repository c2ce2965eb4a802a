// What lies and runs along the track: the track, the train on it, its forces, its friction, the heat.

import { largest, nearest } from "./numbers.js";
import { actualTime, instant, snapshot } from "./run.js";
import { theme } from "./colours.js";
import { addPanel, verticalLine } from "./panel.js";
import { addHeatMap } from "./heat_map.js";

/** Distance of the running circles by which a cant angle is told as a height, m. */
const TRACK_WIDTH = 1.5;

/** Rises that are no more than this are none, K. */
const SMALL = 1e-6;

/** The chainages that the run and its rails have, and those where the train was or the rail has changed. */
export function extentsAlong(run) {
  const train = ends(run.all.of.get("position").value);
  const fields = run.rails.map(({ field }) => field).filter(Boolean);
  const changed = ({ chainage, rows }) => chainage.filter((_, column) => rows.some((row) => Math.abs(row[column]) > SMALL));
  return {
    whole: ends([...train, ...fields.flatMap(({ chainage }) => [...chainage])]),
    shown: ends([...train, ...fields.flatMap((field) => [...changed(field)])]),
  };
}

/** The smallest and the largest of some chainages, which differ. */
function ends(chainages) {
  let [min, max] = [Infinity, -Infinity];
  for (const chainage of chainages) if (Number.isFinite(chainage)) [min, max] = [Math.min(min, chainage), Math.max(max, chainage)];
  return max > min ? [min, max] : [0, 1];
}

/** Adds the panels along the track; gives those that change with time, as functions of the state. */
export function addAlongTrack(group, parent, run, state) {
  const withTrain = (plot) => paintTrain(plot, run, state.time);
  const updates = [];
  addPanel(group, parent, {
    title: "Track", height: 150, under: withTrain, draw: (plot) => paintVehicles(plot, run, state.time), ...track(run, group.whole),
  });
  const speeds = speedCurves(run, state);
  if (speeds) addPanel(group, parent, { title: "Speed where the leading vehicle was", note: rmsInWords(run), under: withTrain, ...speeds });
  const forces = addPanel(group, parent, {
    title: "Coupler forces along the train", under: withTrain, ...couplers(run, state),
    draw: (plot) => verticalLine(plot, instant(run, "position", state.time)[state.vehicle - 1], theme().faint),
  });
  updates.push(() => {
    const { x, curves } = couplers(run, state);
    forces.setCurves(x, curves);
    forces.setNote(duringRun(run, state.time));
  });
  if (run.all.of.has("friction_power")) {
    const friction = addPanel(group, parent, { title: "Friction along the train", under: withTrain, ...frictions(run, state) });
    updates.push(() => {
      const { x, curves } = frictions(run, state);
      friction.setCurves(x, curves);
      friction.setNote(duringRun(run, state.time));
    });
  }
  const wheel = run.wheels[state.wheel];
  if (wheel) {
    addPanel(group, parent, {
      title: "Wear number Tγ (heat per metre) where the wheel was", note: wheelName(wheel), under: withTrain,
      draw: (plot) => state.time <= run.wheelTime.at(-1) && verticalLine(plot, wheel.position[nearest(run.wheelTime, state.time)], theme().faint),
      ...rising(wheel.position, [{ ...wheel.of.get("wear_number"), label: "Tγ" }]),
    });
  }
  const rail = run.rails[state.rail];
  if (rail?.field) updates.push(...addField(group, parent, run, state, rail, withTrain));
  return updates;
}

/** How far the simulated speed is from the measured one, in words; nothing without a measured one. */
export function rmsInWords({ speed_rms: rms }) {
  return rms == null ? "" : `root mean square of simulated less measured ${(3.6 * rms).toFixed(2)} km/h`;
}

/** The wheel in words. */
export function wheelName({ vehicle, wheelset, side }) {
  return `vehicle ${vehicle}, wheelset ${wheelset}, ${side}`;
}

/** Says when what is shown of the train is that of the end of its run. */
function duringRun(run, time) {
  return time > run.all.time.at(-1) ? "as at the end of the run" : "";
}

function addField(group, parent, run, state, rail, under) {
  const { field, side } = rail;
  const depths = field.depth.length;
  const limit = { value: field.chainage.map(() => run.threshold), unit: "K", label: "threshold of detection", line: 5 };
  const add = (depth, name, more) => {
    // The unit suits the whole time.
    const size = largest(...field.rows.filter((_, row) => row % depths === depth));
    const curves = () => [{ value: snapshot(field, state.time).rows[depth], size, unit: "K", label: name, line: 1 }, ...more];
    const panel = addPanel(group, parent, { title: `Rise of the ${name} along the track, ${side} rail`, under, x: field.chainage, curves: curves() });
    return () => {
      panel.setCurves(field.chainage, curves());
      panel.setNote(actualTime(field, state.time));
    };
  };
  return [
    addHeatMap(group, parent, run, state, rail),
    add(0, "surface", []),
    add(depths - 1, "foot", run.threshold == null ? [] : [limit]),
  ];
}

/** Points between which the cursor finds no others. */
const FINE = 300;

function track(run, [begin, end]) {
  const { chainage, curvature, cant_angle, gradient } = run.track;
  const known = chainage.length ? [Math.min(begin, chainage[0]), ...chainage, Math.max(end, chainage.at(-1))] : [begin, end];
  // Between the ends of its pieces the track is linear: points in between are for the cursor.
  const x = [];
  known.forEach((from, index) => {
    const to = known[index + 1] ?? from;
    const count = Math.max(1, Math.round(FINE * (to - from) / (known.at(-1) - known[0])));
    for (let part = 0; part < count; part++) x.push([index, part / count]);
  });
  const at = (list) => ([index, share]) => list[index] + share * ((list[index + 1] ?? list[index]) - list[index]);
  const curve = (label, list, change, more) => {
    const values = list.length ? [list[0], ...list, list.at(-1)].map(change) : [0, 0];
    return { label, unit: "1", value: x.map(at(values)), ...more };
  };
  const places = x.map(at(known));
  const limits = places.map((place) => 3.6 * speedLimit(run, place));
  return {
    x: places,
    curves: [
      curve("curvature in 1/km (right positive)", curvature, (value) => 1e3 * value),
      curve("gradient in ‰ (uphill positive)", gradient, (value) => 1e3 * value),
      curve("cant in mm (right axis)", cant_angle, (angle) => 1e3 * TRACK_WIDTH * Math.sin(angle), { right: true }),
      run.speed_limits.length && { label: "speed limit in km/h (right axis)", unit: "1", value: limits, right: true, stepped: true },
    ].filter(Boolean),
  };
}

/** The speed limit at a chainage, m/s: the lowest of those that hold; not-a-number where none does. */
export function speedLimit({ speed_limits: limits }, at) {
  const holding = limits.filter(({ from_m, to_m }) => from_m <= at && at < to_m);
  return holding.length ? Math.min(...holding.map(({ speed_m_per_s }) => speed_m_per_s)) : NaN;
}

function speedCurves(run) {
  const { of } = run.driver;
  const curves = [["velocity", "simulated"], ["driver.target_speed", "target of the driver"], ["driver.measured_speed", "measured"]]
    .filter(([name]) => of.has(name)).map(([name, label]) => ({ ...of.get(name), label }));
  if (!of.has("position")) return null;
  const at = of.get("position").value;
  if (run.speed_limits.length) curves.push({ value: at.map((chainage) => speedLimit(run, chainage)), unit: "m/s", label: "speed limit", stepped: true });
  return rising(at, curves);
}

/** Curves over abscissae that may repeat or go back: only the records that go on. */
function rising(abscissae, curves) {
  const kept = [];
  let last = -Infinity;
  abscissae.forEach((at, index) => { if (at > last) { kept.push(index); last = at; } });
  const pick = (list) => list && kept.map((index) => list[index]);
  return {
    x: pick(abscissae),
    curves: curves.map((curve) => ({ ...curve, value: pick(curve.value), lowest: pick(curve.lowest), highest: pick(curve.highest) })),
  };
}

/** Vehicles from the tail to the head, so that their chainages rise. */
function fromTail(run, time) {
  return [...instant(run, "position", time)].toReversed();
}

function couplers(run, { time }) {
  const force = instant(run, "coupler_rear_force", time);
  return {
    x: fromTail(run, time),
    curves: [{
      label: "rear coupler (tension positive)", unit: "N", points: run.vehicles < 40, value: [...force].toReversed(),
      lowest: [...run.couplerLowest].toReversed(), highest: [...run.couplerHighest].toReversed(),
    }],
  };
}

function frictions(run, { time }) {
  const curve = (name, label, more) => ({ label, unit: run.all.of.get(name).unit, points: run.vehicles < 40, value: [...instant(run, name, time)].toReversed(), ...more });
  return {
    x: fromTail(run, time),
    curves: [
      curve("friction_power", "friction power of a vehicle"),
      curve("creep_force", "longitudinal creep force (right axis)", { right: true }),
    ],
  };
}

/** Shades the track under the train. */
function paintTrain(plot, run, time) {
  if (time > run.all.time.at(-1)) return;
  const positions = instant(run, "position", time);
  const half = halfLength(positions);
  const ends = [positions.at(-1) - half, positions[0] + half].map((at) => plot.valToPos(at, "x", true));
  const { ctx, bbox } = plot;
  const [left, right] = ends.map((end) => Math.max(bbox.left, Math.min(end, bbox.left + bbox.width)));
  ctx.save();
  ctx.fillStyle = theme().train;
  ctx.fillRect(left, bbox.top, right - left, bbox.height);
  ctx.restore();
}

/** Draws the vehicles at the foot of a panel; locomotives are full, the others are outlines. */
function paintVehicles(plot, run, time) {
  if (time > run.all.time.at(-1)) return;
  const positions = instant(run, "position", time);
  const half = 0.9 * halfLength(positions);
  const { ctx, bbox } = plot;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.fillStyle = ctx.strokeStyle = theme().ink;
  ctx.lineWidth = devicePixelRatio;
  const height = 9 * devicePixelRatio;
  positions.forEach((middle, index) => {
    const [left, right] = [middle - half, middle + half].map((at) => plot.valToPos(at, "x", true));
    const box = [left, bbox.top + bbox.height - height - 3, Math.max(right - left, 1), height];
    if (run.locomotives.includes(index + 1)) ctx.fillRect(...box); else ctx.strokeRect(...box);
  });
  ctx.restore();
}

/** Half of the mean distance between vehicles, m. */
function halfLength(positions) {
  return positions.length > 1 ? (positions[0] - positions.at(-1)) / (positions.length - 1) / 2 : 10;
}
