// The run as the page has it: tables of what was recorded.

import { largest, nearest, seconds, unpacked, unpackedRows } from "./numbers.js";

/** Quantities by their names, with their numbers. */
function byName(quantities) {
  const entries = quantities.map(({ name, unit, value, lowest, highest }) => [name, {
    name, unit, value: unpacked(value),
    lowest: lowest && unpacked(lowest), highest: highest && unpacked(highest),
  }]);
  return new Map(entries);
}

/** The run whose numbers stand in an element of the page as JSON. */
export function readRun(element) {
  const { train, wheels, rails, track, outputs, ...facts } = JSON.parse(element.textContent);
  const run = {
    ...facts,
    track: Object.fromEntries(Object.entries(track).map(([name, text]) => [name, unpacked(text)])),
    driver: { every: train.driver.every, time: unpacked(train.driver.time), of: byName(train.driver.quantities) },
    all: { every: train.all.every, time: unpacked(train.all.time), of: byName(train.all.quantities) },
    couplerLowest: unpacked(train.coupler_lowest),
    couplerHighest: unpacked(train.coupler_highest),
    recorded: new Map(train.recorded.map(({ number, quantities }) => [number, byName(quantities)])),
    outputs: {
      every: outputs.every, leftOut: outputs.left_out, time: unpacked(outputs.time),
      of: new Map(outputs.vehicles.map(({ number, quantities }) => [number, byName(quantities)])),
    },
    wheelEvery: wheels.every,
    wheelsLeftOut: wheels.left_out,
    wheelTime: unpacked(wheels.time),
    wheels: wheels.wheels.map(({ position, quantities, ...wheel }) =>
      ({ ...wheel, position: unpacked(position), of: byName(quantities) })),
    rails: rails.map(readRail),
  };
  run.moments = moments(run);
  return run;
}

function readRail({ side, foot, field }) {
  return {
    side,
    foot: foot && Object.fromEntries(Object.entries(foot).map(([name, text]) => [name, unpacked(text)])),
    field: field && {
      elements: field.elements,
      every: field.every,
      time: unpacked(field.time),
      chainage: unpacked(field.chainage),
      depth: unpacked(field.depth),
      rows: unpackedRows(field.rise),
      sections: field.sections && readSections(field.sections),
    },
  };
}

function readSections({ size, rise, warmest, ...packed }) {
  const lists = Object.fromEntries(Object.entries(packed).map(([name, text]) => [name, unpacked(text)]));
  return {
    ...lists, width: size[0], height: size[1], rows: unpackedRows(rise),
    warmest: warmest && { chainage: unpacked(warmest.chainage), rows: unpackedRows(warmest.rise) },
  };
}

/** What stands for a probe where the section is that where the foot is warmest. */
export const WARMEST = -1;

/** The section of a probe at the snapshot nearest to `time`: its actual time, chainage, and the rise of each cell, K. */
export function sectionAt({ time: times, chainage, rows, warmest }, probe, time) {
  const index = nearest(times, time);
  const of = probe === WARMEST
    ? { chainage: warmest.chainage[index], rises: warmest.rows[index] }
    : { chainage: chainage[probe], rises: rows[index * chainage.length + probe] };
  return { time: times[index], ...of };
}

/** The section that is shown first: where the foot is warmest, or of the probe whose foot (the lowest cells in the middle) becomes warmest. */
export function firstSection(sections) {
  if (sections.warmest) return WARMEST;
  const lowest = Math.max(...sections.z);
  const foot = [...sections.y.keys()].filter((cell) => sections.z[cell] === lowest && Math.abs(sections.y[cell]) <= sections.width);
  const rises = [...sections.chainage].map((_, probe) =>
    largest(...[...sections.time].map((time) => foot.map((cell) => Math.max(0, sectionAt(sections, probe, time).rises[cell])))));
  return rises.indexOf(Math.max(...rises));
}

/** The times that the slider can take: those of the train, then those of fields after its run, s. */
function moments(run) {
  const end = run.all.time.at(-1) ?? 0;
  const after = run.rails.flatMap((rail) => [...(rail.field?.time ?? [])]).filter((time) => time > end);
  return [...run.all.time, ...[...new Set(after)].sort((a, b) => a - b)];
}

/** The values of a quantity of all vehicles, from the head of the train, at the instant nearest to `time`. */
export function instant(run, name, time) {
  const quantity = run.all.of.get(name);
  if (!quantity) return null;
  const record = nearest(run.all.time, time);
  return quantity.value.subarray(record * run.vehicles, (record + 1) * run.vehicles);
}

/** What is known of a vehicle over time: all that was recorded, or what all vehicles have. */
export function vehicleOverTime(run, number) {
  const recorded = run.recorded.get(number);
  if (recorded) return { time: run.driver.time, of: recorded };
  const ofOne = ([name, quantity]) =>
    [name, { ...quantity, value: quantity.value.filter((_, index) => index % run.vehicles === number - 1) }];
  return { time: run.all.time, of: new Map([...run.all.of].map(ofOne)) };
}

/** The field of a rail at the snapshot nearest to `time`: its actual time and a row for each depth. */
export function snapshot(field, time) {
  const index = nearest(field.time, time);
  const depths = field.depth.length;
  return { time: field.time[index], rows: field.rows.slice(index * depths, (index + 1) * depths) };
}

/** The actual time of the field that is shown for `time`, in words. */
export function actualTime(field, time) {
  return timeInWords("field", snapshot(field, time).time, time);
}

/** What is shown for `time`, with its actual time in words. */
export function timeInWords(what, actual, time) {
  const words = `${what} of ${seconds(actual)}`;
  return Math.abs(actual - time) < 1e-3 ? words : `${words}, the nearest that is stored`;
}

/** Time and chainage at which the foot, the lowest row of a field, is warmest; none if it has no heat. */
export function warmestFoot(field) {
  return warmest(field, field.depth.length - 1);
}

/** Time and chainage at which a row of a field is warmest; none if it never is by more than a µK. */
export function warmest(field, depth) {
  let best = { rise: 1e-6 };
  field.time.forEach((time, index) => {
    field.rows[index * field.depth.length + depth].forEach((rise, column) => {
      if (rise > best.rise) best = { rise, time, chainage: field.chainage[column] };
    });
  });
  return best.chainage == null ? null : best;
}

/** In sentences, what of the run is not in the page. */
export function leftOut(run) {
  const said = [];
  const every = (count, what) => count > 1 && said.push(`one record of ${count} of ${what}`);
  every(run.driver.every, "train and recorded vehicles, with the extremes between them");
  every(run.all.every, "the whole train");
  every(run.wheelEvery, "the wheels");
  if (run.wheelsLeftOut) said.push(`none of the last ${run.wheelsLeftOut} recorded wheels`);
  every(run.outputs.every, "the further outputs, with the extremes between them");
  if (run.outputs.leftOut) said.push(`none of ${run.outputs.leftOut} further outputs`);
  for (const { side, field } of run.rails) {
    if (!field) continue;
    every(field.every, `the field of the ${side} rail, and those that the scenario asks for`);
    if (field.sections && field.sections.time.length < field.time.length) said.push(`sections of the ${side} rail at ${field.sections.time.length} times`);
    if (field.elements > 1) said.push(`of ${field.elements} elements of the ${side} rail the rise farthest from zero`);
  }
  return said.length ? `To stay small the page holds ${said.join("; ")}. The results folder has all.` : "";
}
