# SPDX-License-Identifier: LGPL-2.1-or-later
"""Links inside of a folder of HTML pages, without a network: each leads to a file and,
where it names one, to a place in it; and nothing that a page needs is elsewhere."""

import functools
import html.parser
import pathlib
import urllib.parse

ELSEWHERE = ("http:", "https:", "mailto:", "data:", "javascript:")


class Page(html.parser.HTMLParser):
    """What a page refers to, what it needs, and the places in it."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.links: list[str] = []
        self.needs: list[str] = []
        self.places: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        for name, value in attrs:
            if name in ("id", "name") and value:
                self.places.add(value)
            elif name == "href" and value:
                (self.links if tag == "a" else self.needs).append(value)
            elif name == "src" and value:
                self.needs.append(value)


@functools.cache
def page(file: pathlib.Path) -> Page:
    return Page(file.read_text(encoding="utf-8"))


def broken_links(folder: pathlib.Path) -> list[str]:
    """A line for each, with the page that has it."""
    found = []
    for file in sorted(folder.rglob("*.html")):
        name = file.relative_to(folder)
        here = page(file)
        for link in here.needs:
            if link.startswith(ELSEWHERE[:2]) or link.startswith("//"):
                found.append(f"{name}: needs '{link}', which is not in the site.")
        for link in [*here.links, *here.needs]:
            if link.startswith(ELSEWHERE):
                continue
            path, _, place = link.partition("#")
            path = urllib.parse.unquote(path.partition("?")[0])
            there = (file.parent / path) if path else file
            if not there.is_file():
                found.append(f"{name}: the link '{link}' leads nowhere.")
            elif place and there.suffix == ".html" and \
                    urllib.parse.unquote(place) not in page(there).places:
                found.append(f"{name}: there is no '{place}' for the link '{link}'.")
    return found
