"""The page of `hotfoot compare` in a real browser: Chromium as Debian packages it."""

import shutil

import numpy
import pytest
import zarr
from conftest import five_vehicles, hotfoot
from playwright.sync_api import sync_playwright

CHROMIUM = shutil.which("chromium")
pytestmark = pytest.mark.skipif(CHROMIUM is None, reason="chromium is not installed")


@pytest.fixture(scope="module")
def comparison(run, tmp_path_factory):
    """The page of a run and a measurement of its speed that is 1 m/s too fast from 0.2 s on."""
    folder = tmp_path_factory.mktemp("comparison")
    rows = "".join(f"{0.1 * k:.1f},{16.67 if k < 2 else 17.67}\n" for k in range(10))
    (folder / "logger.csv").write_text("time,vehicles[1].velocity\n" + rows)
    hotfoot("compare", run, run, folder / "logger.csv", "--output", folder / "page.html", "--quiet")
    return folder / "page.html"


# A rail with no more elements than a curve has points.
HEAT = """[heat]
model = "energy"
step_s = 0.02
begin_m = -100.0
length_m = 120.0
field_interval_s = 0.5
[heat.parameters]
"section.cell_size" = 0.006
"""


@pytest.fixture(scope="module")
def faster(tmp_path_factory):
    """The page of a run and of a faster one of a shorter rail, and their results."""
    folder = tmp_path_factory.mktemp("faster")
    scenario = five_vehicles(folder, [("duration_s = 2.0", "duration_s = 1.0")], "")
    text = scenario.read_text()
    scenario.write_text(text[: text.index("[heat]")] + HEAT)
    for name, settings in [("slow", []), ("fast", ["train.speed_m_per_s=18", "heat.length_m=110"])]:
        arguments = [argument for setting in settings for argument in ("--set", setting)]
        hotfoot("run", scenario, "--quiet", "--results", folder / name, *arguments)
    hotfoot("compare", folder / "slow", folder / "fast", "--output", folder / "page.html", "--quiet")
    return folder


@pytest.mark.parametrize("width", [420, 1400])
def test_rises_along_the_rails_are_drawn(faster, width):
    fields = [zarr.open_group(faster / name / "rail.zarr", mode="r")["temperature_rise"] for name in ("slow", "fast")]
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        page = browser.new_page(viewport={"width": width, "height": 900})
        errors = []
        page.on("console", lambda said: errors.append(said.text) if said.type == "error" else None)
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.goto((faster / "page.html").as_uri())
        page.wait_for_selector("#along-rails canvas")
        titles = page.locator("#along-rails figcaption strong").all_inner_texts()
        panels = page.evaluate("alongRails.group.panels.map(({ plot }) => plot.data.map((row) => Array.from(row)))")
        assert len(titles) == len(panels) == 4
        for first, (level, depth) in enumerate([("foot", -1), ("surface", 0)]):
            title = titles[2 * first]
            assert title.startswith(f"Rise of the {level} (") and "in rail.zarr at 1 s, " in title, title
            slow, fast = (field[-1, :, depth] for field in fields)
            common = len(fast)
            factor = {"K": 1.0, "mK": 1e-3, "µK": 1e-6, "nK": 1e-9}
            _, own, other = panels[2 * first]
            unit = factor[title.rsplit(" ", 1)[1]]
            # Both runs' curves are those of the stores; the shorter rail ends where it ends.
            assert numpy.allclose(numpy.array(own) * unit, slow, atol=1e-6 * abs(slow).max())
            assert numpy.allclose(numpy.array(other[:common], dtype=float) * unit, fast, atol=1e-6 * abs(fast).max())
            assert all(value is None for value in other[common:])
            unit = factor[titles[2 * first + 1].rsplit(" ", 1)[1]]
            wanted = fast - slow[:common]
            drawn = numpy.array(panels[2 * first + 1][1][:common], dtype=float) * unit
            assert numpy.allclose(drawn, wanted, atol=1e-5 * abs(wanted).max()) and abs(wanted).max() > 0
        assert page.evaluate("document.scrollingElement.scrollWidth") <= width
        assert errors == []
        browser.close()


@pytest.mark.parametrize("width", [420, 1400])
@pytest.mark.parametrize("colours", ["light", "dark"])
def test_the_page_opens_offline_and_shows_what_is_chosen(comparison, width, colours):
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        page = browser.new_page(viewport={"width": width, "height": 900}, color_scheme=colours)
        errors, requests = [], []
        page.on("console", lambda said: errors.append(said.text) if said.type == "error" else None)
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.on("request", lambda request: requests.append(request.url))
        page.goto(comparison.as_uri())
        page.wait_for_selector("#overlay canvas")
        # The column that differs most is shown: the measured speed.
        shown = page.inner_text("#overlay figure >> nth=0")
        assert "vehicles[1].velocity" in shown and "logger.csv" in shown
        before = page.evaluate("document.querySelector('#overlay canvas').toDataURL()")
        page.select_option("#signal", label="coupler_rear_force")
        assert "coupler_rear_force" in page.inner_text("#overlay figure >> nth=0")
        page.click("button[data-column='vehicles.velocity']")
        after = page.evaluate("document.querySelector('#overlay canvas').toDataURL()")
        assert before == after, "the same column is the same drawing"
        assert page.evaluate("document.scrollingElement.scrollWidth") <= width
        assert errors == []
        assert [url for url in requests if not url.startswith(("file:", "data:", "blob:"))] == []
        browser.close()
    assert comparison.stat().st_size < 2_000_000
