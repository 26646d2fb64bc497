# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces of an HTML page that needs no other file. All text is escaped."""

import base64
import html
import math
import pathlib
from collections.abc import Iterable, Sequence
from typing import Any

from .arrays import Number

STYLE = """
:root { color-scheme: light dark; --text: #1d1d1f; --page: #ffffff;
  --faint: #6a6a70; --line: #d8d8dc; --stripe: #f5f5f7; }
@media (prefers-color-scheme: dark) {
  :root { --text: #e6e6ea; --page: #18181b; --faint: #a0a0a8;
    --line: #3a3a40; --stripe: #222226; } }
body { margin: 2rem auto; padding: 0 1rem; max-width: 60rem;
  font: 16px/1.5 system-ui, sans-serif; color: var(--text);
  background: var(--page); }
h1 { font-size: 1.6rem; line-height: 1.25; }
h2 { font-size: 1.2rem; margin-top: 2.2rem;
  border-bottom: 1px solid var(--line); }
figure { margin: 1.2rem 0; }
figure img, figure video { width: 100%; height: auto; background: #ffffff;
  border-radius: 6px; padding: 6px; box-sizing: border-box; }
figure iframe { width: 100%; height: 32rem; border: 0; border-radius: 6px; }
figcaption, .note { color: var(--faint); font-size: 0.92rem; }
.scroll { overflow: auto; max-height: 32rem; }
table { border-collapse: collapse; font-size: 0.92rem;
  font-variant-numeric: tabular-nums; }
th, td { padding: 0.2rem 0.7rem; text-align: right; vertical-align: top;
  border-bottom: 1px solid var(--line); }
th { font-weight: 600; }
tbody tr:nth-child(even) { background: var(--stripe); }
td { white-space: nowrap; }
td.text, th.text { text-align: left; white-space: normal; max-width: 24rem;
  overflow-wrap: break-word; }
summary { cursor: pointer; margin: 0.6rem 0; }
"""

KINDS = {".png": "image/png", ".gif": "image/gif", ".mp4": "video/mp4"}


def number(value: Number, digits: int = 3) -> str:
    """As in '0.0123' or '1.5e-14'; '–' where there is none."""
    return f"{value:.{digits}g}" if math.isfinite(value) else "–"


def paragraph(text: str, kind: str = "") -> str:
    kind = f' class="{kind}"' if kind else ""
    return f"<p{kind}>{html.escape(text)}</p>"


def heading(text: str) -> str:
    return f"<h2>{html.escape(text)}</h2>"


def table(names: Sequence[str], rows: Iterable[Sequence[Any]],
          text_columns: int = 1) -> str:
    """The first columns are text, aligned to the left."""
    def row(cells: Sequence[Any], tag: str) -> str:
        return "<tr>" + "".join(
            f'<{tag}{" class=text" if i < text_columns else ""}>'
            f"{html.escape(str(cell))}</{tag}>"
            for i, cell in enumerate(cells)) + "</tr>"

    head = f"<thead>{row(names, 'th')}</thead>" if names else ""
    body = "\n".join(row(cells, "td") for cells in rows)
    return (f'<div class="scroll"><table>{head}<tbody>\n{body}\n'
            "</tbody></table></div>")


def details(title: str, content: str) -> str:
    return (f"<details><summary>{html.escape(title)}</summary>\n{content}\n"
            "</details>")


def figure(file_name: pathlib.Path, title: str, caption: str) -> str:
    """A picture, a film, or a page with a scene, as part of the page."""
    if file_name.suffix == ".html":
        return framed(f'<iframe loading="lazy" title="{html.escape(title)}" srcdoc="'
                      + html.escape(file_name.read_text(encoding="utf-8"))
                      + '"></iframe>', title, caption)
    data = base64.b64encode(file_name.read_bytes()).decode("ascii")
    source = f'src="data:{KINDS[file_name.suffix]};base64,{data}"'
    if file_name.suffix == ".mp4":
        shown = f"<video controls loop muted {source}>{html.escape(title)}</video>"
    else:
        shown = f'<img alt="{html.escape(title)}" {source}>'
    return framed(shown, title, caption)


def framed(shown: str, title: str, caption: str) -> str:
    title, caption = html.escape(title), html.escape(caption)
    return (f"<figure>{shown}\n<figcaption><strong>{title}.</strong> "
            f"{caption}</figcaption></figure>")


def page(title: str, content: Iterable[str], reload_every: float | None = None) -> str:
    reload = ("" if reload_every is None else
              f'<meta http-equiv="refresh" content="{reload_every:g}">\n')
    return (f'<!DOCTYPE html>\n<html lang="en-GB">\n<head>\n'
            f'<meta charset="utf-8">\n'
            f'<meta name="viewport" content="width=device-width, '
            f'initial-scale=1">\n{reload}<title>{html.escape(title)}</title>\n'
            f"<style>{STYLE}</style>\n</head>\n<body>\n"
            f"<h1>{html.escape(title)}</h1>\n" + "\n".join(content)
            + "\n</body>\n</html>\n")
