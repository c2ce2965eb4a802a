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


@pytest.fixture(scope="module")
def faster(tmp_path_factory):
    """The page of a run and of a faster one of a shorter rail, and their results."""
    folder = tmp_path_factory.mktemp("faster")
    scenario = five_vehicles(folder, [("duration_s = 2.0", "duration_s = 1.0")], "")
    for name, settings in [("slow", []), ("fast", ["train.speed_m_per_s=18", "heat.length_m=50"])]:
        arguments = [argument for setting in settings for argument in ("--set", setting)]
        hotfoot("run", scenario, "--quiet", "--results", folder / name, *arguments)
    hotfoot("compare", folder / "slow", folder / "fast", "--output", folder / "page.html", "--quiet")
    return folder


@pytest.mark.parametrize("width", [420, 1400])
def test_rises_along_the_rails_are_drawn(faster, width):
    rises = []
    for name in ("slow", "fast"):
        store = zarr.open_group(faster / name / "rail.zarr", mode="r")
        rises.append(store["temperature_rise"][-1, :, -1])
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        page = browser.new_page(viewport={"width": width, "height": 900})
        errors = []
        page.on("console", lambda said: errors.append(said.text) if said.type == "error" else None)
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.goto((faster / "page.html").as_uri())
        page.wait_for_selector("#along-rails canvas")
        titles = page.locator("#along-rails figcaption strong").all_inner_texts()
        assert [title.split(" ", 4)[:4] for title in titles[::2]] == [["Rise", "of", "the", level] for level in ("foot", "surface")]
        assert all("in rail.zarr at 1 s" in title for title in titles[::2]), titles
        # The drawn foot is that of the stores: both runs', and their difference, where both have rail.
        drawn = page.evaluate("alongRails.group.panels.slice(0, 2).map(({ plot }) => plot.data)")
        factor = max(abs(rise).max() for rise in rises) / max(abs(v) for row in drawn[0][1:] for v in row if v is not None)
        for row, rise in zip(drawn[0][1:], rises, strict=True):
            shown = numpy.array(row[: len(rise)], dtype=float) * factor
            assert numpy.allclose(shown, rise, atol=1e-5 * abs(rise).max())
            assert all(value is None for value in row[len(rise) :])
        scale = drawn[1][1][100] / (rises[1][100] - rises[0][100])
        shown = numpy.array(drawn[1][1][: len(rises[1])], dtype=float) / scale
        wanted = rises[1] - rises[0][: len(rises[1])]
        assert numpy.allclose(shown, wanted, atol=1e-5 * abs(wanted).max())
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
