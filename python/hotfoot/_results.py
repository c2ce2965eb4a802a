"""The results of a run: tables, fields, figures and what made them."""

from __future__ import annotations

import json
import os
import tomllib
from functools import cached_property
from pathlib import Path
from typing import Any

import pandas
import pyarrow.parquet
import xarray


def open(folder: str | os.PathLike[str]) -> Results:
    """Opens the results in a folder that `hotfoot run` has written.

    The run may have come to its end, have been interrupted, or be that of an SSP package or of a
    train alone.

    Raises
    ------
    FileNotFoundError
        When there are no results, or they are those of a run that was killed and must be completed.
    """
    return Results(Path(folder))


class Results:
    """What a run has left in its folder; each part is read when it is asked for."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        """The folder."""
        manifest = folder / "manifest.toml"
        if not manifest.is_file():
            raise FileNotFoundError(
                f"{folder} holds no results of `hotfoot run`: it has no manifest.toml"
            )
        parts = sorted(file.stem for file in (folder / "series").glob("*.parts"))
        if parts:
            raise FileNotFoundError(
                f"{folder}: the run goes on, or it was killed before its tables {', '.join(parts)} were"
                f" completed; `hotfoot report {folder}` completes them"
            )
        with manifest.open("rb") as file:
            self.manifest: dict[str, Any] = tomllib.load(file)
            """All that manifest.toml says: versions, FMUs with digests, wall times, warnings."""

    def __repr__(self) -> str:
        return f"<hotfoot.Results {str(self.folder)!r}: {self.end}, {round(self.simulated_s, 9)} s>"

    @property
    def end(self) -> str:
        """How the run has ended: `complete`, `interrupted` or `failed`."""
        return self.manifest.get("end", "unknown")

    @property
    def simulated_s(self) -> float:
        """Simulated time, s."""
        return float(self.manifest.get("simulated_s", 0.0))

    @property
    def warnings(self) -> list[str]:
        """What the run of a train has warned of, in sentences, the reason of an early end among them."""
        return list(self.manifest.get("run", {}).get("warnings", []))

    @property
    def scenario(self) -> dict[str, Any] | None:
        """The scenario with all changes that the run was ordered with; none of an SSP package."""
        text = self.manifest.get("scenario")
        return None if text is None else tomllib.loads(text)

    @property
    def report(self) -> Path:
        """The page of the run, report.html."""
        return self.folder / "report.html"

    @property
    def tables(self) -> list[str]:
        """Names of the tables: `train`, `vehicles`, `wheels`, `rail`, or those of a package's components."""
        return sorted(file.stem for file in (self.folder / "series").glob("*.parquet"))

    def table(self, name: str, columns: list[str] | None = None) -> pandas.DataFrame:
        """A table: a row for each record, and for each vehicle, wheel or rail in it.

        Its `attrs` hold, by column, `units` (SI, `"1"` for pure numbers) and `descriptions`.

        Parameters
        ----------
        name
            One of `tables`.
        columns
            Columns that are read; left out: all.

        Raises
        ------
        KeyError
            When there is no such table or column.
        """
        if name not in self.tables:
            raise KeyError(f"there is no table {name!r}; there are {', '.join(self.tables)}")
        file = self.folder / "series" / f"{name}.parquet"
        schema = pyarrow.parquet.read_schema(file)
        for column in columns or []:
            if column not in schema.names:
                raise KeyError(f"the table {name!r} has no column {column!r}; it has {', '.join(schema.names)}")
        frame = pyarrow.parquet.read_table(file, columns=columns).to_pandas()
        for key, attribute in (("unit", "units"), ("description", "descriptions")):
            frame.attrs[attribute] = {
                column: (schema.field(column).metadata or {}).get(key.encode(), b"").decode()
                for column in frame.columns
            }
        return frame

    @property
    def fields(self) -> list[str]:
        """Names of the temperature fields: `rail`, or `rail-left` and `rail-right`."""
        return sorted(store.stem for store in self.folder.glob("*.zarr"))

    def field(self, name: str | None = None) -> xarray.Dataset:
        """The temperature rise of a rail, which is read where it is used.

        Variable `temperature_rise` in K above the initial state, of shape (time, chainage, depth);
        coordinates in s, m along the track, and m below the running surface.

        Parameters
        ----------
        name
            One of `fields`; left out: the only one.

        Raises
        ------
        KeyError
            When there is no such field, or no name tells which of two.
        """
        names = self.fields
        if name is None and len(names) == 1:
            (name,) = names
        if name not in names:
            there = f"there are {', '.join(names)}" if names else "the run has written none"
            raise KeyError(f"name the field: {there}" if name is None else f"no field {name!r}: {there}")
        store = self.folder / f"{name}.zarr"
        # Those of older runs have no copy of the arrays' metadata, of which xarray would warn.
        consolidated = "consolidated_metadata" in json.loads((store / "zarr.json").read_text())
        return xarray.open_zarr(store, consolidated=consolidated, decode_timedelta=False, chunks=None)

    @cached_property
    def figures(self) -> pandas.DataFrame:
        """The figures of the report: by key, `name`, `value`, `unit`, `text`, `place` and `time_s`."""
        columns = ["key", "name", "value", "unit", "text", "place", "time_s"]
        figures = pandas.DataFrame(self.manifest.get("figure", []), columns=columns)
        return figures.set_index("key")

    def figure(self, key: str) -> float:
        """The value of a figure in its unit; NaN where the run gives none.

        Raises
        ------
        KeyError
            When there is no such figure.
        """
        if key not in self.figures.index:
            raise KeyError(f"there is no figure {key!r}; there are {', '.join(self.figures.index)}")
        return float(self.figures.loc[key, "value"])
