"""The results folder as other tools read it."""

import pyarrow.parquet as parquet
import zarr


def test_series_have_units_and_the_instants_asked_for(run):
    table = parquet.read_table(run / "series" / "vehicles.parquet")
    assert table.num_rows == 5 * 201
    assert table.schema.field("coupler_rear_force").metadata[b"unit"] == b"N"
    assert table.column("time")[-1].as_py() == 2.0


def test_the_field_opens_in_zarr(run):
    store = zarr.open_group(run / "rail.zarr", mode="r")
    names = set(store.array_keys())
    assert {"time", "chainage", "depth"} <= names
    (field,) = names - {"time", "chainage", "depth"}
    array = store[field]
    assert array.dtype == "float32"
    assert array.shape == tuple(store[name].shape[0] for name in ("time", "chainage", "depth"))
    assert array[-1].max() > 0.0


def test_the_report_needs_nothing_from_outside(run):
    page = (run / "report.html").read_text()
    assert 'src="http' not in page and 'href="http' not in page
