# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write the documentation as a site: write.py FOLDER.

The pages are the Markdown files of the checkout as they are, in a copy, so that links
between them and to files stay what they are; notebooks become pages too. A warning of
Sphinx is an error, and so is a link inside of the site that leads nowhere.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from check_links import broken_links

SITE = pathlib.Path(__file__).resolve().parent
SOURCE = SITE.parent.parent
# What pages show or lead to.
COPIED = ("*.md", "*.png", "*.gif", "*.py", "*.prm", "*.sh", "*.csv", "*.geo", "*.json",
          "*.css", "*.cc", "*.h", "*.txt", "LICENSE", "*.cff", "*.yml")
FOLDERS = (".", "doc", "parameters", "python", "examples", "benchmarks", "scripts")
LEFT_OUT = re.compile(r"(^|/)(\.|build|results/|__pycache__)|\.egg-info")


def copy_of(checkout: pathlib.Path, folder: pathlib.Path) -> None:
    for top in FOLDERS:
        for pattern in COPIED:
            found = ((checkout / top).glob(pattern) if top == "."
                     else (checkout / top).rglob(pattern))
            for file in found:
                name = file.relative_to(checkout)
                if LEFT_OUT.search(name.as_posix()):
                    continue
                (folder / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(file, folder / name)


def page_of_notebook(text: str) -> str:
    """Cells of a script ('# %%') as Markdown."""
    found = []
    for cell in re.split(r"^# %%", text, flags=re.M)[1:]:
        kind, _, content = cell.partition("\n")
        if "[markdown]" in kind:
            found.append(re.sub(r"^# ?", "", content.strip(), flags=re.M))
        else:
            found.append(f"```python\n{content.strip()}\n```")
    return "\n\n".join(found) + "\n"


def write(folder: pathlib.Path, checkout: pathlib.Path = SOURCE) -> None:
    """Raises RuntimeError with what is wrong."""
    with tempfile.TemporaryDirectory() as temporary:
        source = pathlib.Path(temporary)
        copy_of(checkout, source)
        for notebook in (source / "python" / "notebooks").glob("*.py"):
            notebook.with_suffix(".md").write_text(
                page_of_notebook(notebook.read_text(encoding="utf-8")), encoding="utf-8")
        shutil.copy(source / "doc" / "site" / "conf.py", source)
        shutil.copy(source / "doc" / "site" / "classes.md", source / "python")
        process = subprocess.run(
            [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-b", "html",
             "-d", str(source / "_doctrees"), str(source), str(folder)],
            text=True, capture_output=True)
        if process.returncode != 0:
            raise RuntimeError(process.stderr.replace(temporary + "/", ""))
    shutil.copy(folder / "README.html", folder / "index.html")
    if broken := broken_links(folder):
        raise RuntimeError("\n".join(broken))


if __name__ == "__main__":
    try:
        write(pathlib.Path(sys.argv[1]).resolve())
    except RuntimeError as error:
        sys.exit(f"write.py: {error}")
