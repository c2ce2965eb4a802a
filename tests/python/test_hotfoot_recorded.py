"""A `hotfoot.System` with a folder of results: it leaves what `hotfoot run` leaves."""

import pytest
from conftest import RECORD, five_vehicles, hotfoot as command

import hotfoot

SHORT = 0.05
# A second train and a minute alone after the run of the first.
HEAT = "cool_down_minutes = 1.0\ntrains = { count = 2, headway_minutes = 0.5 }"
AFTER = [("field_interval_s = 0.5", f"field_interval_s = 0.5\n{HEAT}")]
NOTCH = "train.driver.notch"


@pytest.fixture(scope="module")
def scenario(tmp_path_factory):
    return five_vehicles(tmp_path_factory.mktemp("recorded"), AFTER, f"{RECORD}checkpoint_s = 10.0\n")


def files(results):
    """The files of tables and fields by their paths in the folder."""
    kept = [path for part in ("series", "rail.zarr") for path in (results.folder / part).rglob("*")]
    return {path.relative_to(results.folder): path.read_bytes() for path in kept if path.is_file()}


def test_stepped_to_the_end_it_leaves_the_results_of_the_run(scenario, tmp_path):
    run = hotfoot.run(scenario, results=tmp_path / "run", duration_s=SHORT)
    with hotfoot.System(scenario, results=tmp_path / "stepped", duration_s=SHORT) as system:
        while system.steps_left:
            system.step(25)
    stepped = hotfoot.open(tmp_path / "stepped")
    assert files(stepped) == files(run)
    assert stepped.end == "complete" and stepped.warnings == []
    assert stepped.table("rail")["time"].iloc[-1] == pytest.approx(90.05)
    figures = [results.figures.drop(index="wall_time").to_dict("index") for results in (run, stepped)]
    assert repr(figures[0]) == repr(figures[1])
    assert stepped.report.is_file()
    # A run notes a changed duration as a key of its scenario.
    assert {**stepped.scenario, "duration_s": SHORT} == run.scenario


def test_what_is_left_before_its_end_opens_and_says_what_python_did(scenario, tmp_path):
    system = hotfoot.System(
        scenario, results=tmp_path / "left", replace={"controller[2]": lambda *_: {"sync.force": 0.0}}
    )
    system.step(20)
    system[NOTCH] = 3.0
    system.step(20)
    with pytest.raises(ValueError, match="a system that records only goes forward"):
        system.restore(system.save())
    results = system.finish()
    assert results.end == "interrupted"
    assert results.simulated_s == pytest.approx(0.04)
    assert results.table("train")["time"].iloc[-1] == pytest.approx(0.04)
    assert results.table("rail")["time"].iloc[-1] == pytest.approx(0.04), "no rail goes on"
    assert results.warnings == [
        "controller[2] was a model of the program that stepped the system",
        f"the program that stepped the system has set {NOTCH} (from 0.02 s)",
        "the program that stepped it left it at 0.04 s",
    ]
    assert system["vehicle[1].velocity"] > 16.0, "its last values can still be read"
    for request in (system.step, system.save, system.finish, lambda: system.set(NOTCH, 1.0)):
        with pytest.raises(ValueError, match="the system has ended, and its results are in .*left; open it anew"):
            request()


def test_what_failed_is_completed_and_told_as_on_the_command_line(scenario, tmp_path):
    def fails(time, step, inputs):
        if time > 0.025:
            raise ZeroDivisionError("the speed is zero")

    sentence = r"at 0\.026\d* s: controller\[2\]: .*the speed is zero.*; the results until then are in"
    with pytest.raises(hotfoot.RunError, match=sentence) as raised:
        with hotfoot.System(scenario, results=tmp_path, replace={"controller[2]": fails}) as system:
            system.step(100)
    assert isinstance(raised.value.__cause__, ZeroDivisionError)
    results = hotfoot.open(tmp_path)
    assert results.end == "failed"
    assert results.table("train")["time"].iloc[-1] == pytest.approx(0.02)


def test_a_package_is_recorded_at_the_interval_that_is_asked_for(tmp_path):
    fmu = hotfoot.fmus() / "synchronisation.fmu"
    with hotfoot.System(fmu, results=tmp_path, duration_s=0.1, interval_s=0.05) as system:
        system.step(100)
    results = hotfoot.open(tmp_path)
    (name,) = results.tables
    assert results.table(name)["time"].tolist() == pytest.approx([0.0, 0.05, 0.1])


def test_folders_that_have_results_and_starts_that_fail_leave_all_as_it_was(scenario, tmp_path):
    hotfoot.System(scenario, results=tmp_path, duration_s=SHORT).finish()
    with pytest.raises(hotfoot.RunError, match="has the results of a run already.*--overwrite"):
        hotfoot.System(scenario, results=tmp_path)
    assert hotfoot.open(tmp_path).end == "interrupted"
    with hotfoot.System(scenario, results=tmp_path, overwrite=True, duration_s=SHORT) as system:
        system.step(50)
    assert hotfoot.open(tmp_path).end == "complete"
    with pytest.raises(hotfoot.RunError, match="duration_s"):
        hotfoot.System(scenario, results=tmp_path / "none", settings={"duration_s": -1.0})
    assert not (tmp_path / "none").exists()


def test_a_system_without_results_has_none_to_finish(scenario):
    with hotfoot.System(scenario, duration_s=SHORT) as system:
        with pytest.raises(ValueError, match="the system records nothing; open it with a folder of results"):
            system.finish()


def test_a_scenario_with_checkpoints_and_further_trains_is_checked_without_their_folder(scenario):
    assert "can be run" in command("check", scenario)
