"""`hotfoot run` from Python."""

from __future__ import annotations

import json
import os
import signal
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from hotfoot._results import Results
from hotfoot._results import open as open_results
from hotfoot._shipped import RunError, program


def run(
    scenario: str | os.PathLike[str],
    *,
    results: str | os.PathLike[str] | None = None,
    overwrite: bool = False,
    threads: int | None = None,
    options: Sequence[str] = (),
    settings: Mapping[str, Any] | None = None,
    **changes: Any,
) -> Results:
    """Runs a scenario, an SSP package or an FMU to its end, and opens the results.

    Parameters
    ----------
    scenario
        Folder or file of a scenario, name of a shipped one such as ``"first-look"``, an ``.ssp`` or
        an ``.fmu``.
    results
        Folder of the results; left out: a new one in ``results``.
    overwrite
        Whether the results of an earlier run in that folder are replaced.
    threads
        Threads for the vehicles; left out: all cores.
    options
        Further arguments of ``hotfoot run``, such as ``["--interval", "0.01"]``.
    settings, **changes
        Values of keys of the scenario in place of those in its file, as ``--set`` takes them. A key
        with dots stands in ``settings``, or as a table in ``changes``:
        ``run("first-look", duration_s=5.0, train={"speed_m_per_s": 20.0})`` is the same as
        ``run("first-look", settings={"duration_s": 5.0, "train.speed_m_per_s": 20.0})``.

    Raises
    ------
    RunError
        When the run fails, in the sentences of the command line.
    KeyboardInterrupt
        When it is interrupted; what was recorded until then can be opened.
    """
    command = [os.fspath(program()), "run", os.fspath(scenario), "--quiet", *options]
    if results is not None:
        command += ["--results", os.fspath(results)]
    if overwrite:
        command.append("--overwrite")
    if threads is not None:
        command += ["--threads", str(threads)]
    for setting in as_settings({**(settings or {}), **changes}):
        command += ["--set", setting]
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8"
    )
    try:
        said, errors = process.communicate()
    except KeyboardInterrupt:
        process.send_signal(signal.SIGINT)
        process.communicate()
        raise
    if process.returncode != 0:
        raise RunError(_sentence(errors))
    return open_results(_folder(said, results))


def as_settings(changes: Mapping[str, Any], prefix: str = "") -> list[str]:
    """Keys and values as ``KEY=VALUE`` of ``--set``, with the keys of tables behind dots."""
    settings = []
    for key, value in changes.items():
        if isinstance(value, Mapping):
            settings += as_settings(value, f"{prefix}{key}.")
        else:
            settings.append(f"{prefix}{key}={_as_toml(value)}")
    return settings


def _as_toml(value: Any) -> str:
    """A value as TOML writes it."""
    if isinstance(value, (bool, str)):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, os.PathLike):
        return json.dumps(os.fspath(value), ensure_ascii=False)
    if isinstance(value, Mapping):
        pairs = (f"{json.dumps(key)} = {_as_toml(inner)}" for key, inner in value.items())
        return "{ " + ", ".join(pairs) + " }"
    if hasattr(value, "tolist"):
        return _as_toml(value.tolist())
    if isinstance(value, Sequence):
        return "[" + ", ".join(map(_as_toml, value)) + "]"
    if isinstance(value, (int, float)):
        return repr(value)
    raise TypeError(f"{value!r} is no value that a scenario can have: number, text, bool, list or table")


def _sentence(errors: str) -> str:
    """What the program says behind `Error:`, or all that it says."""
    _, found, sentence = errors.rpartition("Error: ")
    return (sentence if found else errors).strip()


def _folder(said: str, results: str | os.PathLike[str] | None) -> Path:
    """The folder of the results: the one asked for, or that of the report which the program names."""
    if results is not None:
        return Path(results)
    reports = [line for line in said.splitlines() if line.startswith("report: ")]
    return Path(reports[-1].removeprefix("report: ")).parent
