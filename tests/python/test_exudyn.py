"""The suspension against Exudyn 1.13.6, a general multibody program: the same bodies on the same
springs, with the wheelsets held. It has no wheel-rail contact, so that this is all it can check."""

import csv
import io
import subprocess
import tomllib

import exudyn as exu
import exudyn.itemInterface as item
import numpy as np
import pytest
from conftest import FMUS, ROOT, TARGET
from fmpy import simulate_fmu

GRAVITY = 9.80665


def suspension(name):
    """Bodies, wheelsets and springs of a vehicle file."""
    return tomllib.loads((ROOT / "stock/vehicles" / f"{name}.toml").read_text())["multibody"]


class Model:
    """The vehicle in Exudyn: x forward, y to the right, z down."""

    def __init__(self, vehicle, gravity):
        self.system = exu.SystemContainer()
        self.mbs = self.system.AddSystem()
        self.ground = self.mbs.AddObject(item.ObjectGround())
        self.bodies, self.places = {}, {}
        for body in vehicle["body"]:
            self.add_body(body, gravity)
        self.pressing = {wheelset["name"]: [] for wheelset in vehicle["wheelset"]}
        for spring in vehicle["spring"]:
            for point in spring["points_m"]:
                self.add_spring(spring, point)
        self.mbs.Assemble()

    def add_body(self, body, gravity):
        place = np.array([body["x_m"], 0.0, -body["height_m"]])
        node = item.NodeRigidBodyRxyz(referenceCoordinates=[*place, 0.0, 0.0, 0.0])
        inertia = [*body["inertia_kg_m2"], 0.0, 0.0, 0.0]
        rigid = self.mbs.AddObject(
            item.ObjectRigidBody(
                mass=body["mass_kg"],
                inertia=inertia,
                nodeNumber=self.mbs.AddNode(node),
            )
        )
        self.bodies[body["name"]], self.places[body["name"]] = rigid, place
        middle = self.mbs.AddMarker(item.MarkerBodyPosition(bodyNumber=rigid))
        load = [0.0, 0.0, gravity * body["mass_kg"]]
        self.mbs.AddLoad(item.LoadForceVector(markerNumber=middle, loadVector=load))

    def marker(self, name, point):
        body = self.bodies.get(name, self.ground)
        arm = point - self.places.get(name, np.zeros(3))
        return self.mbs.AddMarker(item.MarkerBodyPosition(bodyNumber=body, localPosition=arm))

    def add_spring(self, spring, point):
        point = np.array([point[0], point[1], -point[2]])
        markers = [self.marker(name, point) for name in spring["between"]]
        connector = self.mbs.AddObject(
            item.CartesianSpringDamper(markerNumbers=markers, stiffness=spring["stiffness_n_m"])
        )
        if spring["between"][1] in self.pressing:
            force = item.SensorObject(
                objectNumber=connector, outputVariableType=exu.OutputVariableType.Force
            )
            self.pressing[spring["between"][1]].append(self.mbs.AddSensor(force))


@pytest.mark.parametrize("name", ["locomotive-coco-134t"])
def test_natural_frequencies(name):
    """All frequencies of the undamped system without load agree to 0.01 %: both are exact for the
    same linear system, Exudyn's Jacobian is a difference quotient."""
    model = Model(suspension(name), gravity=0.0)
    squares, _ = exu.ComputeODE2Eigenvalues(model.mbs)
    expected = np.sqrt(np.maximum(np.sort(np.real(squares)), 0.0)) / (2.0 * np.pi)

    program = TARGET / "release" / "hotfoot"
    arguments = ["modes", name, "--undamped", "--csv", "--stock", ROOT / "stock"]
    text = subprocess.run([program, *arguments], capture_output=True, text=True, check=True).stdout
    found = sorted(float(row["frequency_hz"]) for row in csv.DictReader(io.StringIO(text)))
    assert np.allclose(found, expected, rtol=1e-4), np.c_[found, expected]


def test_static_loads():
    """The load of each wheelset on its primary springs and the weight of the wheelset are what its
    wheels carry in the FMU, within 0.05 %: Exudyn's springs sink some centimetres, ours stand at
    their given heights."""
    vehicle = suspension("locomotive-coco-134t")
    model = Model(vehicle, gravity=GRAVITY)
    settings = exu.SimulationSettings()
    settings.staticSolver.numberOfLoadSteps = 1
    settings.solution.file.write = False
    model.mbs.SolveStatic(settings)

    output = [f"wheelset[{i}].{side}.track_force.vertical" for i in range(1, 7) for side in
              ("left", "right")]
    start = {"initial.velocity": 10.0}
    result = simulate_fmu(FMUS["vehicle"], stop_time=1e-3, output_interval=1e-3,
                          start_values=start, output=output)
    for i, wheelset in enumerate(vehicle["wheelset"], start=1):
        sensors = model.pressing[wheelset["name"]]
        pressed = -sum(model.mbs.GetSensorValues(sensor)[2] for sensor in sensors)
        expected = pressed + GRAVITY * wheelset["mass_kg"]
        found = sum(result[f"wheelset[{i}].{side}.track_force.vertical"][0]
                    for side in ("left", "right"))
        assert found == pytest.approx(expected, rel=5e-4)
