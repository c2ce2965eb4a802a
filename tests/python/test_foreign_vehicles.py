"""Vehicles of other makers in our train: one from PythonFMU and one in C that counts in kN and
km/h, both point masses without wheels and with names of their own."""

import os
import subprocess
import sys
import sysconfig
from pathlib import Path
from zipfile import ZipFile

import numpy as np
import packages
import pyarrow.parquet as parquet
import pytest
from conftest import FMUS, HOTFOOT, RECORD, ROOT, five_vehicles, hotfoot
from fmpy.validation import validate_fmu

FOREIGN = Path(__file__).parent / "foreign"
IN_TUTORIAL = ROOT / "docs" / "tutorials" / "swap-an-fmu.in"

# Their names for our signals.
IN_PYTHON = {
    "initial.position": "start_position",
    "initial.velocity": "start_velocity",
    "coupler.front.force": "front",
    "coupler.rear.force": "rear",
    "sync.force": "control",
    "resistance.force": "drag",
}
IN_C = IN_PYTHON | {
    "initial.position": "start_km_post",
    "initial.velocity": "start_speed",
    "position": "km_post",
    "velocity": "speed",
}


@pytest.fixture(scope="session")
def in_python(tmp_path_factory):
    """The FMU that PythonFMU makes."""
    folder = tmp_path_factory.mktemp("pythonfmu")
    program = Path(sys.executable).with_name("pythonfmu")
    subprocess.run([program, "build", "-f", FOREIGN / "pointmass.py", "-d", folder], check=True)
    return folder / "PointMass.fmu"


@pytest.fixture(scope="session")
def in_c(tmp_path_factory):
    """The FMU in C."""
    folder = tmp_path_factory.mktemp("c")
    library = folder / "pointmass.so"
    flags = ["-shared", "-fPIC", "-O2", "-Wall", "-Wextra", "-Werror"]
    subprocess.run(["cc", *flags, IN_TUTORIAL / "pointmass.c", "-o", library], check=True)
    with ZipFile(folder / "pointmass.fmu", "w") as fmu:
        fmu.write(IN_TUTORIAL / "modelDescription.xml", "modelDescription.xml")
        fmu.write(library, "binaries/linux64/pointmass.so")
    return folder / "pointmass.fmu"


def environment(with_python):
    """PythonFMU's binaries look for Python in the process that loads them."""
    if not with_python:
        return os.environ
    library = Path(sysconfig.get_config_var("LIBDIR")) / sysconfig.get_config_var("INSTSONAME")
    if not library.exists():
        pytest.skip(f"this Python has no shared library {library}, which PythonFMU's FMUs need")
    return os.environ | {"LD_PRELOAD": str(library)}


def run(scenario, results, with_python=False, duration=2.0):
    arguments = ["run", scenario, "--quiet", "--results", results, "--duration", duration]
    return subprocess.run(
        [HOTFOOT, *map(str, arguments)],
        capture_output=True,
        text=True,
        env=environment(with_python),
    )


def replacement(place, fmu, names):
    names = ", ".join(f'"{ours}" = "{theirs}"' for ours, theirs in names.items())
    return f'\n[[fmus.vehicle_at]]\nplace = {place}\nfile = "{fmu}"\nnames = {{ {names} }}\n'


def vehicle(results, place):
    table = parquet.read_table(results / "series" / "vehicles.parquet").to_pandas()
    return table[table.vehicle == place]


def check_it_follows_the_train(results, place):
    """Newton's law, from what is recorded: the force of two seconds has given the change of
    speed; within 1 %, since the records are ten steps apart."""
    rows = vehicle(results, place)
    assert abs(rows.position_error).max() < 0.05
    force = rows.coupler_front_force - rows.coupler_rear_force + rows.sync_force
    force += rows.resistance_force
    time = rows.time.to_numpy()
    impulse = np.trapezoid(force.to_numpy(), time)
    change = 134e3 * (rows.velocity.iloc[-1] - rows.velocity.iloc[0])
    assert impulse == pytest.approx(change, rel=0.01)


@pytest.mark.parametrize("maker", ["in_python", "in_c"])
def test_a_foreign_vehicle_runs_at_place_17_of_the_papers_train(maker, request, tmp_path):
    fmu = request.getfixturevalue(maker)
    names = {"in_python": IN_PYTHON, "in_c": IN_C}[maker]
    paper = ROOT / "scenarios" / "curve-increasing-speed"
    for name in ("track.toml", "driver.toml"):
        (tmp_path / name).write_text((paper / name).read_text())
    text = (paper / "scenario.toml").read_text()
    text = text.replace("[train]", f'stock = "{ROOT / "stock"}"\n[train]', 1)
    text = text.replace("\ninterval_s = 0.1", "\ninterval_s = 0.01")
    scenario = tmp_path / "scenario.toml"
    scenario.write_text(text + replacement(17, fmu, names))
    results = tmp_path / "results"
    done = run(scenario, results, with_python=maker == "in_python")
    assert done.returncode == 0, done.stderr
    check_it_follows_the_train(results, 17)
    # It has no wheels, so the rail knows 129 vehicles with six wheelsets and one with none.
    assert (vehicle(results, 17).friction_power == 0.0).all()
    assert (vehicle(results, 16).friction_power > 0.0).any()


def test_both_makers_vehicles_move_alike(in_python, in_c, tmp_path):
    """The same equation in SI and in kN and km/h: equal to the rounding of the conversions."""
    trajectories = []
    for name, fmu, names in (("python", in_python, IN_PYTHON), ("c", in_c, IN_C)):
        folder = tmp_path / name
        folder.mkdir()
        scenario = five_vehicles(folder, further=replacement(3, fmu, names))
        done = run(scenario, folder / "results", with_python=name == "python")
        assert done.returncode == 0, done.stderr
        trajectories.append(vehicle(folder / "results", 3))
    for column in ("position", "velocity"):
        python, c = (rows[column].to_numpy() for rows in trajectories)
        np.testing.assert_allclose(c, python, rtol=1e-12, atol=1e-11)


def test_all_vehicles_may_be_foreign(in_c, tmp_path):
    names = ", ".join(f'"{ours}" = "{theirs}"' for ours, theirs in IN_C.items())
    further = RECORD + f'\n[fmus]\nvehicle = "{in_c}"\nvehicle_names = {{ {names} }}\n'
    scenario = five_vehicles(tmp_path)
    text = scenario.read_text()
    scenario.write_text(text[: text.index("[heat]")] + further)
    done = run(scenario, tmp_path / "results")
    assert done.returncode == 0, done.stderr
    check_it_follows_the_train(tmp_path / "results", 5)


def test_what_a_foreign_vehicle_lacks_is_said_before_the_run(in_c, tmp_path):
    """One sentence for each: a name that is wrong, and one that is not given."""
    names = IN_C | {"coupler.front.force": "frnt"}
    del names["sync.force"]
    scenario = five_vehicles(tmp_path, further=replacement(3, in_c, names))
    done = run(scenario, tmp_path / "results")
    assert done.returncode != 0
    for sentence in ("the Real input 'frnt' is missing", "the Real input 'sync.force' is missing"):
        assert sentence in done.stderr, done.stderr
    assert not (tmp_path / "results" / "series").exists()


def test_the_c_vehicle_is_an_fmu_that_fmpy_accepts(in_c):
    assert validate_fmu(str(in_c)) == []


def package(folder, in_c, of_speed):
    """The C vehicle and our controller, which holds it back: the one counts in km/h and kN, the
    other in m/s and N. `of_speed` is the vehicle's output that goes to the controller's speed."""
    vehicle = [(of_speed, "output"), ("control", "input")]
    controller = [("vehicle.velocity", "input"), ("sync.force", "output")]
    start = [("start_speed", "Real", 36.0)]
    return packages.write(
        folder / "system.ssp",
        [
            packages.component("mass", "resources/mass.fmu", vehicle, start),
            packages.component("controller", "resources/controller.fmu", controller),
        ],
        [
            packages.connection(("mass", of_speed), ("controller", "vehicle.velocity")),
            # The ends may stand in either order.
            packages.connection(("mass", "control"), ("controller", "sync.force")),
        ],
        {"resources/mass.fmu": in_c, "resources/controller.fmu": FMUS["synchronisation"]},
    )


def test_units_are_converted_between_the_components_of_a_package(in_c, tmp_path):
    """36 km/h are 10 m/s, which the controller answers with 10 kN s/m times 10 m/s = 100 kN; the
    mass of 134 t feels them in the step after. Tolerance: rounding of 1/3.6."""
    times = ["--duration", 0.002, "--step", 0.001, "--interval", 0.001]
    results = tmp_path / "results"
    hotfoot("run", package(tmp_path, in_c, "speed"), *times, "--quiet", "--results", results)

    def series(component, name):
        table = parquet.read_table(results / "series" / f"{component}.parquet")
        return table.column(name).to_numpy()

    np.testing.assert_allclose(series("controller", "sync.force"), [0.0, -1e5, -1e5], rtol=1e-12)
    slower = 100e3 / 134e3 * 1e-3 * 3.6
    np.testing.assert_allclose(series("mass", "speed"), [36.0, 36.0, 36.0 - slower], rtol=1e-12)


def test_units_that_do_not_fit_are_said_before_the_run(in_c, tmp_path):
    done = run(package(tmp_path, in_c, "km_post"), tmp_path / "results")
    assert done.returncode != 0
    assert "the units 'km' and 'm/s' measure different things" in done.stderr, done.stderr
