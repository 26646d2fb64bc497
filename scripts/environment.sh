# Sourced by the other scripts: install what is missing, and what mpirun and
# the BLAS need to know. Debian 12 or 13, or Ubuntu.
set -euo pipefail

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# nproc heeds OMP_NUM_THREADS, which says nothing of the ranks.
cores=$(env -u OMP_NUM_THREADS -u OMP_THREAD_LIMIT nproc)

# Install the packages named that are not installed yet.
install_missing()
{
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null \
      | grep -q 'install ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  echo "Installing: ${missing[*]}"
  local as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -q --no-install-recommends "${missing[@]}"
}

# Build target $2, or all, of type $1 in build-$1, with the options that follow.
build()
{
  local folder="$repository/build-$1"
  cmake -S "$repository" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE="$1" \
    -DLUMBRICUS_DEBUG_INFO=OFF "${@:3}"
  cmake --build "$folder" --target "${2:-all}"
}

# The Python of everything that draws or tests, with the packages of
# requirements.txt; made anew where that or Debian's Python has changed.
python="$repository/.venv/bin/python"
set_up_python()
{
  local wanted="$repository/scripts/requirements.txt"
  local installed="$repository/.venv/requirements.txt"
  "$python" -c "import numpy" 2>/dev/null \
    && cmp -s "$wanted" "$installed" && return
  echo "Installing the packages of scripts/requirements.txt in .venv"
  /usr/bin/python3 -m venv --clear "$repository/.venv"
  "$python" -m pip install -q --disable-pip-version-check -r "$wanted"
  cp "$wanted" "$installed"
}

build_packages=(g++ cmake ninja-build libdeal.ii-dev libmumps-dev
  libopenblas0-serial openmpi-bin)
# The last two let VTK draw without a screen, in software.
python_packages=(python3 python3-venv libegl1 libgl1-mesa-dri)
test_packages=(libgtest-dev numdiff doxygen)
# A browser shows the scene of a report. Ubuntu has it as a snap only, which containers
# cannot start: there that test is left out.
if grep -qx "ID=debian" /etc/os-release 2>/dev/null; then
  test_packages+=(chromium chromium-driver)
fi

# Open MPI refuses to start for root, as in containers, without the first two,
# and more ranks than cores without the third; without the last, runs side by
# side would all be bound to the same cores. Open MPI 5, as in Debian 13, has
# other names for these, those of its launcher PRRTE.
if [ "$(id -u)" -eq 0 ]; then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi
export OMPI_MCA_rmaps_base_oversubscribe=1
export PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe
export OMPI_MCA_hwloc_base_binding_policy=none
export PRTE_MCA_hwloc_default_binding_policy=none
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
