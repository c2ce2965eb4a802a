"""`hotfoot.System`: it gives the bits of `hotfoot run`, and Python models stand for its components."""

import time

import numpy
import pytest
from conftest import five_vehicles, hotfoot as command

import hotfoot

SHORT = 0.2
POSITIONS = [f"vehicle[{number}].position" for number in range(1, 6)]
FORCES = [f"train.vehicle[{number}].coupler.rear.force" for number in range(1, 6)]


@pytest.fixture(scope="module")
def scenario(tmp_path_factory):
    return five_vehicles(tmp_path_factory.mktemp("system"))


class PointMass:
    """A vehicle without wheels: one mass on a straight track."""

    FORCES = ("coupler.front.force", "resistance.force", "traction.force", "sync.force")

    def __init__(self, mass):
        self.mass = mass

    def start(self, time, parameters):
        self.position = parameters["initial.position"]
        self.velocity = parameters["initial.velocity"]
        return self.motion()

    def step(self, time, step, inputs):
        force = sum(inputs[name] for name in self.FORCES) - inputs["coupler.rear.force"]
        before = self.velocity
        self.velocity += force / self.mass * step
        self.position += 0.5 * (before + self.velocity) * step
        return self.motion()

    def motion(self):
        return {"position": self.position, "velocity": self.velocity}


def test_stepped_from_python_it_gives_the_bits_of_the_run(run, scenario):
    system = hotfoot.System(scenario, duration_s=2.0)
    results = hotfoot.open(run)
    vehicles = results.table("vehicles").set_index(["time", "vehicle"])
    train = results.table("train").set_index("time")
    wheels = results.table("wheels").set_index(["time", "vehicle", "wheelset", "side"])
    rail = results.table("rail").set_index("time")
    for time in train.index[1:]:
        system.step(10)
        of_time = vehicles.loc[time]
        assert system.get(POSITIONS).tolist() == of_time["position"].tolist()
        assert system.get(FORCES[:4]).tolist() == of_time["coupler_rear_force"].tolist()[:4]
        assert system["train.energy.residual"] == train.loc[time, "energy.residual"]
        creepage = system["vehicle[3].wheelset[2].left.creepage.lateral"]
        assert creepage == wheels.loc[(time, 3, 2, "left"), "creepage_lateral"]
        assert system["rail.highest.surface.rise"] == rail.loc[time, "highest.surface.rise"]
    assert system.steps_left == 0
    assert system.time == 2.0
    with pytest.raises(ValueError, match="the system ends at 2 s, which is 0 steps from here, and not 1"):
        system.step()


def test_a_saved_state_goes_on_with_the_same_bits_in_any_system_of_the_scenario(scenario):
    system = hotfoot.System(scenario, duration_s=SHORT)
    watched = [*POSITIONS, *FORCES, "vehicle[5].wheelset[1].right.friction_power"]

    def go_on(system):
        values = []
        for _ in range(5):
            system.step(20)
            values.append(system.get(watched).tolist())
        return values

    system.set("train.driver.notch", 4.0)
    system.step(50)
    state = system.save()
    expected = go_on(system)
    system.set("train.driver.notch", 0.0)
    system.restore(state)
    assert system.time == 0.05
    assert go_on(system) == expected
    other = hotfoot.System(scenario, duration_s=SHORT, threads=1)
    other.restore(state)
    assert go_on(other) == expected


def test_an_input_that_python_sets_is_in_force(scenario):
    plain, driven = (hotfoot.System(scenario, duration_s=SHORT) for _ in range(2))
    driven.set({"train.driver.notch": 0.0, "train.driver.train_brake": 1.0})
    for system in (plain, driven):
        system.step(200)
    assert driven["train.driver.notch"] == 0.0
    # The traction falls as fast as its ramp lets it.
    assert driven["train.train.traction.force"] < plain["train.train.traction.force"]


def test_a_package_is_stepped_as_the_run_does(scenario, tmp_path):
    package = tmp_path / "train.ssp"
    command("export-ssp", scenario, "--output", package)
    options = ["--duration", "0.1", "--interval", "0.1"]
    results = hotfoot.run(package, results=tmp_path / "results", options=options)
    system = hotfoot.System(package, duration_s=0.1)
    system.step(100)
    for name in ("position", "velocity"):
        assert system[f"vehicle_3.{name}"] == results.table("vehicle_3")[name].iloc[-1]
    with pytest.raises(hotfoot.RunError, match="sets a key of a scenario; a package or an FMU has none"):
        hotfoot.System(package, settings={"step_s": 0.002})


def test_a_python_vehicle_and_controller_go_with_the_train(scenario):
    """A point mass of a wagon's mass differs from the wagon by its suspension only."""
    calls = []

    def controller(time, step, inputs):
        calls.append((time, step))
        error = inputs["vehicle.position"] - inputs["train.position"]
        closing = inputs["vehicle.velocity"] - inputs["train.velocity"]
        return {"sync.force": -2e3 * error - 1e4 * closing}

    plain = hotfoot.System(scenario, duration_s=SHORT)
    system = hotfoot.System(
        scenario, duration_s=SHORT, replace={"vehicle[3]": PointMass(134e3), "controller[3]": controller}
    )
    assert "in place of" in system.components["vehicle[3]"]
    for one in (plain, system):
        one.step(200)
    assert len(calls) == 200 and calls[3] == (0.003, 0.001)
    assert system["vehicle[3].position"] == pytest.approx(plain["vehicle[3].position"], abs=1e-3)
    assert system["vehicle[3].position"] != plain["vehicle[3].position"]
    assert system["vehicle[2].position"] == plain["vehicle[2].position"], "only it is another"


def test_five_vehicles_with_python_in_the_loop_take_more_than_2000_steps_a_second(scenario):
    """The quickest of five rounds counts, since other programs share the machine."""
    replace = {"vehicle[3]": PointMass(134e3), "controller[2]": lambda *_: {"sync.force": 0.0}}
    system = hotfoot.System(scenario, duration_s=1.0, replace=replace)
    rounds = []
    for _ in range(5):
        begin = time.perf_counter()
        system.step(200)
        rounds.append(time.perf_counter() - begin)
    print(f"{200 / min(rounds):.0f} steps a second")
    assert 200 / min(rounds) > 2000.0


def test_the_state_of_a_python_model_is_saved(scenario):
    system = hotfoot.System(scenario, duration_s=SHORT, replace={"vehicle[3]": PointMass(134e3)})
    system.step(30)
    state = system.save()
    system.step(30)
    expected = system.get(POSITIONS).tolist()
    system.restore(state)
    system.step(30)
    assert system.get(POSITIONS).tolist() == expected


def test_what_a_python_model_does_wrong_is_told_with_its_cause(scenario):
    def opened(model):
        return hotfoot.System(scenario, duration_s=SHORT, replace={"controller[2]": model})

    def fails(time, step, inputs):
        raise ZeroDivisionError("the speed is zero")

    system = opened(fails)
    with pytest.raises(hotfoot.RunError, match=r"at 0 s: controller\[2\]: .*the speed is zero") as raised:
        system.step()
    assert isinstance(raised.value.__cause__, ZeroDivisionError)
    with pytest.raises(ValueError, match="the step from 0 s has failed; restore a state"):
        system.step()
    for answer, sentence in [
        ({"sync.force": float("nan")}, r"not a finite number .*sync\.force = NaN"),
        ({"sync.forc": 1.0}, "no output of what it stands for; did you mean `sync.force`"),
        ({"sync.force": "much"}, "sync.force = much: no number"),
        (3.0, "it must answer a dict of its outputs, or None"),
    ]:
        with pytest.raises(hotfoot.RunError, match=sentence):
            opened(lambda time, step, inputs, answer=answer: answer).step()
    with pytest.raises(TypeError, match="is no model: it must be a function"):
        opened(7)
    with pytest.raises(ValueError, match=r"no component `vehicle\[9\]`.*there are .*vehicle\[5\]"):
        hotfoot.System(scenario, replace={"vehicle[9]": fails})


def test_wrong_names_values_and_shapes_are_told_in_sentences(scenario):
    system = hotfoot.System(scenario, duration_s=SHORT)
    for request, sentence in [
        (lambda: system.get("vehicle[3].speed"), r"vehicle\[3\] has no variable `speed`"),
        (lambda: system.get("wagon.position"), "no component `wagon`"),
        (lambda: system.get("rail.model"), "rail.model is a String, and no number"),
        (lambda: system.set("train.driver.notch", numpy.nan), "NaN: it must be a finite number"),
        (lambda: system.set("train.driver.notch", 99.0), "to 99: it must be from -1 to 8"),
        (lambda: system.set("vehicle[3].velocity", 1.0), "it is no input"),
        (lambda: system.set("vehicle[3].coupler.front.force", 1.0), "it is connected"),
        (lambda: system.set(["train.driver.notch"], [1.0, 2.0]), "1 names and 2 values"),
        (lambda: system.set(["train.driver.notch"], [[1.0], [2.0]]), r"values have the shape \(2, 1\)"),
        (lambda: system.restore(b"nonsense"), "this is no state of such a system"),
        (lambda: system.step(-1), "takes no -1 steps"),
        (lambda: system.variables("wagon"), "no component `wagon`"),
    ]:
        with pytest.raises(ValueError, match=sentence):
            request()
    with pytest.raises(hotfoot.RunError, match="duration_s"):
        hotfoot.System(scenario, settings={"duration_s": -1.0})


def test_variables_are_listed_with_their_units(scenario):
    system = hotfoot.System(scenario, duration_s=SHORT)
    assert {"train", "vehicle[1]", "controller[5]", "rail"} <= system.components.keys()
    variables = system.variables("vehicle[3]")
    assert variables.loc["coupler.front.force", ["causality", "type", "unit"]].tolist() == ["input", "Real", "N"]
