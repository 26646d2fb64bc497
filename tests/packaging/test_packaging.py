# SPDX-License-Identifier: LGPL-2.1-or-later
"""A release is of one version and has all that is committed; packages for Debian and
Spack and the image name what the scripts install."""
import ast
import re
import subprocess
import tarfile

import pytest
from lumbricus_run import SOURCE

PACKAGING = SOURCE / "packaging"


def read(name):
    return (SOURCE / name).read_text(encoding="utf-8")


VERSION = re.search(r"project\(lumbricus VERSION ([\d.]+)", read("CMakeLists.txt"))[1]


def listed(name):
    """An array of scripts/environment.sh."""
    return set(re.search(rf"^{name}=\((.*?)\)", read("scripts/environment.sh"),
                         re.S | re.M)[1].split())


def git(folder, *arguments):
    return subprocess.run(
        ["git", "-C", str(folder), "-c", "user.name=test", "-c", "user.email=test@test",
         "-c", "commit.gpgsign=false", *arguments], text=True, capture_output=True,
        check=True).stdout


def release(checkout, folder, *steps):
    return subprocess.run([str(checkout / "scripts" / "release.sh"), str(folder), *steps],
                          text=True, capture_output=True)


@pytest.fixture(scope="module")
def clone(tmp_path_factory):
    """What is committed, with what is not yet, so that it is tried before."""
    there = tmp_path_factory.mktemp("clone") / "lumbricus"
    git(SOURCE, "clone", "-q", str(SOURCE), str(there))
    difference = subprocess.run(
        ["git", "-C", str(SOURCE), "diff", "--binary", "HEAD"], capture_output=True,
        check=True).stdout
    if difference:
        subprocess.run(["git", "-C", str(there), "apply"], input=difference, check=True)
        git(there, "commit", "-qam", "What is not yet")
    return there


def test_one_version(clone, tmp_path):
    done = release(clone, tmp_path, "tarball")
    assert done.returncode == 0, done.stderr
    assert f'version("{VERSION}"' in read("packaging/spack/packages/lumbricus/package.py")
    assert f"lumbricus@{VERSION}" in read("doc/install.md")
    # Packages of one minor version go together: cmake/package.cmake.
    minor = VERSION.rpartition(".")[0]
    for name in ("examples/own_parts/CMakeLists.txt", "doc/extending.md"):
        assert f"find_package(Lumbricus {minor} REQUIRED)" in read(name), name


@pytest.mark.parametrize("file", ["CITATION.cff", "codemeta.json",
                                  "python/pyproject.toml", "CHANGELOG.md"])
def test_another_version_is_refused(file, clone, tmp_path):
    content = (clone / file).read_text()
    assert content.count(VERSION) == 1
    (clone / file).write_text(content.replace(VERSION, "9.9.9"))
    git(clone, "commit", "-qam", "Another version")
    try:
        done = release(clone, tmp_path, "tarball")
        assert done.returncode == 1
        assert file in done.stderr and VERSION in done.stderr
        assert list(tmp_path.glob("*.tar.gz")) == []
    finally:
        git(clone, "reset", "-q", "--hard", "HEAD~")


def test_the_tarball_has_what_is_committed(clone, tmp_path):
    for name in ("one", "two"):
        release(clone, tmp_path / name, "tarball")
    one, two = (tmp_path / name / f"lumbricus-{VERSION}.tar.gz"
                for name in ("one", "two"))
    assert one.read_bytes() == two.read_bytes()
    with tarfile.open(one) as file:
        names = {member.name for member in file.getmembers() if member.isfile()}
    committed = git(clone, "ls-files").splitlines()
    assert names == {f"lumbricus-{VERSION}/{name}" for name in committed}
    said = subprocess.run(["sha256sum", "-c", f"{one.name}.sha256"], cwd=one.parent,
                          text=True, capture_output=True)
    assert said.stdout == f"{one.name}: OK\n"


def test_a_step_that_is_unknown(clone, tmp_path):
    done = release(clone, tmp_path, "tarbal")
    assert done.returncode == 1
    assert "the step 'tarbal' is unknown" in done.stderr


def test_debian_has_what_the_scripts_install():
    control = (PACKAGING / "debian" / "control").read_text()
    needed = re.search(r"^Build-Depends: (.*?)^\S", control, re.S | re.M)[1]
    names = {re.sub(r"\(.*", "", name).strip() for name in needed.split(",")}
    assert listed("build_packages") == names - {"debhelper-compat"}
    rules = (PACKAGING / "debian" / "rules").read_text()
    assert "-DLUMBRICUS_NATIVE=OFF" in rules


def test_the_image_has_what_the_scripts_install():
    image = read("Dockerfile")
    for name in listed("python_packages"):
        assert re.search(rf"[\s]{re.escape(name)}\s", image), name
    assert "scripts/release.sh /packages tarball deb" in image


def test_spack_asks_for_what_cmake_does():
    text = (PACKAGING / "spack" / "packages" / "lumbricus" / "package.py").read_text()
    calls = [(call.func.id, call.args[0].value) for call in ast.walk(ast.parse(text))
             if isinstance(call, ast.Call) and isinstance(call.func, ast.Name)
             and call.args and isinstance(call.args[0], ast.Constant)]
    needs = " ".join(value for name, value in calls if name == "depends_on")
    cmake = read("CMakeLists.txt")
    least = re.search(r"find_package\(deal\.II ([\d.]+)", cmake)[1]
    assert f"dealii@{least}:" in needs
    features = re.search(r"foreach\(feature (.*?)\)", cmake)[1].lower().split()
    for feature in set(features) - {"zlib"}:
        assert f"+{feature}" in needs
    oldest = re.search(r"cmake_minimum_required\(VERSION ([\d.]+)", cmake)[1]
    assert f"cmake@{oldest}:" in needs
    options = re.findall(r"^option\((\w+)", cmake, re.M)
    for name in re.findall(r'"(LUMBRICUS_\w+)"', text):
        assert name in options
