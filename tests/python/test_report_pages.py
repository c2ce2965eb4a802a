"""Every kind of page that the runs of this repository make, in a real browser."""

import re
import signal
import subprocess
import time
import warnings

import numpy
import pytest
import tomllib
import xarray
import zarr
from conftest import HOTFOOT, ROOT, five_vehicles, hotfoot
from report_page import (
    browser,
    changed,
    close,
    drawings,
    needs_browser,
    number,
    opened_page,
    readout,
    row_of,
    set_slider,
    table,
)

pytestmark = needs_browser

HEAT = '[heat]\nmodel = "paper"\nbegin_m = -120.0\nlength_m = 600.0\nfield_interval_s = 0.5\n'

# Chainages where the train is in its first second, on a rail that all of it stays on.
ENERGY = """[heat]
model = "energy"
rail = "both"
step_s = 0.02
begin_m = -120.0
length_m = 200.0
field_interval_s = 0.25
probe = [{ chainage_m = 8.0 }, { chainage_m = -4.0 }]
[heat.parameters]
"section.cell_size" = 0.006
"""

LIMITS = """
[[speed_limit]]
from_m = -1000.0
to_m = 5.0
speed_m_per_s = 15.0
[[speed_limit]]
from_m = 5.0
to_m = 1000.0
speed_m_per_s = 30.0
"""

REPLAY = """[replay]
file = "logger.csv"
time = "time_s"
speed = "speed_kmh"
"""


def of_scenario(name):
    """A run of a scenario of the repository, cut short."""
    def run(folder):
        scenario = ROOT / "scenarios" / name
        hotfoot("run", scenario, "--quiet", "--duration", 1, "--results", folder / "results")
        return folder / "results"
    return run


def energy(folder):
    """Both rails by the model that conserves heat, with sections at two probes; a track with limits."""
    scenario = five_vehicles(folder, [(HEAT, ENERGY), ("duration_s = 2.0", "duration_s = 1.0")], "")
    track = folder / "track.toml"
    track.write_text(track.read_text() + LIMITS)
    hotfoot("run", scenario, "--quiet", "--results", folder / "results")
    return folder / "results"


def replay(folder):
    """A train that is driven by a logger's file, without rails."""
    scenario = five_vehicles(folder, [(HEAT, ""), ("duration_s = 2.0", "duration_s = 1.0")], "")
    (folder / "driver.toml").write_text(REPLAY)
    (folder / "logger.csv").write_text("time_s,speed_kmh\n0,60\n1,61\n2,62\n")
    text = scenario.read_text()
    with_file = 'file = "driver.toml"\nwith = ["logger.csv"]'
    scenario.write_text(text.replace('file = "driver.toml"', with_file))
    hotfoot("run", scenario, "--quiet", "--results", folder / "results")
    return folder / "results"


def interrupted(folder):
    """A run that is stopped by the user."""
    scenario = five_vehicles(folder, [("duration_s = 2.0", "duration_s = 600.0")], "")
    results = folder / "results"
    run = subprocess.Popen([HOTFOOT, "run", scenario, "--quiet", "--results", results])
    while not (results / "series" / "vehicles.parts").exists():
        assert run.poll() is None
        time.sleep(0.01)
    time.sleep(1.0)
    run.send_signal(signal.SIGINT)
    run.wait()
    hotfoot("report", results)
    return results


def package(folder):
    """A train as an SSP package."""
    changes = [(HEAT, ""), ("step_s = 0.001", 'step_s = 0.001\nscheme = "jacobi"')]
    scenario = five_vehicles(folder, changes, "")
    hotfoot("export-ssp", scenario, "--output", folder / "train.ssp")
    arguments = ["--duration", 0.5, "--interval", 0.01, "--quiet", "--results", folder / "results"]
    hotfoot("run", folder / "train.ssp", *arguments)
    return folder / "results"


# A run of each kind, and whether it has vehicles in three dimensions.
TRAINS = {
    "train-alone": (of_scenario("train-alone"), False),
    "acceptance": (of_scenario("acceptance-curve-0mm"), True),
    "without-heat": (of_scenario("wet-rail"), True),
    "energy": (energy, True),
    "replay": (replay, True),
    "interrupted": (interrupted, True),
}


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    """The folder of a kind's run, which is run once."""
    known = {}

    def of(kind):
        if kind not in known:
            run = package if kind == "package" else TRAINS[kind][0]
            known[kind] = run(tmp_path_factory.mktemp(kind))
        return known[kind]

    return of


@pytest.mark.parametrize("kind", TRAINS)
def test_slider_choices_and_numbers(browser, results, kind):
    folder = results(kind)
    vehicles = table(folder, "vehicles")
    with opened_page(browser, folder) as page:
        page.wait_for_selector("#along-track canvas")
        before = drawings(page)
        set_slider(page, 0.4)
        assert any(title.startswith("Track") for title in changed(before, drawings(page)))
        shown = readout(page)
        at = number(shown["Time of the train"], "s")
        rows = row_of(vehicles, time=at, vehicle=1)
        assert rows.sum() == 1, at
        speed = vehicles["velocity"][rows][0]
        assert shown["Leading vehicle"] == f"{speed:.2f} m/s, {3.6 * speed:.1f} km/h"
        assert abs(number(shown["Middle of vehicle 1"], "m") - vehicles["position"][rows][0]) < 0.06
        assert ("Vehicle 1: friction power" in shown) == TRAINS[kind][1]
        if page.locator("#vehicle option").count() > 1:
            before = drawings(page)
            page.select_option("#vehicle", "2")
            assert changed(before, drawings(page))
            assert "Middle of vehicle 2" in readout(page)


@pytest.mark.parametrize("kind", [*TRAINS, "package"])
@pytest.mark.parametrize("width", [420, 1400])
def test_nothing_is_cut_off(browser, results, kind, width):
    with opened_page(browser, results(kind), width) as page:
        page.wait_for_timeout(200)
        assert page.evaluate("document.scrollingElement.scrollWidth") <= width
        unnamed = page.evaluate(
            """() => [...document.querySelectorAll("[role=img]")].filter((drawing) =>
                !(drawing.getAttribute("aria-label") || drawing.querySelector("title")?.textContent)).length"""
        )
        assert unnamed == 0
        assert page.locator("h2", has_text="What was run").is_visible()


@pytest.mark.parametrize("kind", [*TRAINS, "package"])
def test_a_page_is_small(results, kind):
    assert (results(kind) / "report.html").stat().st_size < 2_000_000


def test_the_section_is_that_of_the_store(browser, results):
    folder = results("energy")
    store = zarr.open_group(folder / "rail-left.zarr", mode="r")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        field = xarray.open_zarr(folder / "rail-left.zarr", consolidated=False)
    assert field["section_rise"].dims == ("time", "probe", "cell")
    assert {"section_chainage", "section_y", "section_z"} <= set(field["section_rise"].coords)
    assert field["section_y"].attrs["units"] == "m" and field.attrs["field_side"] == "left"
    rises, chainages = store["section_rise"][:], store["section_chainage"][:]
    heat = store["section_area"][:] * rises * 7850 * 450
    # Both probes have been passed; at the end the section has the heat that the series tell.
    series = table(folder, "rail")
    side = series["rail"] == "left"
    for probe in (0, 1):
        of_series = series[f"probe[{probe + 1}].heat"][side][-1]
        assert abs(heat[-1, probe].sum() - of_series) < 1e-3 * abs(of_series)
    with opened_page(browser, folder) as page:
        page.wait_for_selector("#section-picture canvas")
        titles = set()
        for probe in (0, 1):
            page.select_option("#probe", str(probe))
            titles.add(page.locator("#section-picture strong").inner_text())
            for share in (0.0, 0.5, 1.0):
                set_slider(page, share)
                said = page.locator("#section-picture figcaption span").inner_text()
                actual = float(re.match(r"section of ([\d.]+) s", said)[1])
                (words,) = (words for words in readout(page) if words.startswith("Section at"))
                assert abs(float(words.split()[2]) - chainages[probe]) < 0.06
                shown = readout(page)[words]
                record = numpy.flatnonzero(numpy.isclose(store["time"][:], actual))
                wanted = rises[record[0], probe].max()
                assert close(number(shown, "K"), wanted) or wanted < 1e-6, (shown, wanted)
        assert len(titles) == 2
        canvas = page.locator("#section-picture canvas")
        pictures = set()
        for limit in page.locator("#heat-limit option").all()[:3]:
            page.select_option("#heat-limit", limit.get_attribute("value"))
            pictures.add(canvas.evaluate("canvas => canvas.toDataURL()"))
        page.select_option("#rail", "1")
        assert "right rail" in page.locator("#section-picture strong").inner_text()
        pictures.add(canvas.evaluate("canvas => canvas.toDataURL()"))
        assert len(pictures) == 4
        # Pointing at the middle of the head reads a cell of it.
        canvas.scroll_into_view_if_needed()
        box = canvas.bounding_box()
        page.mouse.move(box["x"] + 0.5 * box["width"], box["y"] + 30)
        said = page.locator("#section-picture output").inner_text()
        assert re.fullmatch(r"\d+\.\d mm to the (field|gauge) side, \d+\.\d mm deep: .* .?K", said), said


def test_the_section_is_first_that_of_the_warmest_foot(browser, results):
    folder = results("energy")
    store = zarr.open_group(folder / "rail-left.zarr", mode="r")
    field = xarray.open_zarr(folder / "rail-left.zarr", consolidated=False)
    assert field["warmest_section_rise"].dims == ("time", "cell")
    assert field["warmest_section_chainage"].dims == ("time",)
    rises, chainages, times = (store[name][:] for name in ("warmest_section_rise", "warmest_section_chainage", "time"))
    # The place is that of the outputs, and the foot is as warm as they say there (the lowest row on the middle).
    series = table(folder, "rail")
    rows = (series["rail"] == "left") & numpy.isclose(series["time"], times[-1])
    assert abs(series["foot.present.chainage"][rows][0] - chainages[-1]) < 1e-6
    with opened_page(browser, folder) as page:
        page.wait_for_selector("#section-picture canvas")
        assert page.locator("#probe").input_value() == "-1"
        set_slider(page, 1.0)
        title = page.locator("#section-picture strong").inner_text()
        assert "where the foot is warmest then, left rail" in title, title
        assert abs(float(re.search(r"at (-?[\d.]+) m", title)[1]) - chainages[-1]) < 0.01
        assert page.locator("#section-picture figcaption span").inner_text().endswith("the mean of left and right")
        (words,) = (words for words in readout(page) if words.startswith("Section at"))
        assert close(number(readout(page)[words], "K"), rises[-1].max())


def test_speed_limits_are_shown_and_told(browser, results):
    with opened_page(browser, results("energy")) as page:
        (said,) = page.locator("p", has_text="exceeds the speed limit").all_inner_texts()
        assert "exceeds the speed limit of 54.0 km/h from chainage -1000 m to 5 m" in said
        assert page.locator("#along-track figure", has_text="speed limit").count() == 2


def test_a_replay_has_the_measured_speed_and_its_root_mean_square(browser, results):
    folder = results("replay")
    train = table(folder, "train")
    with opened_page(browser, folder) as page:
        set_slider(page, 0.5)
        shown = readout(page)
        at = numpy.isclose(train["time"], number(shown["Time of the train"], "s"))
        measured, rms = train["driver.measured_speed"][at][0], train["driver.speed_rms"][-1]
        assert shown["Measured speed"] == f"{measured:.2f} m/s, {3.6 * measured:.1f} km/h"
        words = shown["Simulated less measured, root mean square"]
        assert words == f"{rms:.3f} m/s, {3.6 * rms:.2f} km/h"
        panel = page.locator("#over-time figure", has_text="Speed of the leading vehicle")
        assert f"{3.6 * rms:.2f} km/h" in panel.inner_text() and "measured" in panel.inner_text()


def test_further_outputs_are_those_of_their_table(browser, results):
    folder = results("acceptance")
    outputs = table(folder, "outputs")
    with opened_page(browser, folder) as page:
        set_slider(page, 0.7)
        shown = readout(page)
        at = number(shown["Time of the train"], "s")
        name = "body.acceleration.lateral"
        said = number(shown[f"Vehicle 1: {name}"], "m/s2")
        near = numpy.abs(outputs["time"] - at) < 0.05
        assert any(close(said, value) for value in outputs[name][near]), said
        assert page.locator("#over-time figure", has_text="Further outputs").count() > 1
        assert page.locator("h2", has_text="Limits").is_visible()


def test_a_page_of_a_package_tells_its_units_and_what_was_run(browser, results):
    folder = results("package")
    units = tomllib.loads((folder / "manifest.toml").read_text())["unit"]
    with opened_page(browser, folder) as page:
        text = page.inner_text("body")
        slowest = max(units, key=lambda unit: unit["wall_time_s"])
        assert slowest["name"] in text and "Last message" in text
        assert "export-ssp" not in text and "train.ssp --duration 0.5" in text
        assert page.locator("svg").count() > 1


def test_a_run_that_was_interrupted_says_so(browser, results):
    with opened_page(browser, results("interrupted")) as page:
        assert "not completed" in page.inner_text("header")
