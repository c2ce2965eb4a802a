"""Prints the table of the paper's four scenarios: `scenario_table.py RESULTS`, with the folder of each run in it.

`cargo xtask scenario-table` runs the scenarios and calls this; scenarios/README.md shows what it prints.
"""

import sys
from pathlib import Path

import numpy

import hotfoot

CASES = {
    "straight-constant-speed": "straight, notch 5",
    "straight-increasing-speed": "straight, notch 8",
    "curve-constant-speed": "curve, notch 5",
    "curve-increasing-speed": "curve, notch 7",
}
DEEP_M = 0.06
# Of the paper's figures, s.
DEEP_AT_S = 160.0


def is_curved(results, chainage):
    """Whether the track is curved at a chainage."""
    track = results.manifest["run"]["track"]
    return numpy.interp(chainage, track["chainage_m"], track["curvature_per_m"]) != 0.0


def speed(results):
    return f"{results.figure('speed.start'):.2f} to {results.figure('speed.end'):.2f}"


def at_the_start(results, column):
    """Sum of a force of all vehicles at the first record after the start, kN."""
    vehicles = results.table("vehicles", ["time", column])
    first = vehicles["time"].unique()[1]
    return f"{abs(vehicles.loc[vehicles['time'] == first, column].sum()) / 1e3:.1f}"


def farthest(results, column, of_locomotives=None):
    """The value of a column of the vehicles that is farthest from zero, of locomotives, of wagons, or of both."""
    low, high = f"{column}_min", f"{column}_max"
    vehicles = results.table("vehicles", ["vehicle", low, high])
    if of_locomotives is not None:
        is_locomotive = vehicles["vehicle"].isin(results.manifest["run"]["locomotives"])
        vehicles = vehicles[is_locomotive == of_locomotives]
    return max(-vehicles[low].min(), vehicles[high].max())


def creepage(results, vehicle):
    """Largest longitudinal creepage of a vehicle's left wheels on straight and on curved track, %."""
    wheels = results.table("wheels", ["vehicle", "side", "position", "creepage_longitudinal"])
    wheels = wheels[(wheels["vehicle"] == vehicle) & (wheels["side"] == "left")]
    curved = is_curved(results, wheels["position"])
    percent = 100.0 * wheels["creepage_longitudinal"].abs()
    return " / ".join(number(percent[part].max()) for part in (~curved, curved))


def surface(results, outside):
    """Highest rise of the surface at a record of the field, K; only of straight track if it is to be `outside`."""
    rise = results.field()["temperature_rise"].isel(depth=0).load()
    if outside:
        rise = rise[:, ~is_curved(results, rise["chainage"])]
    return number(rise.max().item())


def deep(results, outside):
    """The same 60 mm deep, at the record next to 160 s."""
    rise = results.field()["temperature_rise"].sel(depth=DEEP_M, time=DEEP_AT_S, method="nearest").load()
    if outside:
        rise = rise[~is_curved(results, rise["chainage"])]
    return number(rise.max().item())


def foot(results):
    """Highest rise of the foot at the last record of the field, K."""
    return number(results.field()["temperature_rise"].isel(depth=-1, time=-1).max().item())


def number(value):
    """Two digits; nothing of what there is none."""
    if not numpy.isfinite(value):
        return "-"
    return f"{value:.0f}" if abs(value) >= 100.0 else f"{value:#.2g}".rstrip(".")


ROWS = {
    "speed of the train, m/s": speed,
    "traction at the start, kN": lambda r: at_the_start(r, "traction_force"),
    "propulsion resistance at the start, kN": lambda r: at_the_start(r, "resistance_force"),
    "largest synchronisation force, locomotives, N": lambda r: f"{farthest(r, 'sync_force', True):.0f}",
    "largest synchronisation force, wagons, N": lambda r: f"{farthest(r, 'sync_force', False):.0f}",
    "largest position error, mm": lambda r: f"{1e3 * farthest(r, 'position_error'):.1f}",
    "largest friction power, locomotive, kW": lambda r: number(farthest(r, "friction_power", True) / 1e3),
    "largest friction power, wagon, kW": lambda r: number(farthest(r, "friction_power", False) / 1e3),
    "largest longitudinal creepage of the left wheels, vehicle 1, straight / curve, %": lambda r: creepage(r, 1),
    "the same of vehicle 3, a wagon": lambda r: creepage(r, 3),
    "highest rise of the surface, K": lambda r: number(r.table("rail")["highest.surface.rise"].max()),
    "the same at a record of the field": lambda r: surface(r, outside=False),
    "the same, straight track": lambda r: surface(r, outside=True),
    "rise 60 mm deep at 160 s, K": lambda r: deep(r, outside=False),
    "rise 60 mm deep at 160 s, straight track, K": lambda r: deep(r, outside=True),
    "rise of the foot at the end, K": foot,
}


def main():
    folder = Path(sys.argv[1])
    results = [hotfoot.open(folder / name) for name in CASES]
    print(f"| | {' | '.join(CASES.values())} |")
    print("|---" * (len(CASES) + 1) + "|")
    for name, value in ROWS.items():
        print(f"| {name} | {' | '.join(map(value, results))} |")


if __name__ == "__main__":
    main()
