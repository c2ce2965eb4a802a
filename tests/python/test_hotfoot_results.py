"""`hotfoot.open` and `hotfoot.run`: results of runs of every kind, and errors in the program's sentences."""

import signal
import subprocess
import time
import warnings

import numpy
import pandas
import pytest
import xarray
from conftest import HOTFOOT, ROOT, five_vehicles, hotfoot as command

import hotfoot

SHORT = {"duration_s": 0.05}


@pytest.fixture(autouse=True)
def no_warnings():
    """Whoever opens results is warned of nothing."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield


def test_tables_have_units_and_descriptions(run):
    results = hotfoot.open(run)
    assert results.tables == ["rail", "train", "vehicles", "wheels"]
    vehicles = results.table("vehicles")
    assert vehicles.attrs["units"]["coupler_rear_force"] == "N"
    assert vehicles.attrs["descriptions"]["velocity"] == "Speed in the vehicle model"
    plain = pandas.read_parquet(run / "series" / "vehicles.parquet")
    pandas.testing.assert_frame_equal(vehicles, plain)
    assert list(results.table("vehicles", ["time", "velocity"])) == ["time", "velocity"]


def test_the_field_figures_and_scenario_are_those_of_the_run(run):
    results = hotfoot.open(run)
    field = results.field()
    assert field["temperature_rise"].dims == ("time", "chainage", "depth")
    assert field["temperature_rise"].attrs["units"] == "K"
    assert field["time"].values.tolist() == [0.0, 0.5, 1.0, 1.5, 2.0]
    assert results.end == "complete" and results.simulated_s == 2.0
    assert results.scenario["train"]["speed_m_per_s"] == 16.67
    greatest = results.table("vehicles")["coupler_rear_force_max"].max()
    assert results.figure("coupler.tension") == greatest
    assert results.figures.loc["coupler.tension", "unit"] == "N"
    assert results.report.is_file()


def test_xarray_opens_the_field_by_itself_without_a_warning(run):
    field = xarray.open_zarr(run / "rail.zarr")
    pandas.testing.assert_index_equal(field.indexes["time"], hotfoot.open(run).field().indexes["time"])


def test_what_is_not_there_is_told_with_what_is(run, tmp_path):
    results = hotfoot.open(run)
    with pytest.raises(KeyError, match="no table 'vehicle'; there are rail, train, vehicles, wheels"):
        results.table("vehicle")
    with pytest.raises(KeyError, match="no column 'speed'; it has time, vehicle"):
        results.table("vehicles", ["speed"])
    with pytest.raises(KeyError, match="no field 'rail-left': there are rail"):
        results.field("rail-left")
    with pytest.raises(KeyError, match="there is no figure 'foot'"):
        results.figure("foot")
    with pytest.raises(FileNotFoundError, match="holds no results of `hotfoot run`"):
        hotfoot.open(tmp_path)


def test_a_run_is_made_with_changes_by_keys_and_by_tables(tmp_path):
    scenario = five_vehicles(tmp_path)
    results = hotfoot.run(
        scenario,
        results=tmp_path / "fast",
        settings={"heat.field_interval_s": 0.02},
        train={"speed_m_per_s": 20.0},
        threads=1,
        **SHORT,
    )
    assert results.folder == tmp_path / "fast"
    assert results.scenario["train"]["speed_m_per_s"] == 20.0
    assert results.table("train")["train.velocity"].iloc[0] == 20.0
    assert results.field()["time"].values.tolist() == [0.0, 0.02, 0.04]


def test_a_run_without_a_folder_gets_a_new_one(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    results = hotfoot.run(five_vehicles(tmp_path), **SHORT)
    assert results.folder.resolve() == (tmp_path / "results" / tmp_path.name).resolve()


def test_errors_are_exceptions_with_the_sentences_of_the_command_line(tmp_path):
    scenario = five_vehicles(tmp_path)
    said = subprocess.run(
        [HOTFOOT, "run", scenario, "--set", "duration_s=-1.0"], capture_output=True, text=True
    )
    with pytest.raises(hotfoot.RunError) as raised:
        hotfoot.run(scenario, duration_s=-1.0)
    assert f"Error: {raised.value}\n" == said.stderr
    assert "duration_s" in str(raised.value)
    with pytest.raises(TypeError, match="no value that a scenario can have"):
        hotfoot.run(scenario, title=object())


def test_results_of_an_interrupted_run_open(tmp_path):
    scenario = five_vehicles(tmp_path, [("duration_s = 2.0", "duration_s = 100.0")])
    results = tmp_path / "results"
    run = subprocess.Popen([HOTFOOT, "run", scenario, "--quiet", "--results", results])
    while not list(results.glob("series/vehicles.parts/part-*")):
        assert run.poll() is None
        time.sleep(0.02)
    with pytest.raises(FileNotFoundError, match="the run goes on, or it was killed"):
        hotfoot.open(results)
    # The field of a run that goes on can be opened at any time.
    xarray.open_zarr(results / "rail.zarr")["temperature_rise"].load()
    run.send_signal(signal.SIGINT)
    run.wait()
    opened = hotfoot.open(results)
    assert opened.end == "interrupted"
    assert opened.table("train")["time"].iloc[-1] == pytest.approx(opened.simulated_s, abs=0.011)
    assert numpy.isfinite(opened.field()["temperature_rise"].values).all()


def test_results_of_a_package_open(tmp_path):
    package = tmp_path / "train.ssp"
    command("export-ssp", five_vehicles(tmp_path, [("count = 4", "count = 1")], ""), "--output", package)
    results = hotfoot.run(package, results=tmp_path / "results", options=["--duration", "0.05"])
    assert results.scenario is None
    assert "vehicle_2" in results.tables
    assert results.table("train").attrs["units"]["vehicle[1].velocity"] == "m/s"
    assert results.simulated_s == pytest.approx(0.05)


def test_results_of_a_train_alone_open(tmp_path):
    alone = ROOT / "scenarios" / "train-alone"
    results = hotfoot.run(alone, results=tmp_path / "results", duration_s=2.0)
    assert results.fields == []
    assert set(results.tables) == {"train", "vehicles"}
    assert results.table("vehicles")["vehicle"].max() == 130
    with pytest.raises(KeyError, match="the run has written none"):
        results.field()
