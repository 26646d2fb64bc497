# SPDX-License-Identifier: LGPL-2.1-or-later
"""Types, style, the examples in docstrings, and that it can be installed."""
import doctest
import importlib
import itertools
import os
import pkgutil
import shutil
import subprocess
import sys
import tomllib

import pytest
from lumbricus_run import SOURCE

import lumbricus

PACKAGE = SOURCE / "python"
MODULES = [module.name for module in pkgutil.iter_modules(lumbricus.__path__)
           if not module.ispkg]


def check(*command):
    process = subprocess.run([sys.executable, "-m", *command], cwd=PACKAGE, text=True,
                             capture_output=True)
    assert process.returncode == 0, process.stdout + process.stderr


def test_types(tmp_path):
    check("mypy", "--strict", f"--cache-dir={tmp_path}")
    # Of all of it.
    assert "ignore_errors" not in (PACKAGE / "pyproject.toml").read_text()


def test_style():
    check("ruff", "check", "--no-cache", "src", "notebooks", "../tests/python",
          "../tests/site", "../tests/packaging", "../doc/site")


def test_examples_in_docstrings():
    n_examples = 0
    for name in MODULES:
        result = doctest.testmod(importlib.import_module(f"lumbricus.{name}"))
        assert result.failed == 0, name
        n_examples += result.attempted
    assert n_examples >= 8


def test_versions_are_those_of_the_scripts():
    """pyproject.toml and scripts/requirements.txt ask for the same."""
    project = tomllib.loads((PACKAGE / "pyproject.toml").read_text())["project"]
    wanted = [*project["dependencies"],
              *itertools.chain(*project["optional-dependencies"].values())]
    listed = [line.replace(" ", "") for line in
              (SOURCE / "scripts" / "requirements.txt").read_text().splitlines()
              if not line.startswith("#")]
    assert sorted(wanted) == sorted(listed)


def test_names():
    for name in lumbricus.__all__:
        assert getattr(lumbricus, name).__doc__
    with pytest.raises(AttributeError):
        lumbricus.nonsense  # noqa: B018


def test_a_controller_needs_no_packages():
    subprocess.run(
        [sys.executable, "-S", "-c", "import lumbricus; lumbricus.Controller"],
        env=os.environ | {"PYTHONPATH": str(PACKAGE / "src")}, check=True)
    # Nor do programs that have scripts/ on their path.
    subprocess.run([sys.executable, "-S", "-c", "import lumbricus_controller as l; "
                    "l.Controller"],
                   env=os.environ | {"PYTHONPATH": str(SOURCE / "scripts")}, check=True)


def test_it_can_be_installed(tmp_path):
    """As 'pip install ./python' does it, without what it depends on."""
    subprocess.run(
        [sys.executable, "-m", "pip", "install", "-q", "--no-deps",
         "--no-build-isolation", "--disable-pip-version-check",
         "--target", str(tmp_path / "there"), "."],
        cwd=_copy(tmp_path / "copy"), check=True, capture_output=True)
    there = tmp_path / "there"
    for name in ("py.typed", "plot/viewer/scene.js", "plot/viewer/scene.css"):
        assert (there / "lumbricus" / name).exists()
    said = subprocess.run(
        [str(there / "bin" / "lumbricus-plot"), "--help"], text=True,
        capture_output=True, env=os.environ | {"PYTHONPATH": str(there)}, check=True)
    assert "RUN_DIR" in said.stdout


def _copy(folder):
    """Of what is to be installed: setuptools writes beside it."""
    shutil.copytree(PACKAGE, folder, ignore=shutil.ignore_patterns(
        "__pycache__", "*.egg-info", "build"))
    return folder
