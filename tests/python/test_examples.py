"""The Python example reads a run as its README says."""

import subprocess
import sys

from conftest import ROOT

SCRIPT = ROOT / "examples" / "read-results" / "read_results.py"


def test_the_results_of_a_run_are_read(run):
    done = subprocess.run([sys.executable, SCRIPT, run], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert lines[0] == "coupler forces, N"
    assert any(line.startswith("highest rise ") and " K at " in line for line in lines)
    # The locomotive pulls four wagons: the coupler behind it is the one with the greatest tension.
    tensions = {int(row[0]): float(row[1]) for row in map(str.split, lines[3:8])}
    assert max(tensions, key=tensions.get) == 1
