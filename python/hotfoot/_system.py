"""A system that Python steps: the units and links of a run, which leaves its results if a folder is named."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol, overload

import numpy
import pandas

from hotfoot._results import Results
from hotfoot._results import open as open_results
from hotfoot._run import as_settings
from hotfoot._shipped import HOME, RunError

if TYPE_CHECKING:
    from types import TracebackType

    from numpy.typing import ArrayLike, NDArray

Values = Mapping[str, float]
"""Values of variables by their names, each in the unit of its variable."""


class Model(Protocol):
    """A model in Python that stands for a component, such as a vehicle.

    Its attributes (``vars(model)``) are its state, which `System.save` pickles.
    """

    def step(self, time: float, step: float, inputs: dict[str, float]) -> dict[str, float] | None:
        """Steps from `time` over `step`, both in s, and gives the outputs that have changed.

        `inputs` are all inputs of the component that the model stands for.
        """


Function = Callable[[float, float, dict[str, float]], "dict[str, float] | None"]
"""What stands for a component and has no state: a function as `Model.step`."""


class System:
    """A scenario, an SSP package or an FMU, initialised, and stepped as `hotfoot run` does.

    It gives the bits of the run. With a folder of `results` it records there what the run records,
    and `finish` takes the rails through what follows the train and completes tables, fields, manifest
    and report. Without one it records nothing, and can go back to a state that was saved.

    Parameters
    ----------
    scenario
        Folder or file of a scenario, name of a shipped one, an ``.ssp`` or an ``.fmu``.
    replace
        Components that Python models stand for, by their names: a function
        ``f(time, step, inputs) -> outputs``, or a `Model`. A model may have a method
        ``start(time, parameters) -> outputs`` too, which is called before the first step. The
        variables are those of the component that is replaced; outputs that are not answered keep
        their values.
    results
        Folder of the results; left out: nothing is recorded. What Python does instead of the scenario,
        by models or by inputs, stands in the manifest as warnings.
    overwrite
        Whether the results of an earlier run in that folder are replaced.
    duration_s, step_s, interval_s
        Simulated time, step of the exchange, and time between two records in place of the scenario's, s.
    threads
        Threads for the vehicles; left out: all cores.
    settings, **changes
        Values of keys of the scenario, as `hotfoot.run` takes them.

    Raises
    ------
    RunError
        When its run would not begin, or the folder has results, in the sentences of the command line.
    ValueError
        When `replace` names a component that is not there.

    Examples
    --------
    >>> system = hotfoot.System("first-look")                        # doctest: +SKIP
    >>> system.step(1000)                                            # doctest: +SKIP
    >>> system["vehicle[3].velocity"]                                # doctest: +SKIP

    With results, which are completed at the end of the block, whatever ends it:

    >>> with hotfoot.System("first-look", results="mine") as system:  # doctest: +SKIP
    ...     while system.steps_left:
    ...         system["train.driver.notch"] = 2 if system["train.train.velocity"] < 17 else 0
    ...         system.step(10)
    >>> hotfoot.open("mine").figure("coupler.tension")               # doctest: +SKIP
    """

    def __init__(
        self,
        scenario: str | os.PathLike[str],
        *,
        replace: Mapping[str, Model | Function] | None = None,
        results: str | os.PathLike[str] | None = None,
        overwrite: bool = False,
        duration_s: float | None = None,
        step_s: float | None = None,
        interval_s: float | None = None,
        threads: int | None = None,
        settings: Mapping[str, Any] | None = None,
        **changes: Any,
    ) -> None:
        from hotfoot._native import NativeSystem

        self._native = NativeSystem(
            (os.fspath(scenario), os.fspath(HOME)),
            as_settings({**(settings or {}), **changes}),
            (duration_s, step_s, interval_s),
            threads,
            list((replace or {}).items()),
            None if results is None else (os.fspath(results), overwrite),
        )
        self._results = None if results is None else Path(results)

    def __enter__(self) -> System:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        exception: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        if self._native.records():
            self.finish()

    def __repr__(self) -> str:
        time, length, done, steps = self._native.clock()
        return f"<hotfoot.System at {round(time, 9)} s, {done} of {steps} steps of {length} s>"

    @property
    def time(self) -> float:
        """Time to which the system has come, s."""
        return self._native.clock()[0]

    @property
    def step_s(self) -> float:
        """Length of a step of the exchange, s."""
        return self._native.clock()[1]

    @property
    def steps_left(self) -> int:
        """Steps to the end of the scenario."""
        _, _, done, steps = self._native.clock()
        return steps - done

    def step(self, steps: int = 1) -> None:
        """Takes all components through so many steps.

        Raises
        ------
        RunError
            When a component fails; what a Python model has raised is its `__cause__`.
        ValueError
            When the scenario ends before.
        """
        if steps < 0:
            raise ValueError(f"a system takes no {steps} steps: the number must not be negative")
        self._native.step(steps)

    def finish(self) -> Results:
        """Ends the system and gives its results, as `hotfoot.open` does.

        After the last step of the scenario the rails go through what follows the train: further trains,
        and the time alone. A system that is left before has the results of an interrupted run.

        Raises
        ------
        RunError
            When a rail fails, or a file cannot be written.
        ValueError
            When the system records nothing, or has ended already.
        KeyboardInterrupt
            When it is interrupted; what was recorded until then can be opened.
        """
        self._native.finish()
        assert self._results is not None
        return open_results(self._results)

    @overload
    def get(self, names: str) -> float: ...
    @overload
    def get(self, names: Sequence[str]) -> NDArray[numpy.float64]: ...
    def get(self, names: str | Sequence[str]) -> float | NDArray[numpy.float64]:
        """Values of variables, named ``component.variable``, such as ``"vehicle[3].velocity"``.

        Each is in the unit of its variable (`variables` tells it), outputs as they are after the last
        step. A name gives a float, n names an array of shape (n,).

        Raises
        ------
        ValueError
            When there is no such variable, or it is a String.
        """
        if isinstance(names, str):
            return self._native.get([names])[0]
        return numpy.array(self._native.get(list(names)), dtype=float)

    def set(self, names: str | Sequence[str] | Values, values: ArrayLike | None = None) -> None:
        """Sets inputs that nothing is connected to, until they are set again.

        ``set("train.driver.notch", 8)``, ``set(names, values)`` with n names and n values, or
        ``set({name: value})``; each value is in the unit of its variable.

        Raises
        ------
        ValueError
            When there is no such input, it is connected, a value is not finite or not in its range,
            or there is not a value for each name.
        """
        if isinstance(names, Mapping):
            names, values = list(names), list(names.values())
        elif isinstance(names, str):
            names = [names]
        numbers = numpy.atleast_1d(numpy.asarray(values, dtype=float))
        if numbers.ndim != 1:
            raise ValueError(f"values have the shape {numbers.shape}; there must be a value for each name")
        self._native.set(list(names), numbers.tolist())

    def __getitem__(self, name: str) -> float:
        return self.get(name)

    def __setitem__(self, name: str, value: float) -> None:
        self.set(name, value)

    def save(self) -> bytes:
        """All that this system, or another one of the same scenario, needs to go on from here.

        Raises
        ------
        ValueError
            When an FMU cannot save its state.
        """
        return self._native.save()

    def restore(self, state: bytes) -> None:
        """Goes on, bit for bit, from where a system of the same scenario was saved.

        Python models are unpickled: restore only what you trust.

        Raises
        ------
        ValueError
            When it is no state of such a system.
        """
        self._native.restore(state)

    @property
    def components(self) -> dict[str, str]:
        """The components by name, with the files that they come from."""
        return dict(self._native.components())

    def variables(self, component: str) -> pandas.DataFrame:
        """The variables of a component: by name `causality`, `type`, `unit`, `start`, `description`.

        Raises
        ------
        ValueError
            When there is no such component.
        """
        columns = ["name", "causality", "type", "unit", "start", "description"]
        rows = self._native.variables(component)
        return pandas.DataFrame(rows, columns=columns).set_index("name")

    def take_warnings(self) -> list[str]:
        """What components have warned of since this was asked last, in sentences."""
        return self._native.take_warnings()


__all__ = ["Function", "Model", "RunError", "System", "Values"]
