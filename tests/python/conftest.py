"""What the tests with other tools share: the built program and FMUs, and runs of trains."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
MODELS = ("vehicle", "longitudinal", "railheat", "synchronisation")
FMUS = {name: TARGET / "fmus" / f"{name}.fmu" for name in MODELS}
HOTFOOT = TARGET / "release" / "hotfoot"

# The package `hotfoot`, as `cargo xtask package` lays it out.
sys.path.insert(0, str(TARGET / "package"))

# The short train of the Rust tests and of these.
FIVE_VEHICLES = ROOT / "tests" / "five-vehicles"
TYPES = ["locomotive-coco-134t"] + 4 * ["wagon-coco-134t-unpowered"]

# Dense records of all wheels, for comparisons.
RECORD = """
[record]
interval_s = 0.01
wheels_of = [1, 2, 3, 4, 5]
"""


def hotfoot(*arguments, folder=ROOT):
    """Runs the program, which must succeed, and gives what it prints."""
    command = [HOTFOOT, *map(str, arguments)]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def five_vehicles(folder, changes=(), further=RECORD):
    """Writes the scenario of five vehicles into a folder, with changed lines and further ones."""
    for name in ("track.toml", "driver.toml"):
        (folder / name).write_text((FIVE_VEHICLES / name).read_text())
    text = (FIVE_VEHICLES / "scenario.toml").read_text()
    changes = [('"../../stock"', f'"{ROOT / "stock"}"'), *changes]
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    file = folder / "scenario.toml"
    file.write_text(text + further)
    return file


def run_five_vehicles(folder, changes=(), further=RECORD):
    """Runs the five vehicles with `hotfoot run` and gives the results folder."""
    scenario = five_vehicles(folder, changes, further)
    results = folder / "results"
    hotfoot("run", scenario, "--quiet", "--results", results)
    return results


@pytest.fixture(scope="session")
def run(tmp_path_factory):
    """Results folder of a run of five vehicles by `hotfoot run`."""
    return run_five_vehicles(tmp_path_factory.mktemp("five-vehicles"))
