"""Each of our FMUs gives in other tools what it gives in `hotfoot run` of a package with it."""

import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import packages
import pandas
import pyarrow.parquet as parquet
import pytest
from conftest import FMUS, hotfoot
from fmpy import simulate_fmu

LENGTH = 1e-3
STEPS = 500
STOP = STEPS * LENGTH

# One FMU and one order of its calls: only the tools' times differ, by rounding.
TOLERANCE = 1e-9

# Start values of parameters, and outputs of each model alone: a vehicle that coasts, a train that
# its driver pulls, a rail that is warmer than the air.
CASES = {
    "vehicle": (
        {"initial.position": 100.0, "initial.velocity": 16.67},
        ["position", "velocity", "wheelset[1].left.friction_power"],
    ),
    "longitudinal": (
        {"initial.velocity": 10.0},
        ["vehicle[1].velocity", "vehicle[1].coupler.rear.force"],
    ),
    "railheat": (
        {
            "model": "paper",
            "track.length": 100.0,
            "initial.equilibrium": False,
            "initial.temperature": 320.0,
        },
        ["untouched.surface.rise", "energy.stored"],
    ),
}

# What SSP calls the types of start values.
KINDS = {float: "Real", bool: "Boolean", str: "String"}


def text(value):
    """A value as XML and the command lines of other tools have it."""
    return str(value).lower()


def alone(model, folder):
    """What `hotfoot run` gives of the outputs of a model alone, step by step."""
    parameters, outputs = CASES[model]
    start = [(name, KINDS[type(value)], text(value)) for name, value in parameters.items()]
    package = packages.write(
        folder / "alone.ssp",
        [packages.component(model, "resources/model.fmu", start=start)],
        fmus={"resources/model.fmu": FMUS[model]},
    )
    times = ["--duration", STOP, "--step", LENGTH, "--interval", LENGTH]
    hotfoot("run", package, *times, "--quiet", "--results", folder / "results")
    table = parquet.read_table(folder / "results" / "series" / f"{model}.parquet").to_pandas()
    assert len(table) == STEPS + 1
    return {name: table[name].to_numpy() for name in outputs}


def close(ours, theirs, name):
    scale = np.abs(ours).max()
    assert scale > 0.0, f"{name} does nothing"
    difference = np.abs(ours - theirs).max()
    assert difference <= TOLERANCE * scale, f"{name}: {difference / scale:.1e}"


@pytest.mark.parametrize("model", CASES)
def test_fmpy_gives_the_same(model, tmp_path):
    parameters, outputs = CASES[model]
    theirs = simulate_fmu(
        str(FMUS[model]),
        stop_time=STOP,
        output_interval=LENGTH,
        start_values=parameters,
        output=outputs,
    )
    ours = alone(model, tmp_path)
    for name in outputs:
        close(ours[name], theirs[name], f"{model}.{name}")


FMI_SIM = shutil.which("fmi-sim")


@pytest.mark.skipif(FMI_SIM is None, reason="needs `cargo install fmi-sim --version 0.7.0`")
@pytest.mark.parametrize("model", CASES)
def test_fmi_sim_gives_the_same(model, tmp_path):
    parameters, outputs = CASES[model]
    arguments = ["-q", "--model", FMUS[model], "-o", tmp_path / "out.csv"]
    arguments += ["co-simulation", "-f", STOP, "--output-interval", LENGTH]
    for name, value in parameters.items():
        arguments += ["--init-values", f"{name}={text(value)}"]
    subprocess.run([FMI_SIM, *map(str, arguments)], check=True)
    theirs = pandas.read_csv(tmp_path / "out.csv")
    ours = alone(model, tmp_path)
    for name in outputs:
        close(ours[name], theirs[name].to_numpy(), f"{model}.{name}")


# A locomotive of the train pulls and heats the rail: what flows between the three FMUs.
LINKS = [
    (("longitudinal", "vehicle[1].coupler.rear.force"), ("vehicle", "coupler.rear.force")),
    (("longitudinal", "vehicle[1].traction.force"), ("vehicle", "traction.force")),
    (("vehicle", "wheelset[1].position"), ("railheat", "vehicle[1].wheelset[1].position")),
    (("vehicle", "velocity"), ("railheat", "vehicle[1].wheelset[1].speed")),
] + [
    (("vehicle", f"wheelset[1].left.{name}"), ("railheat", f"vehicle[1].wheelset[1].{name}"))
    for name in ("friction_power", "force.normal", "contact.a", "contact.b")
]
START = {
    "longitudinal": {"initial.velocity": 16.67},
    "vehicle": {"initial.position": 50.0, "initial.velocity": 16.67},
    "railheat": {"track.length": 100.0},
}
OUTPUTS = [
    ("vehicle", "velocity"),
    ("longitudinal", "vehicle[1].coupler.rear.force"),
    ("railheat", "highest.flash.rise"),
]


def test_fmucontainer_gives_the_same_system(tmp_path):
    """Three of our FMUs, coupled, in one container FMU, whose master is the container's own."""
    fmus = {f"resources/{model}.fmu": FMUS[model] for model in START}
    connectors = {model: [] for model in START}
    for start, end in LINKS:
        connectors[start[0]].append((start[1], "output"))
        connectors[end[0]].append((end[1], "input"))
    components = [
        packages.component(
            model,
            f"resources/{model}.fmu",
            dict.fromkeys(connectors[model]),
            [(name, "Real", value) for name, value in START[model].items()],
        )
        for model in START
    ]
    connections = [packages.connection(start, end) for start, end in LINKS]
    package = packages.write(tmp_path / "system.ssp", components, connections, fmus)
    times = ["--duration", STOP, "--step", LENGTH, "--interval", LENGTH, "--record", "*"]
    hotfoot("run", package, *times, "--quiet", "--results", tmp_path / "results")

    folder = tmp_path / "container"
    folder.mkdir()
    lines = ["rule;from_fmu;from_port;to_fmu;to_port"]
    for model in START:
        shutil.copy(FMUS[model], folder)
        lines.append(f"FMU;{model}.fmu;;;")
    lines += [f"LINK;{a}.fmu;{x};{b}.fmu;{y}" for (a, x), (b, y) in LINKS]
    lines += [f"OUTPUT;{model}.fmu;{name};;result.{model}.{name}" for model, name in OUTPUTS]
    (folder / "system.csv").write_text("\n".join(lines))
    program = Path(sys.executable).with_name("fmucontainer")
    options = ["-auto-parameter", "-no-auto-output", "-no-auto-link"]
    arguments = ["-fmu-directory", folder, "-container", f"system.csv:{LENGTH}", *options]
    subprocess.run([program, *map(str, arguments)], check=True)
    theirs = simulate_fmu(
        str(folder / "system.fmu"),
        stop_time=STOP,
        output_interval=LENGTH,
        start_values={f"{m}.{n}": v for m, values in START.items() for n, v in values.items()},
        output=[f"result.{model}.{name}" for model, name in OUTPUTS],
    )
    for model, name in OUTPUTS:
        table = parquet.read_table(tmp_path / "results" / "series" / f"{model}.parquet")
        ours = table.column(name).to_numpy()
        close(ours, theirs[f"result.{model}.{name}"], f"{model}.{name}")
