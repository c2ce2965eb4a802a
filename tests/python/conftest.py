"""What the FMPy tests share: the built program and FMUs, and a run of a short train."""

import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
TARGET = ROOT / "target"
FMUS = {name: TARGET / "fmus" / f"{name}.fmu" for name in ("vehicle", "longitudinal", "railheat")}

SCENARIO = f"""
title = "Five vehicles for FMPy"
duration_s = 2.0
step_s = 0.001
stock = "{ROOT / 'stock'}"

[train]
speed_m_per_s = 16.67
[[train.vehicles]]
type = "locomotive-coco-134t"
count = 1
[[train.vehicles]]
type = "wagon-coco-134t-unpowered"
count = 4

[track]
file = "track.toml"
[driver]
file = "driver.toml"
[heat]
begin_m = -120.0
length_m = 600.0
field_interval_s = 0.5

[record]
interval_s = 0.01
wheels_of = [1, 2, 3, 4, 5]
"""

TRACK = """
start_m = 20.0
alignment = [
    { length_m = 50.0, transition = true },
    { length_m = 600.0, radius_m = 800.0 },
    { length_m = 50.0, transition = true },
]
"""

DRIVER = "[[command]]\nfrom_s = 0.0\nnotch = 7.0\n"


@pytest.fixture(scope="session")
def run(tmp_path_factory):
    """Results folder of a run of five vehicles by `hotfoot run`."""
    folder = tmp_path_factory.mktemp("five-vehicles")
    for name, text in [("scenario", SCENARIO), ("track", TRACK), ("driver", DRIVER)]:
        (folder / f"{name}.toml").write_text(text)
    results = folder / "results"
    program = TARGET / "release" / "hotfoot"
    arguments = ["run", "scenario.toml", "--quiet", "--results", str(results)]
    subprocess.run([program, *arguments], cwd=folder, check=True)
    return results
