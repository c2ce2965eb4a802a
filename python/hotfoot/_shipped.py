"""Where the program, its FMUs, the rolling stock and the scenarios lie: in this package."""

from __future__ import annotations

from pathlib import Path

HOME = Path(__file__).resolve().parent


class RunError(RuntimeError):
    """Why a run or a system failed, in the sentences that the command line tells."""


def program() -> Path:
    """The program `hotfoot`.

    Raises
    ------
    FileNotFoundError
        When this package lies here without its program, as in the sources.
    """
    return _there(HOME / "bin" / "hotfoot")


def fmus() -> Path:
    """The folder of Hotfoot's own FMUs."""
    return _there(HOME / "fmus")


def stock() -> Path:
    """The library of rolling stock: folders `vehicles`, `draft_gears` and `rails`."""
    return _there(HOME / "stock")


def scenarios() -> Path:
    """The folder of the shipped scenarios, one folder each."""
    return _there(HOME / "scenarios")


def _there(path: Path) -> Path:
    if not path.exists():
        raise FileNotFoundError(
            f"{path} is not there: this package is only whole in the wheel, which `cargo xtask wheel` makes"
        )
    return path
