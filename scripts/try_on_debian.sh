#!/usr/bin/env bash
# Do what the README tells a new user, on a Debian that has nothing but Git.
#
#   scripts/try_on_debian.sh RELEASE [STEP...]
#
# RELEASE is bookworm (Debian 12), trixie (13) or any other that debootstrap
# knows. Makes a bare root of it, clones this checkout into that, as it is
# committed, and runs the steps, all of them unless some are named:
#
#   main_job   scripts/main_job.sh
#   test       scripts/test.sh
#   headers    every header compiled alone
#   deb        the Debian packages, by scripts/release.sh, installed and run
#   sweep      the Python package in an environment of its own, with the program
#              of the Debian package, and the sweep of doc/first-hour.md
#
# Each step leaves a transcript, and all of them the file times.txt, in
# results/debian/RELEASE. A root that is there already is used as it is, so that
# steps can follow one another; remove its folder to begin anew. Needs root and
# debootstrap, some 6 GB and an hour; it is run by hand, not by the tests.
#
# From the environment:
#   DEBIAN_ROOTS         where the roots are made (/var/tmp/lumbricus)
#   DEBIAN_MIRROR        where packages come from (http://deb.debian.org/debian)
#   DEBIAN_CERTIFICATES  a folder with .crt files that the root has to trust too,
#                        as behind a proxy that has a certificate of its own
#   JOBS                 how many compilers run at a time (one per core)
# Proxies (http_proxy and the like) and the settings of pip (PIP_INDEX_URL, ...)
# are handed on.
set -euo pipefail

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
mirror=${DEBIAN_MIRROR:-http://deb.debian.org/debian}

if [ $# -eq 0 ]; then
  echo "Usage: scripts/try_on_debian.sh RELEASE [main_job] [test] [headers] [deb] [sweep]" >&2
  exit 1
fi
release=$1
shift
[ $# -gt 0 ] || set -- main_job test headers
root=${DEBIAN_ROOTS:-/var/tmp/lumbricus}/$release
transcripts=$repository/results/debian/$release

if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap >/dev/null; then
  echo "try_on_debian.sh: needs to be root, and the package debootstrap." >&2
  exit 1
fi

# Seconds since the epoch, to take times with.
now() { date +%s; }

# Run a command in the root, with an environment of its own. What is mounted for
# it is so in a namespace of its own, and gone when it ends, however it does.
in_root()
{
  local handed_on=() name
  for name in http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY \
    "${!PIP_@}"; do
    [ -z "${!name:-}" ] || handed_on+=("$name=${!name}")
  done
  [ -z "${JOBS:-}" ] || handed_on+=("CMAKE_BUILD_PARALLEL_LEVEL=$JOBS")
  unshare --mount --pid --fork --kill-child --propagation private \
    bash -euc '
      root=$1
      shift
      mount -t proc proc "$root/proc"
      mount -t sysfs -o ro sysfs "$root/sys"
      mount --rbind /dev "$root/dev"
      mount -t tmpfs tmpfs "$root/dev/shm"
      exec chroot "$root" /usr/bin/env -i "$@"' in_root "$root" \
    HOME=/root TERM=dumb LANG=C.UTF-8 \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    "${handed_on[@]}" bash -c "$1"
}

make_root()
{
  mkdir -p "$root"
  debootstrap --variant=minbase --include=ca-certificates,git \
    "$release" "$root" "$mirror"
  cp /etc/resolv.conf "$root/etc/resolv.conf"
  # Which a browser and its driver talk by.
  echo "127.0.0.1 localhost" > "$root/etc/hosts"
  if [ -n "${DEBIAN_CERTIFICATES:-}" ]; then
    cp "$DEBIAN_CERTIFICATES"/*.crt "$root/usr/local/share/ca-certificates/"
    in_root update-ca-certificates
  fi
  touch "$root/is_complete"
}

# Run a step, with its words in a transcript and its time in times.txt.
try()
{
  local step=$1 start status=0
  start=$(now)
  in_root "cd /root/lumbricus && $2" 2>&1 | tee "$transcripts/$step.txt" \
    || status=$?
  echo "$step: $(($(now) - start)) s, exit code $status," \
    "load $(cut -d ' ' -f 1-3 /proc/loadavg) at its end" \
    | tee -a "$transcripts/times.txt"
  return $status
}

mkdir -p "$transcripts"
if [ ! -e "$root/is_complete" ]; then
  start=$(now)
  make_root
  echo "root: $(($(now) - start)) s" | tee -a "$transcripts/times.txt"
fi

# In the root: the packages that the tarball gives, installed and run. What is to
# be built with comes from packaging/debian alone.
packages_of_debian='set -e
export DEBIAN_FRONTEND=noninteractive JOBS=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
apt-get update -q && apt-get install -y -q --no-install-recommends dpkg-dev
apt-get build-dep -y -q --no-install-recommends "$PWD/packaging"
scripts/release.sh /root/release deb
apt-get install -y -q --no-install-recommends /root/release/lumbricus_*.deb
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
cd /tmp && mpirun -np 2 lumbricus /usr/share/doc/lumbricus/examples/antagonism/case.prm \
  --output /root/antagonism --set Output/Every=0 --set Time/End=0.5'

# The commands of doc/first-hour.md, as they are there: lines that begin with a
# dollar sign, and the file that one of them makes.
sweep_of_the_first_hour='set -e
apt-get install -y -q --no-install-recommends python3 python3-venv libegl1 libgl1-mesa-dri
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 MPLBACKEND=Agg
rm -rf try results/amplitudes
python3 -m venv try
try/bin/pip install -q --disable-pip-version-check "./python[fields]"
sed -n "/^    import lumbricus/,/savefig/s/^    //p" doc/first-hour.md > waves.py
cat waves.py
for i in 1 2; do
  begin=$(date +%s.%N)
  try/bin/python waves.py
  python3 -c "import sys; print(f\"{float(sys.argv[2]) - float(sys.argv[1]):.1f} s\")" \
    "$begin" "$(date +%s.%N)"
done
try/bin/lumbricus-plot results/amplitudes/$(ls results/amplitudes | grep -v "[.]" | head -1)'

# As git clone gives it, but from here; build folders that are there stay.
revision=$(git -C "$repository" rev-parse HEAD)
[ -e "$root/root/lumbricus" ] || git clone -q "$repository" "$root/root/lumbricus"
git -C "$root/root/lumbricus" fetch -q "$repository" HEAD
git -C "$root/root/lumbricus" checkout -q --force "$revision"
echo "revision $revision, $(nproc) cores, $(date -u)" >> "$transcripts/times.txt"

for step in "$@"; do
  case $step in
    main_job)
      try main_job scripts/main_job.sh
      cp "$root/root/lumbricus/results/peristalsis/segments.csv" "$transcripts/"
      ;;
    test) try test scripts/test.sh ;;
    headers) try headers "cmake --build build-Release --target headers" ;;
    deb) try deb "$packages_of_debian" ;;
    sweep) try sweep "$sweep_of_the_first_hour" ;;
    *)
      echo "try_on_debian.sh: the step '$step' is unknown." >&2
      exit 1
      ;;
  esac
done
