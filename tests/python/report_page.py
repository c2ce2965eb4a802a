"""Reports in a real browser, Chromium as Debian packages it, and what they are compared with."""

import re
import shutil
from contextlib import contextmanager

import numpy
import pyarrow.parquet as parquet
import pytest
from playwright.sync_api import sync_playwright

CHROMIUM = shutil.which("chromium")
needs_browser = pytest.mark.skipif(CHROMIUM is None, reason="chromium is not installed")

PREFIXES = {"n": 1e-9, "µ": 1e-6, "m": 1e-3, "": 1.0, "k": 1e3, "M": 1e6}


@pytest.fixture(scope="module")
def browser():
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        yield browser
        browser.close()


@contextmanager
def opened_page(browser, folder, width=1200):
    """The report of a folder in a window; it may neither leave errors on the console nor ask for anything."""
    context = browser.new_context(viewport={"width": width, "height": 900})
    page = context.new_page()
    page.set_default_timeout(60_000)
    errors, requests = [], []
    page.on("console", lambda said: errors.append(said.text) if said.type == "error" else None)
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("request", lambda request: requests.append(request.url))
    page.goto((folder / "report.html").as_uri())
    yield page
    context.close()
    assert errors == []
    assert [url for url in requests if not url.startswith(("file:", "data:", "blob:"))] == []


def table(folder, name):
    """A table of a run as columns by name."""
    columns = parquet.read_table(folder / "series" / f"{name}.parquet").to_pydict()
    return {key: numpy.array(values) for key, values in columns.items()}


def number(text, unit):
    """A number as the page shows it, such as `−173.2 kN`, in the unit without prefix."""
    text = text.replace("−", "-").replace("chainage ", "")
    found = re.fullmatch(rf"(-?[\d.]+) ?([nµmkM]?){re.escape(unit)}", text)
    assert found, text
    return float(found[1]) * PREFIXES[found[2]]


def close(shown, expected):
    """Whether four digits are shown of the expected value."""
    return abs(shown - expected) <= 1e-3 * abs(expected) + 1e-12


def readout(page):
    """What the page says in numbers at the chosen time."""
    rows = page.query_selector_all(".readout div")
    return {row.query_selector("dt").text_content(): row.query_selector("dd").text_content() for row in rows}


def set_slider(page, share):
    page.evaluate(
        """share => {
            const slider = document.getElementById("time");
            slider.value = Math.round(share * slider.max);
            slider.dispatchEvent(new Event("input"));
        }""",
        share,
    )


def drawings(page):
    """All drawings of the linked view, by their titles."""
    return page.evaluate(
        """() => Object.fromEntries([...document.querySelectorAll("#linked-view figure")].map((figure) =>
            [figure.querySelector("strong").textContent, figure.querySelector("canvas").toDataURL()]))"""
    )


def changed(before, after):
    return {title for title in before if title in after and before[title] != after[title]}


def row_of(table, **keys):
    """The rows of a table whose columns have these values."""
    rows = numpy.ones(len(table["time"]), dtype=bool)
    for key, value in keys.items():
        rows &= table[key] == value if isinstance(value, (int, str)) else numpy.isclose(table[key], value)
    return rows
