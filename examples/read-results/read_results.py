"""Reads the results of a run: greatest coupler forces, the rail's highest rise, and the figures."""

import sys
import tomllib
from pathlib import Path

import numpy
import pandas
import pyarrow.parquet
import zarr


def coupler_forces(results):
    """Greatest tension and buff behind each vehicle, N: the extremes between records count too."""
    vehicles = pandas.read_parquet(results / "series" / "vehicles.parquet")
    behind = vehicles.groupby("vehicle")
    return pandas.DataFrame(
        {
            "tension": behind["coupler_rear_force_max"].max().clip(lower=0.0),
            "buff": behind["coupler_rear_force_min"].min().clip(upper=0.0).abs(),
        }
    )


def unit_of(results, column):
    """The unit that a column carries in its metadata."""
    schema = pyarrow.parquet.read_schema(results / "series" / "vehicles.parquet")
    return schema.field(column).metadata[b"unit"].decode()


def highest_rise(results):
    """The highest temperature rise in the field, K, with its time, s, chainage and depth, m."""
    store = zarr.open_group(results / "rail.zarr", mode="r")
    axes = ("time", "chainage", "depth")
    (name,) = set(store.array_keys()) - set(axes)
    field = store[name][:]
    at = numpy.unravel_index(numpy.argmax(field), field.shape)
    return float(field[at]), *(float(store[axis][index]) for axis, index in zip(axes, at))


def figures(results):
    """Key, value and unit of every figure of the run's report."""
    manifest = tomllib.loads((results / "manifest.toml").read_text())
    return [(f["key"], f.get("value"), f.get("unit", "")) for f in manifest.get("figure", [])]


def main():
    results = Path(sys.argv[1])
    print(f"coupler forces, {unit_of(results, 'coupler_rear_force')}")
    print(coupler_forces(results).round(0).to_string())
    rise, time, chainage, depth = highest_rise(results)
    print(f"highest rise {rise:.3f} K at {time} s, chainage {chainage} m, {1e3 * depth:.0f} mm deep")
    for key, value, unit in figures(results):
        print(f"{key} = {value} {unit}")


if __name__ == "__main__":
    main()
