"""Numbers on pages that Python code beside them makes: the code is run, and the page has what it prints."""

import re
import subprocess
import sys

from conftest import ROOT

import hotfoot


def test_the_wet_rail_heats_as_its_page_says(tmp_path):
    """The first 16 s of it: dry, and wet, for both locomotives; the page rounds to whole W and 0.1 kN."""
    page = (ROOT / "scenarios" / "wet-rail" / "README.md").read_text()
    hotfoot.run(ROOT / "scenarios" / "wet-rail", results=tmp_path / "R", duration_s=16.0)
    (code,) = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    command = [sys.executable, "-c", f"import sys; sys.path[:] = {sys.path}\n{code}"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    printed = [[float(value) for value in line.split()] for line in done.stdout.splitlines()]
    assert [row[0] for row in printed] == [1, 1, 2, 2]
    for _, chainage, force, creepage, power in printed:
        row = f"| {chainage:.0f} | {force / 1e3:.1f} | {100.0 * creepage:.3f} | {power:.0f} |"
        assert row in page
