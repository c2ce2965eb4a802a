"""A train that is exported as an SSP package gives in other tools what `hotfoot run` gives with
scheme = "jacobi", where all models take the values of the last exchange as these tools do."""

import platform
from ctypes import CDLL

import numpy as np
import pyarrow.parquet as parquet
import pytest
from conftest import TYPES, five_vehicles, hotfoot
from fmpy import read_model_description
from fmpy.ssp.simulation import simulate_ssp
from fmpy.ssp.ssd import Parameter, ParameterSet, find_components, read_ssd

LENGTH = 1e-3
STEPS = 2000
EVERY = 10

# The arithmetic and its order are the same, but tools count time in their own ways: libcosim in
# whole nanoseconds, so that its steps are 1 ms to within rounding. A draft gear of 1e8 N/m turns
# 1e-15 of a vehicle's position into 1e-7 N; so 1e-9 of the largest value is what can be kept.
TOLERANCE = 1e-9

# Component and variable: each of our four FMUs.
SIGNALS = [
    ("train", "vehicle[1].position"),
    ("train", "vehicle[2].coupler.rear.force"),
    ("vehicle_1", "wheelset[1].left.creepage.longitudinal"),
    ("vehicle_3", "position"),
    ("vehicle_5", "velocity"),
    ("rail", "highest.surface.rise"),
    ("controller_5", "sync.force"),
]


@pytest.fixture(scope="session")
def folder(tmp_path_factory):
    """A scenario of five vehicles, the package of it, and the results of both. The wind is an input
    that keeps its value: libcosim sets it while the train is instantiated. The heat model is the
    default, since FMPy's simulate_ssp sets no String variables."""
    folder = tmp_path_factory.mktemp("ssp")
    scheme = ("step_s = 0.001", 'step_s = 0.001\nscheme = "jacobi"')
    speed = "speed_m_per_s = 16.67"
    wind = (speed, speed + "\nwind = { speed_m_per_s = 12.0, direction_deg = 30.0 }")
    scenario = five_vehicles(folder, [scheme, wind, ('model = "paper"\n', "")])
    hotfoot("run", scenario, "--quiet", "--results", folder / "scenario")
    hotfoot("export-ssp", scenario, "--output", folder / "train.ssp")
    package = [folder / "train.ssp", "--interval", LENGTH * EVERY]
    hotfoot("run", *package, "--quiet", "--results", folder / "package")
    return folder


def ours(folder, component, variable):
    """A series of our run of the package from the first record after the start on."""
    table = parquet.read_table(folder / "package" / "series" / f"{component}.parquet")
    return table.column(variable).to_numpy()[1:]


def compare(folder, rows, tolerance=TOLERANCE):
    """Compares the values of SIGNALS that another tool gave every ten steps."""
    for (component, variable), theirs in zip(SIGNALS, np.array(rows).T):
        expected = ours(folder, component, variable)[: len(theirs)]
        scale = np.abs(expected).max()
        assert scale > 0.0, f"{component}.{variable} does nothing"
        difference = np.abs(expected - theirs).max()
        assert difference <= tolerance * scale, f"{component}.{variable}: {difference / scale:.1e}"


def test_the_package_gives_the_same_bits_as_the_scenario(folder):
    vehicles = parquet.read_table(folder / "scenario" / "series" / "vehicles.parquet").to_pandas()
    rail = parquet.read_table(folder / "scenario" / "series" / "rail.parquet").to_pandas()
    for i in range(1, len(TYPES) + 1):
        rows = vehicles[vehicles.vehicle == i].iloc[1:]
        for variable in ("position", "velocity"):
            np.testing.assert_array_equal(rows[variable], ours(folder, f"vehicle_{i}", variable))
        for end in ("front", "rear"):
            force = ours(folder, "train", f"vehicle[{i}].coupler.{end}.force")
            np.testing.assert_array_equal(rows[f"coupler_{end}_force"], force)
    for variable in ("highest.surface.rise", "highest.foot.rise"):
        np.testing.assert_array_equal(rail[variable][1:], ours(folder, "rail", variable))


def test_the_results_say_what_made_them(folder):
    manifest = (folder / "package" / "manifest.toml").read_text()
    for wanted in ("hotfoot_version", 'name = "train"', "simulated_s = 2.0", "package/resources/rail.fmu"):
        assert wanted in manifest, wanted
    for name in ("locomotive-coco-134t", "wagon-coco-134t-unpowered", "rail", "synchronisation", "train"):
        fmu = folder / "package" / "package" / "resources" / f"{name}.fmu"
        assert read_model_description(str(fmu)).guid in manifest


def test_libcosim_gives_the_same(folder):
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimLogging import CosimLogLevel, log_output_level
    from libcosimpy.CosimObserver import CosimObserver

    log_output_level(CosimLogLevel.WARNING)
    execution = CosimExecution.from_ssp_file(str(folder / "train.ssp"), step_size=LENGTH * 1e9)
    observer = CosimObserver.create_last_value()
    execution.add_observer(observer)

    def find(component, variable):
        slave = execution.slave_index_from_instance_name(component)
        variables = execution.slave_variables(slave)
        real = [v for v in variables if v.name.decode() == variable and v.type == 0]
        return slave, [real[0].reference]

    places = [find(*signal) for signal in SIGNALS]
    rows = []
    for k in range(EVERY, STEPS + 1, EVERY):
        assert execution.simulate_until(round(k * LENGTH * 1e9))
        rows.append([observer.last_real_values(*place)[0] for place in places])
    compare(folder, rows)


def needs_of_ecos():
    try:
        CDLL("libtbb.so.12")
    except OSError:
        return "ecos needs libtbb.so.12: apt-get install libtbb12"
    return None if platform.machine() == "x86_64" else "ecospy has binaries for x86_64 only"


@pytest.mark.skipif(needs_of_ecos() is not None, reason=str(needs_of_ecos()))
def test_ecos_gives_the_same(folder):
    from ecospy import EcosSimulation

    with EcosSimulation(LENGTH, ssp_path=str(folder / "train.ssp")) as simulation:
        assert simulation.init(parameter_set="start")
        rows = []
        for _ in range(0, STEPS, EVERY):
            simulation.step(EVERY)
            rows.append([simulation.get_real(f"{c}::{variable}") for c, variable in SIGNALS])
    compare(folder, rows)


def test_fmpy_gives_the_same_but_for_its_first_step(folder):
    """FMPy's simulate_ssp hands no initial outputs on: vehicles start in equilibrium without the
    train's forces, and when these come their bodies swing on the suspensions, the locomotive's
    by 1.3 mm. So positions are compared to 2 mm; forces and creepages follow the shock."""
    package = str(folder / "train.ssp")
    parameters = ParameterSet()
    for component in find_components(read_ssd(package).system):
        for binding in component.parameterBindings:
            for parameter in binding.parameterValues[0].parameters:
                name = f"{component.name}.{parameter.name}"
                parameters.parameters.append(Parameter(name=name, value=parameter.value))
    steps = 100
    result = simulate_ssp(
        package, stop_time=steps * LENGTH, step_size=LENGTH, parameter_set=parameters
    )
    for i in range(1, len(TYPES) + 1):
        theirs = result[f"vehicle_{i}.position"][EVERY - 1 :: EVERY]
        expected = ours(folder, f"vehicle_{i}", "position")[: len(theirs)]
        np.testing.assert_allclose(theirs, expected, rtol=0.0, atol=2e-3, err_msg=f"vehicle {i}")
