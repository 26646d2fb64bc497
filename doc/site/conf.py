# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sphinx: the Markdown files of the checkout, which write.py has put here, and the
classes of the Python package."""

import json
import pathlib
import re
import sys

from docutils import nodes

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "doc" / "site"), str(HERE / "python" / "src")]
from formulas import is_formula, pieces, rendered  # noqa: E402

with open(HERE / "codemeta.json", encoding="utf-8") as _file:
    _meta = json.load(_file)
project = _meta["name"]
version = release = _meta["version"]
author = _meta["author"][0]["name"]
copyright = author

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
root_doc = "README"
source_suffix = {".md": "markdown"}
exclude_patterns = ["doc/site/*", "python/README.md"]
myst_heading_anchors = 4
autodoc_typehints = "description"
autodoc_member_order = "bysource"
highlight_language = "none"
html_theme = "furo"
html_title = f"{project} {version}"
html_static_path = ["doc/site/static"]
html_css_files = ["site.css"]
html_copy_source = False
# Formulas are on these pages.
WITH_FORMULAS = {"doc/theory", "doc/solvers", "doc/paper"}
PICTURE_OF_HTML = re.compile(r'<img src="([^"]+)" width="(\d+)" alt="">')


def links_of(text, folder):
    """The pages in a folder that the README names, in its order."""
    found = re.findall(rf"\]\(({folder}/[^)#]+)\.md\)", text)
    return list(dict.fromkeys(found))


def contents(caption, pages):
    return "\n".join(["", "```{toctree}", ":hidden:", f":caption: {caption}", "",
                      *pages, "```", ""])


def add_contents(app, docname, source):
    """What is where comes from the README's own tables."""
    if docname != root_doc:
        # A case in several parts.
        parts = sorted(path.relative_to(HERE).with_suffix("").as_posix()
                       for path in (HERE / docname).parent.glob("*/README.md"))
        if docname.startswith("parameters/") and parts:
            source[0] += contents("Parts", ["/" + part for part in parts])
        return
    text = source[0]
    pages = links_of(text, "doc")
    pages += sorted({f"doc/{path.stem}" for path in (HERE / "doc").glob("*.md")}
                    - set(pages))
    begin = [page for page in pages if page in ("doc/first-hour", "doc/python")]
    notebooks = sorted(path.relative_to(HERE).with_suffix("").as_posix()
                       for path in (HERE / "python" / "notebooks").glob("*.md"))
    source[0] = PICTURE_OF_HTML.sub(r"![](\1)", text) + "".join([
        contents("Begin", [*begin, *notebooks, "python/classes"]),
        contents("Cases", links_of(text, "parameters")),
        contents("Read", [page for page in pages if page not in begin]),
        contents("Project", ["CONTRIBUTING", "CHANGELOG"])])


def render_formulas(app, doctree):
    if app.env.docname not in WITH_FORMULAS:
        return
    for block in list(doctree.findall(nodes.literal_block)):
        if is_formula(block.astext()):
            block.replace_self(nodes.raw(
                "", f'<pre class="formula">{rendered(block.astext())}</pre>',
                format="html"))
    for text in list(doctree.findall(nodes.Text)):
        if isinstance(text.parent, (nodes.literal, nodes.literal_block, nodes.raw,
                                    nodes.title)):
            continue
        parts = pieces(text.astext())
        if any(formula for formula, _ in parts):
            text.parent.replace(text, [
                nodes.raw("", rendered(part), format="html") if formula
                else nodes.Text(part) for formula, part in parts])


def setup(app):
    app.connect("source-read", add_contents)
    app.connect("doctree-read", render_formulas)
