"""The Python examples read a run as their README says."""

import os
import subprocess
import sys

import pytest
from conftest import ROOT, TARGET

SCRIPT = ROOT / "examples" / "read-results" / "read_results.py"
# The paper's scenarios.
CASES = [f"{track}-{speed}-speed" for track in ("straight", "curve") for speed in ("constant", "increasing")]
BY_PACKAGE = {
    "capture_output": True,
    "text": True,
    "env": {**os.environ, "PYTHONPATH": str(TARGET / "package")},
}


def test_the_results_of_a_run_are_read(run):
    done = subprocess.run([sys.executable, SCRIPT, run], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert lines[0] == "coupler forces, N"
    assert any(line.startswith("highest rise ") and " K at " in line for line in lines)
    # The locomotive pulls four wagons: the coupler behind it is the one with the greatest tension.
    tensions = {int(row[0]): float(row[1]) for row in map(str.split, lines[3:8])}
    assert max(tensions, key=tensions.get) == 1


def test_the_table_of_the_scenarios_has_a_column_for_each_and_no_gap(run, tmp_path):
    """The five vehicles, whose whole rail is read, stand for each of the four."""
    for name in CASES:
        (tmp_path / name).symlink_to(run)
    done = subprocess.run([sys.executable, SCRIPT.with_name("scenario_table.py"), tmp_path], **BY_PACKAGE)
    assert done.returncode == 0, done.stderr
    head, _, *rows = ([cell.strip() for cell in line.strip("|").split("|")] for line in done.stdout.splitlines())
    assert head == ["", "straight, notch 5", "straight, notch 8", "curve, notch 5", "curve, notch 7"]
    page = (ROOT / "scenarios" / "README.md").read_text()
    for name, *cells in rows:
        assert f"| {name} |" in page, "the page has the table's rows"
        assert len(set(cells)) == 1 and cells[0], name
    values = dict(row[:2] for row in rows)
    # One locomotive in notch 7: half of the traction of the paper's two.
    assert float(values["traction at the start, kN"]) == pytest.approx(277.6 / 2.0, abs=0.1)
    assert values["speed of the train, m/s"].startswith("16.67 to ")
