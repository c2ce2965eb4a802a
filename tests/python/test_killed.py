"""What pandas and xarray find in the results of a run that was killed."""

import os
import signal
import subprocess
import time
import warnings

import pandas
import pytest
import xarray

from conftest import HOTFOOT, five_vehicles, hotfoot

KILLS = int(os.environ.get("HOTFOOT_KILLS", 3))
LONGEST = 6.0  # s
INTERVAL = 0.02  # s
RECORD = f"""
[record]
interval_s = {INTERVAL}
"""


@pytest.mark.parametrize("kill", range(KILLS))
def test_results_of_a_killed_run_open_as_those_of_any_other(tmp_path, kill):
    changes = [("duration_s = 2.0", "duration_s = 60.0")]
    scenario = five_vehicles(tmp_path, changes, RECORD)
    results = tmp_path / "results"
    run = subprocess.Popen(
        [HOTFOOT, "run", scenario, "--quiet", "--results", results], start_new_session=True
    )
    first = results / "series" / "rail.parts" / ".open.arrows"
    while not first.exists():
        assert run.poll() is None
        time.sleep(0.01)
    time.sleep(LONGEST * ((kill * 0.618) % 1.0))
    # Program and child: each lets go of the other's results in a moment.
    os.killpg(run.pid, signal.SIGKILL)
    run.wait()
    hotfoot("report", results)

    tables = {file.stem: pandas.read_parquet(file) for file in (results / "series").iterdir()}
    assert {"train", "vehicles", "wheels", "rail"} <= tables.keys()
    ends = {name: table["time"].iloc[-1] for name, table in tables.items()}
    assert len(set(ends.values())) == 1, ends
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        field = xarray.open_zarr(results / "rail.zarr")
    # The rail writes its field in the step that comes before the record.
    next_record = ends["train"] + INTERVAL + 1e-9
    assert field["time"].size == 0 or field["time"][-1] <= next_record
