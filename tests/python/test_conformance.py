"""The FMUs as FMPy sees them: no complaint, and each runs alone."""

import numpy as np
import pytest
from conftest import FMUS
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu


@pytest.mark.parametrize("model", FMUS)
def test_fmpy_validate_finds_no_problem(model):
    assert validate_fmu(str(FMUS[model])) == []


@pytest.mark.parametrize("model", FMUS)
def test_the_fmu_holds_what_users_look_for(model):
    from zipfile import ZipFile

    names = ZipFile(FMUS[model]).namelist()
    for wanted in (
        "modelDescription.xml",
        f"binaries/linux64/{model}.so",
        "documentation/index.html",
        "documentation/equations.html",
        "documentation/licenses/license.txt",
        "documentation/licenses/LICENSE-MIT",
        "documentation/licenses/LICENSE-APACHE",
        "model.png",
        "extra/org.fmi-standard.fmi-ls-ref/ref.csv",
    ):
        assert wanted in names
    # The controller reads no files.
    assert model == "synchronisation" or any(name.startswith("resources/") for name in names)


@pytest.mark.parametrize("model", ["vehicle", "longitudinal", "railheat"])
def test_terminals_keep_the_schema_and_name_variables(model):
    from pathlib import Path
    from zipfile import ZipFile

    import fmpy
    from lxml import etree

    file = Path(fmpy.__file__).parent / "schema/fmi3/fmi3TerminalsAndIcons.xsd"
    schema = etree.XMLSchema(etree.parse(str(file)))
    text = ZipFile(FMUS[model]).read("terminalsAndIcons/terminalsAndIcons.xml")
    document = etree.fromstring(text)
    schema.assertValid(document)
    names = {v.name for v in read_model_description(str(FMUS[model])).modelVariables}
    members = {m.get("variableName") for m in document.iter("TerminalMemberVariable")}
    assert members and members <= names


@pytest.mark.parametrize("model", FMUS)
def test_every_real_has_a_unit_and_every_variable_a_description(model):
    for variable in read_model_description(str(FMUS[model])).modelVariables:
        assert variable.description, variable.name
        assert variable.type != "Real" or variable.unit, variable.name


def test_the_vehicle_runs_alone_and_coasts():
    result = simulate_fmu(
        str(FMUS["vehicle"]),
        stop_time=2.0,
        output_interval=1e-3,
        start_values={"initial.velocity": 16.67},
        output=["position", "velocity"],
    )
    distance = result["position"][-1] - result["position"][0]
    # Free rolling on straight track: only creep of the wheels in equilibrium slows it.
    assert abs(distance - 2.0 * 16.67) < 0.01


def test_the_train_runs_alone_and_pulls():
    result = simulate_fmu(
        str(FMUS["longitudinal"]),
        stop_time=10.0,
        output_interval=1e-3,
        start_values={"initial.velocity": 16.67},
        output=["vehicle[1].velocity", "vehicle[1].coupler.rear.force", "vehicle[2].coupler.front.force"],
    )
    assert result["vehicle[1].velocity"][-1] > 16.67
    assert result["vehicle[1].coupler.rear.force"][-1] > 0.0
    np.testing.assert_array_equal(
        result["vehicle[1].coupler.rear.force"], result["vehicle[2].coupler.front.force"]
    )


def test_the_rail_runs_alone_and_is_heated_by_a_wheel_with_friction():
    wheel = "vehicle[1].wheelset[1]"
    time = np.linspace(0.0, 2.0, 2001)
    names = ["position", "speed", "friction_power", "force.normal", "contact.a", "contact.b"]
    dtype = [("time", float)] + [(f"{wheel}.{name}", float) for name in names]
    signals = np.zeros(time.size, dtype=dtype)
    signals["time"] = time
    signals[f"{wheel}.position"] = 10.0 + 16.67 * time
    for name, value in zip(names[1:], [16.67, 20e3, 109.5e3, 7e-3, 6e-3]):
        signals[f"{wheel}.{name}"] = value
    result = simulate_fmu(
        str(FMUS["railheat"]),
        stop_time=2.0,
        output_interval=1e-3,
        input=signals,
        start_values={"track.begin": 0.0, "track.length": 100.0},
        output=["highest.surface.rise", "highest.foot.rise"],
    )
    assert result["highest.surface.rise"][-1] > 1.0
    assert result["highest.foot.rise"][-1] < 0.01
