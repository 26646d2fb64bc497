#!/usr/bin/env bash
# Write the documentation as a site, FOLDER/index.html: the Markdown files of this
# checkout, notebooks, and the classes of the Python package. It needs no network, and
# fails on a warning or on a link that leads nowhere.
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

if [ $# -ne 1 ]; then
  echo "Usage: scripts/write_site.sh FOLDER" >&2
  exit 1
fi
install_missing "${python_packages[@]}"
set_up_python
"$python" "$repository/doc/site/write.py" "$1"
