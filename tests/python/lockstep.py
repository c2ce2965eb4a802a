"""Hotfoot's whole step loop with FMPy: a template for masters of your own.

The FMUs of a run lie in its results folder: `train.fmu` for the whole train, one FMU for each
type of vehicle, and `rail.fmu`. This is the sequential scheme of docs/user-guide: the train steps
first, then each vehicle with the train's new forces and a synchronisation force from the errors
before, then the rail with what the wheels did.
"""

from ctypes import c_double, c_uint
from pathlib import Path

import numpy as np
from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Slave

# Gains of the synchronisation controller (Bosomworth et al. 2018, section 2.2.3).
KP = 2e3  # N/m
KD = 10e3  # N s/m

# Forces that the train hands to a vehicle; both use the same names.
FORCES = [
    "coupler.front.force",
    "coupler.rear.force",
    "resistance.force",
    "traction.force",
    "brake.force",
]

# What a wheel tells the rail; both use the same names.
WHEEL = [
    "creepage.longitudinal",
    "force.normal",
    "friction_power",
    "contact.a",
    "contact.b",
    "contact.flash_factor",
    "contact.lateral_position",
]


class Fmu:
    """An FMU file, unpacked once."""

    def __init__(self, path):
        self.folder = extract(str(path))
        self.description = read_model_description(str(path))
        self.references = {v.name: v.valueReference for v in self.description.modelVariables}

    def wheelsets(self):
        """Number of wheelsets of a vehicle."""
        return sum(name.startswith("wheelset[") and name.endswith("].position") for name in self.references)


class Instance:
    """An instance whose variables are set and read by name."""

    def __init__(self, fmu, name):
        self.fmu = fmu
        self.slave = FMU2Slave(
            guid=fmu.description.guid,
            unzipDirectory=fmu.folder,
            modelIdentifier=fmu.description.coSimulation.modelIdentifier,
            instanceName=name,
        )
        self.slave.instantiate()

    def parametrise(self, parameters):
        for name, value in parameters.items():
            reference = [self.fmu.references[name]]
            if isinstance(value, str):
                self.slave.setString(reference, [value])
            else:
                self.slave.setReal(reference, [value])

    def enter_initialization(self, stop_time):
        self.slave.setupExperiment(startTime=0.0, stopTime=stop_time)
        self.slave.enterInitializationMode()

    def exit_initialization(self):
        self.slave.exitInitializationMode()

    def step(self, time, length):
        self.slave.doStep(currentCommunicationPoint=time, communicationStepSize=length)

    def free(self):
        self.slave.terminate()
        self.slave.freeInstance()


class Port:
    """Real variables that are set or got together, with their values as an array; one call of
    the FMU for all of them."""

    def __init__(self, instance, names):
        self.slave = instance.slave
        references = [instance.fmu.references[name] for name in names]
        self.count = len(references)
        self.references = (c_uint * self.count)(*references)
        self.buffer = (c_double * self.count)()
        self.values = np.frombuffer(self.buffer)

    def set(self):
        self.slave.fmi2SetReal(self.slave.component, self.references, self.count, self.buffer)

    def get(self):
        self.slave.fmi2GetReal(self.slave.component, self.references, self.count, self.buffer)


class Train:
    """The train's instance; `outputs` has a row for each vehicle: position, velocity, forces."""

    def __init__(self, fmu, vehicles):
        self.instance = Instance(fmu, "train")
        names = ["position", "velocity", *FORCES]
        names = [f"vehicle[{i}].{name}" for i in range(1, vehicles + 1) for name in names]
        self.port = Port(self.instance, names)
        self.outputs = self.port.values.reshape(vehicles, -1)

    def initialize(self, velocity, stop_time):
        self.instance.parametrise({"initial.position": 0.0, "initial.velocity": velocity})
        self.instance.enter_initialization(stop_time)
        self.port.get()
        self.instance.exit_initialization()

    def step(self, time, length):
        self.instance.step(time, length)
        self.port.get()


class Vehicle:
    """A vehicle's instance with its controller.

    `outputs` begins with position and velocity; then each wheelset has its position and what its
    left wheel tells the rail; then come the further outputs that are wanted.
    """

    def __init__(self, fmu, name, wanted):
        self.instance = Instance(fmu, name)
        self.inputs = Port(self.instance, [*FORCES, "sync.force"])
        names = ["position", "velocity"]
        for j in range(1, fmu.wheelsets() + 1):
            names += [f"wheelset[{j}].position", *(f"wheelset[{j}].left.{name}" for name in WHEEL)]
        self.port = Port(self.instance, names + wanted)
        self.outputs = self.port.values
        self.wheelsets = self.outputs[2 : len(names)].reshape(-1, 1 + len(WHEEL))
        self.wanted = self.outputs[len(names) :]

    def initialize(self, in_train, stop_time):
        start = {"initial.position": in_train[0], "initial.velocity": in_train[1]}
        self.instance.parametrise(start)
        self.instance.enter_initialization(stop_time)
        self.inputs.values[:5] = in_train[2:]
        self.inputs.set()
        self.port.get()
        self.instance.exit_initialization()

    def synchronise(self, in_train):
        """Forms the synchronisation force from the errors at one instant."""
        error = self.outputs[0] - in_train[0]
        error_rate = self.outputs[1] - in_train[1]
        self.inputs.values[5] = -(KP * error + KD * error_rate)

    def step(self, in_train, time, length):
        self.inputs.values[:5] = in_train[2:]
        self.inputs.set()
        self.instance.step(time, length)
        self.port.get()


class Rail:
    """The rail's instance; `inputs` has a row for each wheelset of the train."""

    def __init__(self, fmu, vehicles, parameters, wanted):
        self.instance = Instance(fmu, "rail")
        self.instance.parametrise(parameters)
        names = ["position", "speed", *WHEEL]
        names = [
            f"vehicle[{i}].wheelset[{j}].{name}"
            for i, vehicle in enumerate(vehicles, 1)
            for j in range(1, len(vehicle.wheelsets) + 1)
            for name in names
        ]
        self.port = Port(self.instance, names)
        self.inputs = self.port.values.reshape(-1, 2 + len(WHEEL))
        self.outputs = Port(self.instance, wanted)

    def take(self, vehicles):
        """Takes what the wheels did; with one step of the rail for each of the exchange, there
        is nothing to be averaged."""
        at = 0
        for vehicle in vehicles:
            rows = self.inputs[at : at + len(vehicle.wheelsets)]
            rows[:, 0] = vehicle.wheelsets[:, 0]
            rows[:, 1] = vehicle.outputs[1]
            rows[:, 2:] = vehicle.wheelsets[:, 1:]
            at += len(vehicle.wheelsets)
        self.port.set()

    def initialize(self, vehicles, stop_time):
        self.instance.enter_initialization(stop_time)
        self.take(vehicles)
        self.instance.exit_initialization()

    def step(self, vehicles, time, length):
        self.take(vehicles)
        self.instance.step(time, length)


def run(folder, types, velocity, steps, length, every, vehicle_outputs=(), rail=None):
    """Runs the train whose vehicles have these types, with the FMUs in `folder`.

    Yields after every so many steps, and at the start: the time; the train's outputs, a row for
    each vehicle; position, velocity and the wanted outputs of each vehicle; the rail's wanted
    outputs. `rail` is None, or the rail's parameters and wanted outputs.
    """
    folder = Path(folder)
    fmus = {kind: Fmu(folder / f"{kind}.fmu") for kind in dict.fromkeys(types)}
    train = Train(Fmu(folder / "train.fmu"), len(types))
    wanted = list(vehicle_outputs)
    vehicles = [Vehicle(fmus[kind], f"vehicle[{i}]", wanted) for i, kind in enumerate(types, 1)]
    rail = Rail(Fmu(folder / "rail.fmu"), vehicles, *rail) if rail else None
    stop_time = steps * length

    def state(k):
        if rail:
            rail.outputs.get()
        of_vehicles = [np.concatenate([v.outputs[:2], v.wanted]) for v in vehicles]
        of_rail = rail.outputs.values.copy() if rail else None
        return k * length, train.outputs.copy(), np.array(of_vehicles), of_rail

    train.initialize(velocity, stop_time)
    for vehicle, in_train in zip(vehicles, train.outputs):
        vehicle.initialize(in_train, stop_time)
    if rail:
        rail.initialize(vehicles, stop_time)
    yield state(0)

    for k in range(steps):
        time = k * length
        for vehicle, in_train in zip(vehicles, train.outputs):
            vehicle.synchronise(in_train)
        train.step(time, length)
        for vehicle, in_train in zip(vehicles, train.outputs):
            vehicle.step(in_train, time, length)
        if rail:
            rail.step(vehicles, time, length)
        if (k + 1) % every == 0:
            yield state(k + 1)

    for unit in [train, *vehicles, *([rail] if rail else [])]:
        unit.instance.free()
