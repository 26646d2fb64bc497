#!/usr/bin/env bash
# Make a release of what is committed, and try it.
#
#   scripts/release.sh FOLDER [STEP...]
#
# Runs the steps, all of them unless some are named, and leaves what they make in
# FOLDER:
#
#   tarball   lumbricus-VERSION.tar.gz, after a look at whether all agree on the
#             version, and at its section in CHANGELOG.md
#   build     what is in the tarball, built and installed in a folder of its own,
#             with the Python package beside it: a short run of both
#   deb       the packages lumbricus and liblumbricus-dev, by packaging/debian out
#             of the tarball
#
# 'build' and 'deb' each compile the program once, with JOBS compilers at a time (one
# a core). 'deb' needs the Debian packages debhelper and dpkg-dev, and those of
# Build-Depends. Nothing of the checkout is changed.
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

if [ $# -eq 0 ]; then
  echo "Usage: scripts/release.sh FOLDER [tarball] [build] [deb]" >&2
  exit 1
fi
mkdir -p "$1"
folder=$(cd "$1" && pwd)
shift
[ $# -gt 0 ] || set -- tarball build deb
jobs=${JOBS:-$cores}

fail()
{
  echo "release.sh: $*" >&2
  exit 1
}

# A file as it is committed.
committed() { git -C "$repository" show "HEAD:$1"; }

# The version is that of CMakeLists.txt.
version=$(committed CMakeLists.txt | sed -n 's/^project(lumbricus VERSION \([0-9.]*\).*/\1/p')
[ -n "$version" ] || fail "CMakeLists.txt has no version."
name=lumbricus-$version
tarball=$folder/$name.tar.gz

# The date of the version in CHANGELOG.md.
date_of_version()
{
  committed CHANGELOG.md | sed -n "s/^## \[${version//./\\.}\] - \([0-9-]*\)\$/\1/p"
}

make_tarball()
{
  local file
  for file in CITATION.cff codemeta.json python/pyproject.toml; do
    committed "$file" | grep -Eq "^ *\"?version\"?( =|:) \"?${version//./\\.}\"?,?\$" \
      || fail "$file has another version than CMakeLists.txt, which has $version."
  done
  [ -n "$(date_of_version)" ] \
    || fail "CHANGELOG.md has no line '## [$version] - YYYY-MM-DD'."
  # gzip without the time, so that the same commit gives the same file.
  git -C "$repository" archive --format=tar --prefix="$name/" HEAD \
    | gzip -9n > "$tarball"
  (cd "$folder" && sha256sum "$name.tar.gz" > "$name.tar.gz.sha256")
}

# The tarball, unpacked in a new folder.
unpack()
{
  [ -e "$tarball" ] || make_tarball
  rm -rf "$1"
  mkdir -p "$1"
  tar -xzf "$tarball" -C "$1"
}

try_build()
{
  local place=$folder/build
  unpack "$place"
  cmake -S "$place/$name" -B "$place/built" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DLUMBRICUS_DEBUG_INFO=OFF -DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON \
    -DCMAKE_INSTALL_PREFIX="$place/installed"
  cmake --build "$place/built" -j "$jobs"
  cmake --install "$place/built"
  /usr/bin/python3 -m venv "$place/python"
  "$place/python/bin/pip" install -q --disable-pip-version-check "$place/$name/python"
  (cd "$place" && LUMBRICUS=$place/installed/bin/lumbricus python/bin/python - "$name" <<'END'
import sys
import lumbricus
run = lumbricus.Case(f"{sys.argv[1]}/parameters/antagonism/case.prm",
                     {"Time/End": 0.1, "Output/Every": 0}).run("trial", ranks=2)
print(run.segments[["t", "length", "fluid_pressure"]])
END
  )
}

make_deb()
{
  local place=$folder/deb
  unpack "$place"
  cp -r "$place/$name/packaging/debian" "$place/$name/debian"
  cat > "$place/$name/debian/changelog" <<END
lumbricus ($version) unstable; urgency=medium

  * Release $version: see CHANGELOG.md.

 -- The Lumbricus developers <lumbricus@localhost>  $(date -R -u -d "$(date_of_version)")
END
  (cd "$place/$name" && DEB_BUILD_OPTIONS="noautodbgsym parallel=$jobs" \
    dpkg-buildpackage -us -uc -b)
  cp "$place"/*.deb "$folder"
}

for step in "$@"; do
  case $step in
    tarball) make_tarball ;;
    build) try_build ;;
    deb) make_deb ;;
    *) fail "the step '$step' is unknown." ;;
  esac
done
(cd "$folder" && ls -l *.tar.gz *.deb 2>/dev/null) || true
