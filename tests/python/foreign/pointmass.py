"""A vehicle of another maker: a point mass without wheels, exported by PythonFMU."""

from pythonfmu import Fmi2Causality, Fmi2Initial, Fmi2Slave, Fmi2Variability, Real

MASS = 134e3  # kg


class PointMass(Fmi2Slave):
    """Newton's law with all forces of a step constant; names are its own, units SI."""

    author = "Another maker"
    description = "Point mass on a track"

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.start_position = 0.0
        self.start_velocity = 0.0
        self.front = 0.0
        self.rear = 0.0
        self.control = 0.0
        self.drag = 0.0
        self.position = 0.0
        self.velocity = 0.0
        parameter = {"causality": Fmi2Causality.parameter, "variability": Fmi2Variability.fixed}
        for name in ("start_position", "start_velocity"):
            self.register_variable(Real(name, **parameter))
        for name in ("front", "rear", "control", "drag"):
            self.register_variable(Real(name, causality=Fmi2Causality.input))
        for name in ("position", "velocity"):
            self.register_variable(
                Real(name, causality=Fmi2Causality.output, initial=Fmi2Initial.calculated)
            )

    def exit_initialization_mode(self):
        self.position = self.start_position
        self.velocity = self.start_velocity

    def do_step(self, current_time, step_size):
        force = self.front - self.rear + self.control + self.drag
        before = self.velocity
        self.velocity += force / MASS * step_size
        self.position += (before + self.velocity) / 2 * step_size
        return True
