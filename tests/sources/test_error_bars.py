# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every README of the gallery says how far its numbers are off, in the same words as
doc/accuracy.md: both are written by benchmarks/run.sh gallery_errors --write."""
import pathlib
import re

import pytest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
GALLERY = SOURCE / "parameters"
NAMES = sorted(file.parent.name for file in GALLERY.glob("*/README.md"))


def rows_below(command, page):
    """The rows of the table below a command, each a list of its cells."""
    text = page.read_text(encoding="utf-8")
    table = re.search(rf"\n    {re.escape(command)}\n\n((?:\|.*\|\n)+)", text)
    assert table, f"{page} has no table below {command}"
    head, rule, *rows = [[cell.strip() for cell in line.strip("|").split("|")]
                         for line in table[1].splitlines()]
    assert set(rule) == {"---"}
    assert all(len(row) == len(head) for row in rows)
    return rows


def test_there_is_a_gallery():
    assert len(NAMES) > 20


@pytest.mark.parametrize("name", NAMES)
def test_error_bars(name):
    command = "benchmarks/run.sh gallery_errors"
    own = rows_below(f"{command} {name}", GALLERY / name / "README.md")
    link = f"[{name}](../parameters/{name}/README.md)"
    assert own and own == [row for case, *row in rows_below(
        command, SOURCE / "doc" / "accuracy.md") if case == link]
    for file, unknowns, *numbers in own:
        assert (GALLERY / name / re.match("`(.*?)`", file)[1]).is_file()
        assert int(unknowns.replace(",", "")) > 0
        # At least one, and none that is no number.
        assert any(re.search(r"\d %", number) for number in numbers), own
        assert not re.search("nan|inf", "".join(numbers))
    # What is large is explained below it.
    largest = max(float(number) for row in own
                  for number in re.findall(r"([\d.]+) %", " ".join(row[2:])))
    if largest > 5:
        section = (GALLERY / name / "README.md").read_text().split("## Error bars\n")[1]
        words = section.split("\n## ")[0].rpartition("|\n")[2]
        assert len(words.split()) > 20, (name, largest)


def test_what_a_page_without_it_gives(tmp_path):
    (tmp_path / "README.md").write_text("# A case\n\n## Error bars\n\nSmall.\n")
    with pytest.raises(AssertionError, match="no table below"):
        rows_below("benchmarks/run.sh gallery_errors a", tmp_path / "README.md")
