# SPDX-License-Identifier: LGPL-2.1-or-later
"""The documentation is written as a site without a warning, its links lead somewhere
without a network, and what there is to be is there."""
import re
import shutil

import pytest
import write as site
from check_links import broken_links
from lumbricus_run import SOURCE

import lumbricus


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    there = tmp_path_factory.mktemp("site")
    site.write(there)
    return there


def text_of(file):
    return re.sub(r"<[^>]*>", "", file.read_text(encoding="utf-8"))


def test_all_cases_are_there_with_their_pictures(folder):
    start = (folder / "index.html").read_text()
    cases = [case.parent for case in (SOURCE / "parameters").glob("*/README.md")]
    assert len(cases) > 20
    for case in cases:
        assert f'href="parameters/{case.name}/README.html"' in start
        page = (folder / "parameters" / case.name / "README.html").read_text()
        if "![" in (case / "README.md").read_text():
            assert '<img alt="' in page and "_images/" in page, case
    assert start.count("_images/thumbnail") == len(cases)


def test_all_documents_are_there(folder):
    start = (folder / "index.html").read_text()
    for file in (SOURCE / "doc").glob("*.md"):
        assert f'href="doc/{file.stem}.html"' in start
    for file in (SOURCE / "python" / "notebooks").glob("*.py"):
        page = text_of(folder / "python" / "notebooks" / f"{file.stem}.html")
        title = re.search(r"^# # (.*)", file.read_text(), re.M)[1]
        assert title in page
        assert "import" in page and "# %%" not in page


def test_formulas_are_set(folder):
    theory = (folder / "doc" / "theory.html").read_text()
    assert theory.count('<pre class="formula">') > 30
    assert "<i>F̄</i><sub><i>e</i></sub> = <i>J</i><sup>−1/3</sup>" in theory
    # In sentences too.
    assert "<i>u</i><sub>ref</sub> := u in the liquid" in " ".join(theory.split())
    # Commands are not.
    assert "--set" in theory


def test_classes_of_python_are_there(folder):
    page = (folder / "python" / "classes.html").read_text()
    for name in lumbricus.__all__:
        if name not in ("Fit", "Parameter", "find_program"):
            module = getattr(lumbricus, name).__module__
            assert (f'id="lumbricus.{name}"' in page
                    or f'id="{module}.{name}"' in page), name
    assert 'id="lumbricus.Run.report"' in page
    assert 'id="lumbricus.worm1d.Worm.crawl"' in page


@pytest.mark.parametrize("link, words", [
    ("nowhere.html", "leads nowhere"), ("doc/theory.html#nowhere", "there is no"),
    ("../outside.html", "leads nowhere")])
def test_a_broken_link_is_found(link, words, folder, tmp_path):
    copy = shutil.copytree(folder, tmp_path / "copy")
    assert broken_links(copy) == []
    (copy / "new.html").write_text(f'<a href="{link}">there</a>')
    broken, = broken_links(copy)
    assert "new.html" in broken and words in broken


def test_what_is_elsewhere_is_found(folder, tmp_path):
    (tmp_path / "new.html").write_text('<script src="https://example.org/a.js"></script>'
                                       '<a href="https://example.org">there</a>')
    broken, = broken_links(tmp_path)
    assert "a.js" in broken


def test_a_link_to_a_page_that_is_not_there_is_an_error(tmp_path):
    """Of a checkout with one page besides."""
    checkout = tmp_path / "checkout"
    site.copy_of(SOURCE, checkout)
    (checkout / "doc" / "new.md").write_text("# New\n\n[There](missing.md)\n")
    with pytest.raises(RuntimeError, match=r"doc/new.md:3.*missing.md"):
        site.write(tmp_path / "site", checkout)
