"""The report in a real browser: Chromium as Debian packages it."""

import re

import numpy
import pytest
import zarr
from report_page import (
    browser,
    changed,
    close,
    drawings,
    needs_browser,
    number,
    readout,
    row_of,
    set_slider,
    table,
)

pytestmark = needs_browser

@pytest.fixture(scope="module")
def opened(browser, run):
    """The report in a window, with what the console says of errors and what the page asks for."""
    context = browser.new_context(viewport={"width": 1200, "height": 900})
    page = context.new_page()
    page.set_default_timeout(120_000)
    errors, requests = [], []
    page.on("console", lambda said: errors.append(said.text) if said.type == "error" else None)
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("request", lambda request: requests.append(request.url))
    page.goto((run / "report.html").as_uri())
    page.wait_for_selector("#along-track canvas")
    yield page, errors, requests
    context.close()


@pytest.fixture()
def page(opened):
    """The report in a window as it is at first; no test may leave errors on the console."""
    page, errors, requests = opened
    page.emulate_media(color_scheme="light")
    page.set_viewport_size({"width": 1200, "height": 900})
    page.click("[data-zoom=whole]")
    yield page
    assert errors == []
    assert [url for url in requests if not url.startswith(("file:", "data:", "blob:"))] == []


@pytest.fixture(scope="module")
def series(run):
    """The tables of the run as columns by name."""
    return {name: table(run, name) for name in ("vehicles", "wheels")}


@pytest.mark.parametrize("share", [0.0, 0.37, 1.0])
def test_numbers_at_a_time_are_those_of_the_series(page, series, share):
    set_slider(page, share)
    for vehicle in (1, 4):
        page.select_option("#vehicle", str(vehicle))
        shown = readout(page)
        time = number(shown["Time of the train"], "s")
        rows = row_of(series["vehicles"], time=time, vehicle=vehicle)
        assert rows.sum() == 1, time
        expected = {name: values[rows][0] for name, values in series["vehicles"].items()}
        assert abs(number(shown[f"Middle of vehicle {vehicle}"], "m") - expected["position"]) < 0.06
        for words, column, unit in (
            ("rear coupler", "coupler_rear_force", "N"),
            ("creep force", "creep_force", "N"),
            ("friction power", "friction_power", "W"),
            ("synchronisation force", "sync_force", "N"),
            ("position error", "position_error", "m"),
        ):
            value = number(shown[f"Vehicle {vehicle}: {words}"], unit)
            assert close(value, expected[column]), (words, value, expected[column])
        leading = series["vehicles"]["velocity"][row_of(series["vehicles"], time=time, vehicle=1)][0]
        speeds = f"{leading:.2f} m/s, {3.6 * leading:.1f} km/h"
        assert shown["Leading vehicle"] == speeds


def test_the_residual_of_a_coupling_is_the_power_that_is_lost(page, series):
    set_slider(page, 0.5)
    page.select_option("#vehicle", "1")
    shown = readout(page)
    time = number(shown["Time of the train"], "s")
    rows = row_of(series["vehicles"], time=time, vehicle=1)
    of = {name: values[rows][0] for name, values in series["vehicles"].items()}
    force = of["coupler_front_force"] - of["coupler_rear_force"] + of["traction_force"]
    force += of["resistance_force"] - of["brake_force"]
    expected = force * of["train_velocity"] - (force + of["sync_force"]) * of["velocity"]
    assert close(number(shown["Vehicle 1: residual power"], "W"), expected)


def test_hovering_reads_the_values_of_the_series(page, series):
    page.select_option("#vehicle", "2")
    figure = page.locator("figure", has_text="Rear coupler force")
    figure.scroll_into_view_if_needed()
    over = figure.locator(".u-over")
    box = over.bounding_box()
    for share in (0.2, 0.7):
        page.mouse.move(box["x"] + share * box["width"], box["y"] + 0.5 * box["height"])
        time, value, highest, lowest = figure.locator(".u-value").all_inner_texts()
        rows = row_of(series["vehicles"], time=float(time), vehicle=2)
        expected = series["vehicles"]["coupler_rear_force"][rows][0]
        assert close(number(value, "N"), expected)
        assert number(lowest, "N") <= number(value, "N") <= number(highest, "N")


def test_hovering_reads_the_chosen_wheel(page, series):
    wheel = page.locator("#wheel option", has_text="vehicle 1, wheelset 3, right").get_attribute("value")
    page.select_option("#wheel", wheel)
    figure = page.locator("figure", has_text="Friction power of the wheel")
    figure.scroll_into_view_if_needed()
    box = figure.locator(".u-over").bounding_box()
    page.mouse.move(box["x"] + 0.6 * box["width"], box["y"] + 0.5 * box["height"])
    time, value, *_ = figure.locator(".u-value").all_inner_texts()
    rows = row_of(series["wheels"], time=float(time), vehicle=1, wheelset=3, side="right")
    assert rows.sum() == 1
    assert close(number(value, "W"), series["wheels"]["friction_power"][rows][0])


def test_the_field_is_that_of_the_store(page, run):
    store = zarr.open_group(run / "rail.zarr", mode="r")
    (name,) = set(store.array_keys()) - {"time", "chainage", "depth"}
    set_slider(page, 0.6)
    page.select_option("#depth", "0")
    shown = readout(page)
    actual = float(re.match(r"field of ([\d.]+) s", shown["left rail"])[1])
    (words,) = (words for words in shown if words.startswith("Rise at"))
    chainage = float(re.match(r"Rise at ([\d.]+) m", words)[1])
    time = numpy.flatnonzero(numpy.isclose(store["time"][:], actual))
    assert len(time) == 1, "the page states the actual time of the field"
    along = store[name][int(time[0]), :, 0]
    # A column of the page is some elements, of which it has the rise farthest from zero.
    spacing = numpy.diff(store["chainage"][:]).min()
    near = along[numpy.abs(store["chainage"][:] - chainage) < 2.0 + spacing]
    rise = number(shown[words], "K")
    assert any(close(rise, value) for value in near) or abs(rise) < 1e-6, (rise, near)


def test_slider_and_choices_change_the_drawings(page):
    before = drawings(page)
    set_slider(page, 0.3)
    after = drawings(page)
    moved = changed(before, after)
    for title in ("Track", "Coupler forces along the train", "Friction along the train", "Temperature rise", "Driver"):
        assert any(name.startswith(title) for name in moved), (title, moved)
    page.select_option("#vehicle", "3")
    of_vehicle = drawings(page)
    assert any(name.startswith("Longitudinal creep force") for name in changed(after, of_vehicle))
    wheels = page.locator("#wheel option").all()
    page.select_option("#wheel", wheels[-1].get_attribute("value"))
    of_wheel = drawings(page)
    assert any(name.startswith("Creepage") for name in changed(of_vehicle, of_wheel))
    limits = page.locator("#heat-limit option").all()
    page.select_option("#heat-limit", limits[-1].get_attribute("value"))
    assert any(name.startswith("Temperature") for name in changed(of_wheel, drawings(page)))


def test_zoom_is_that_of_all_drawings_along_the_track(page):
    before = drawings(page)
    figure = page.locator("#along-track figure", has_text="Track").first
    figure.scroll_into_view_if_needed()
    box = figure.locator(".u-over").bounding_box()
    page.mouse.move(box["x"] + 0.3 * box["width"], box["y"] + 20)
    page.mouse.down()
    page.mouse.move(box["x"] + 0.6 * box["width"], box["y"] + 20, steps=4)
    page.mouse.up()
    shown = page.evaluate("view.along.panels.map(({ plot }) => [plot.scales.x.min, plot.scales.x.max])")
    assert all(ends == shown[0] for ends in shown)
    assert len(changed(before, drawings(page))) >= len(shown) - 1
    page.click("[data-zoom=whole]")
    assert page.evaluate("view.along.shown") == page.evaluate("view.along.whole")


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [420, 1400])
def test_nothing_is_cut_off(page, scheme, width):
    page.emulate_media(color_scheme=scheme)
    page.set_viewport_size({"width": width, "height": 900})
    page.wait_for_timeout(100)
    assert page.evaluate("document.scrollingElement.scrollWidth") <= width
    paper = page.evaluate("getComputedStyle(document.body).backgroundColor")
    assert (sum(map(int, re.findall(r"\d+", paper)[:3])) < 200) == (scheme == "dark")
    widths = page.evaluate("[...document.querySelectorAll('.uplot')].map((plot) => plot.offsetWidth)")
    assert max(widths) <= width


def test_every_drawing_says_what_it_is(page):
    unnamed = page.evaluate(
        """() => [...document.querySelectorAll("[role=img]")].filter((drawing) =>
            !(drawing.getAttribute("aria-label") || drawing.querySelector("title")?.textContent)).length"""
    )
    assert unnamed == 0
    assert page.locator("[role=img]").count() > 10


def test_the_first_screen_needs_no_script(browser, run):
    context = browser.new_context(java_script_enabled=False, viewport={"width": 1200, "height": 900})
    page = context.new_page()
    page.goto((run / "report.html").as_uri())
    assert page.locator(".verdict strong").is_visible()
    assert page.locator(".drawing svg").first.is_visible()
    assert not page.locator("#linked-view").is_visible()
    context.close()


def test_the_page_is_small(run):
    assert (run / "report.html").stat().st_size < 2_000_000
