"""The page of `hotfoot compare` in a real browser: Chromium as Debian packages it."""

import shutil

import pytest
from conftest import hotfoot
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
