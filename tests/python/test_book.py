"""The book: it is built, and each of its links and pictures leads somewhere."""

from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest
from conftest import ROOT

BOOK = ROOT / "target" / "book" / "html"


class Page(HTMLParser):
    """What a page of the book links to, and what of it can be linked to."""

    def __init__(self, text):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.anchors.update(attributes[key] for key in ("id", "name") if attributes.get(key))
        self.links += [attributes[key] for key in ("href", "src") if attributes.get(key)]


@pytest.fixture(scope="session")
def book():
    """Folder of the book, which the test run has built."""
    if not BOOK.exists():
        pytest.skip("the book is not there; `cargo xtask book` builds it")
    return BOOK


def test_each_link_and_picture_of_the_book_leads_somewhere(book):
    pages = {file: Page(file.read_text()) for file in book.rglob("*.html")}
    assert len(pages) > 40
    dead = []
    for file, page in pages.items():
        # Its links are from the root of a site.
        if file.name == "404.html":
            continue
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme:
                continue
            target = (file.parent / unquote(parts.path)).resolve() if parts.path else file
            exists = target.is_file() and target.is_relative_to(book.resolve())
            anchor = unquote(parts.fragment)
            if not exists or anchor and target.suffix == ".html" and anchor not in pages[target].anchors:
                dead.append(f"{file.relative_to(book)}: {link}")
    assert not dead, "\n".join(sorted(set(dead)))


def test_the_book_begins_with_a_picture_and_the_first_look(book):
    first = (book / "index.html").read_text()
    assert "foot.svg" in first and "hotfoot run first-look" in first
