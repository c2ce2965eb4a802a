"""Hotfoot in Python: run a scenario, read its results, or step it yourself.

>>> import hotfoot
>>> results = hotfoot.run("first-look", duration_s=5.0)       # doctest: +SKIP
>>> results.table("vehicles").attrs["units"]["coupler_rear_force"]  # doctest: +SKIP
'N'

| name | what it is |
|---|---|
| `open` | the results in a folder: tables, fields, figures, scenario |
| `run` | `hotfoot run`, and the results |
| `System` | a scenario or an SSP package that is stepped, read, set, saved and restored |
| `RunError` | why a run failed, in the sentences of the command line |
| `program`, `scenarios`, `fmus`, `stock` | where what is shipped lies |
"""

from hotfoot._results import Results, open
from hotfoot._run import run
from hotfoot._shipped import RunError, fmus, program, scenarios, stock
from hotfoot._system import System

__all__ = [
    "Results",
    "RunError",
    "System",
    "fmus",
    "open",
    "program",
    "run",
    "scenarios",
    "stock",
]
