"""`hotfoot run` gives what the same FMUs give when FMPy steps them."""

import lockstep
import numpy as np
import pyarrow.parquet as parquet
from conftest import ROOT, TYPES, hotfoot, run_five_vehicles

LENGTH = 1e-3

# The arithmetic is the same and in the same order, so that 1e-9 leaves room for another
# compiler's rounding of the controller alone.
TOLERANCE = 1e-9

RAIL_OUTPUTS = ["highest.surface.rise", "highest.foot.rise"]


def close(ours, theirs, name):
    scale = max(np.abs(theirs).max(), 1e-12)
    assert np.abs(np.asarray(ours) - theirs).max() <= TOLERANCE * scale, name


def compare(results, types, states, wheels=()):
    """Compares series of a run with the states that FMPy came to at the same times; `wheels` are
    (vehicle, wheelset, side) of the wanted creepages, the same for each vehicle."""
    times, of_train, of_vehicles, of_rail = map(np.array, zip(*states))
    vehicles = parquet.read_table(results / "series" / "vehicles.parquet").to_pandas()
    rail = parquet.read_table(results / "series" / "rail.parquet").to_pandas()
    np.testing.assert_allclose(rail.time, times, rtol=1e-12)
    for i in range(len(types)):
        ours = vehicles[vehicles.vehicle == i + 1]
        close(ours.position, of_vehicles[:, i, 0], f"position of vehicle {i + 1}")
        close(ours.velocity, of_vehicles[:, i, 1], f"velocity of vehicle {i + 1}")
        close(ours.coupler_front_force, of_train[:, i, 2], f"front coupler of vehicle {i + 1}")
        close(ours.coupler_rear_force, of_train[:, i, 3], f"rear coupler of vehicle {i + 1}")
    for place, name in enumerate(RAIL_OUTPUTS):
        close(rail[name], of_rail[:, place], name)
    recorded = parquet.read_table(results / "series" / "wheels.parquet").to_pandas()
    for i in sorted(recorded.vehicle.unique()):
        for place, (j, side) in enumerate(wheels):
            rows = recorded[
                (recorded.vehicle == i) & (recorded.wheelset == j) & (recorded.side == side)
            ]
            creepage = of_vehicles[:, i - 1, 2 + place]
            close(rows.creepage_longitudinal, creepage, f"vehicle {i}, wheelset {j}, {side}")


def by_fmpy(results, types, duration, interval, wheels, rail_parameters):
    """The states of the same run stepped by FMPy."""
    creepages = [f"wheelset[{j}].{side}.creepage.longitudinal" for j, side in wheels]
    return list(
        lockstep.run(
            results / "fmus",
            types,
            velocity=16.67,
            steps=round(duration / LENGTH),
            length=LENGTH,
            every=round(interval / LENGTH),
            vehicle_outputs=creepages,
            rail=({"model": "paper", **rail_parameters}, RAIL_OUTPUTS),
        )
    )


def test_five_vehicles_for_60_s_equal_the_same_run_stepped_by_fmpy(tmp_path):
    results = run_five_vehicles(
        tmp_path,
        [("duration_s = 2.0", "duration_s = 60.0"), ("length_m = 600.0", "length_m = 1300.0")],
        "[record]\ninterval_s = 0.1\nwheels_of = [1, 2, 3, 4, 5]\n",
    )
    wheels = [(j, side) for j in range(1, 7) for side in ("left", "right")]
    rail = {"track.begin": -120.0, "track.length": 1300.0}
    compare(results, TYPES, by_fmpy(results, TYPES, 60.0, 0.1, wheels, rail), wheels)


def test_the_papers_curve_with_130_vehicles_for_4_s_equals_the_same_run_stepped_by_fmpy(tmp_path):
    scenario = ROOT / "scenarios" / "curve-increasing-speed"
    results = tmp_path / "results"
    hotfoot("run", scenario, "--duration", 4, "--quiet", "--results", results)
    types = 2 * ["locomotive-coco-134t"] + 128 * ["wagon-coco-134t-unpowered"]
    wheels = [(1, "left"), (6, "right")]
    rail = {"track.begin": -2650.0, "track.length": 6800.0}
    rail |= {"solar.irradiance": 1366.0, "solar.filter": 0.5}
    compare(results, types, by_fmpy(results, types, 4.0, 0.1, wheels, rail), wheels)
