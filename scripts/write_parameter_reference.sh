#!/usr/bin/env bash
# Write doc/parameters.md from what the program itself says of its parameters.
#
#   scripts/write_parameter_reference.sh [--check] [PROGRAM]
#
# PROGRAM is build-Release/lumbricus unless given. With --check nothing is
# written, and the exit code is 1 where the page is stale.
set -euo pipefail

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
page=$repository/doc/parameters.md

check=false
if [ "${1:-}" = --check ]; then
  check=true
  shift
fi
program=${1:-$repository/build-Release/lumbricus}

new=$(mktemp)
trap 'rm -f "$new"' EXIT
"$program" --parameters |
  python3 "$repository/scripts/write_parameter_reference.py" > "$new"

if $check; then
  if ! diff -u "$page" "$new"; then
    echo "doc/parameters.md is stale: run scripts/write_parameter_reference.sh" >&2
    exit 1
  fi
else
  mkdir -p "$(dirname "$page")"
  cp "$new" "$page"
  chmod 644 "$page"
fi
