"""`hotfoot run` gives what the same FMUs give when FMPy steps them."""

import lockstep
import numpy as np
import pyarrow.parquet as parquet

STEPS = 2000
LENGTH = 1e-3
EVERY = 10
TYPES = ["locomotive-coco-134t"] + 4 * ["wagon-coco-134t-unpowered"]

# The arithmetic is the same and in the same order, so that 1e-9 leaves room for another
# compiler's rounding of the controller alone.
TOLERANCE = 1e-9


def close(ours, theirs, name):
    scale = max(np.abs(theirs).max(), 1e-12)
    assert np.abs(np.asarray(ours) - theirs).max() <= TOLERANCE * scale, name


def test_five_vehicles_equal_the_same_run_stepped_by_fmpy(run):
    wheels = [(j, side) for j in range(1, 7) for side in ("left", "right")]
    creepages = [f"wheelset[{j}].{side}.creepage.longitudinal" for j, side in wheels]
    by_fmpy = list(
        lockstep.run(run / "fmus", TYPES, 16.67, STEPS, LENGTH, creepages, every=EVERY)
    )
    vehicles = parquet.read_table(run / "series" / "vehicles.parquet").to_pandas()
    recorded = parquet.read_table(run / "series" / "wheels.parquet").to_pandas()
    for i in range(1, len(TYPES) + 1):
        ours = vehicles[vehicles.vehicle == i]
        position = np.array([of_vehicles[i - 1]["position"] for _, of_vehicles, _ in by_fmpy])
        close(ours.position, position, f"position of vehicle {i}")
        for end in ("front", "rear"):
            name = f"vehicle[{i}].coupler.{end}.force"
            force = np.array([of_train[name] for _, _, of_train in by_fmpy])
            close(ours[f"coupler_{end}_force"], force, name)
        for (j, side), name in zip(wheels, creepages):
            rows = recorded[
                (recorded.vehicle == i) & (recorded.wheelset == j) & (recorded.side == side)
            ]
            creepage = np.array([of_vehicles[i - 1][name] for _, of_vehicles, _ in by_fmpy])
            close(rows.creepage_longitudinal, creepage, f"{name} of vehicle {i}")
