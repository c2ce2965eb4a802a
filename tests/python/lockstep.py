"""Hotfoot's step loop with FMPy: a template for masters of your own.

The FMUs of a run lie in its results folder: `train.fmu` for the whole train, one FMU for each
type of vehicle. This is the sequential scheme of docs/user-guide: the train steps first, then
each vehicle with the train's new forces and a synchronisation force from the errors before.
"""

from pathlib import Path

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


class Fmu:
    """An FMU file, unpacked once."""

    def __init__(self, path):
        self.folder = extract(str(path))
        self.description = read_model_description(str(path))
        self.references = {v.name: v.valueReference for v in self.description.modelVariables}

    def instantiate(self, name):
        return Instance(self, name)


class Instance:
    """An instance that is set and read by variable names."""

    def __init__(self, fmu, name):
        self.fmu = fmu
        self.slave = FMU2Slave(
            guid=fmu.description.guid,
            unzipDirectory=fmu.folder,
            modelIdentifier=fmu.description.coSimulation.modelIdentifier,
            instanceName=name,
        )
        self.slave.instantiate()

    def set(self, values):
        references = [self.fmu.references[name] for name in values]
        self.slave.setReal(references, list(values.values()))

    def get(self, names):
        references = [self.fmu.references[name] for name in names]
        return dict(zip(names, self.slave.getReal(references)))

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


def train_names(vehicle):
    """The train's outputs for a vehicle, counted from one."""
    return [f"vehicle[{vehicle}].{name}" for name in ["position", "velocity", *FORCES]]


def run(folder, types, velocity, steps, length, outputs, every):
    """Runs the train whose vehicles have these types; yields the wanted outputs of each vehicle
    and the train's at the start and after every so many steps, as (time, vehicles, train)."""
    folder = Path(folder)
    fmus = {kind: Fmu(folder / f"{kind}.fmu") for kind in dict.fromkeys(types)}
    train = Fmu(folder / "train.fmu").instantiate("train")
    vehicles = [fmus[kind].instantiate(f"vehicle[{i}]") for i, kind in enumerate(types, 1)]
    names = [name for i in range(1, len(types) + 1) for name in train_names(i)]
    wanted = list(dict.fromkeys(["position", "velocity", *outputs]))
    stop = steps * length

    def forces(i, of_train):
        return {name: of_train[f"vehicle[{i}].{name}"] for name in FORCES}

    train.set({"initial.position": 0.0, "initial.velocity": velocity})
    train.enter_initialization(stop)
    of_train = train.get(names)
    train.exit_initialization()
    of_vehicles = []
    for i, vehicle in enumerate(vehicles, 1):
        vehicle.set(
            {
                "initial.position": of_train[f"vehicle[{i}].position"],
                "initial.velocity": of_train[f"vehicle[{i}].velocity"],
            }
        )
        vehicle.enter_initialization(stop)
        vehicle.set({**forces(i, of_train), "sync.force": 0.0})
        of_vehicles.append(vehicle.get(wanted))
        vehicle.exit_initialization()
    yield 0.0, list(of_vehicles), of_train

    for k in range(steps):
        time = k * length
        sync = []
        for i, of_vehicle in enumerate(of_vehicles, 1):
            error = of_vehicle["position"] - of_train[f"vehicle[{i}].position"]
            error_rate = of_vehicle["velocity"] - of_train[f"vehicle[{i}].velocity"]
            sync.append(-(KP * error + KD * error_rate))
        train.step(time, length)
        of_train = train.get(names)
        for i, vehicle in enumerate(vehicles, 1):
            vehicle.set({**forces(i, of_train), "sync.force": sync[i - 1]})
            vehicle.step(time, length)
            of_vehicles[i - 1] = vehicle.get(wanted)
        if (k + 1) % every == 0:
            yield (k + 1) * length, list(of_vehicles), of_train

    for instance in [train, *vehicles]:
        instance.free()
