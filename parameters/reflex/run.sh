#!/usr/bin/env bash
# The case with its controller, on two ranks; tables and plots go to results/reflex.
# With arguments, as --set NAME=VALUE, the run has these.
exec "$(dirname "${BASH_SOURCE[0]}")/../../scripts/run_with_controller.sh" reflex "$@"
