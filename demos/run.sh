#!/bin/bash
# run.sh: installs what is missing, builds the raster command, and renders real models into out/.
#
#   bash demos/run.sh                  the models
#   bash demos/run.sh gallery          the figures of the lectures, with curves, into out/gallery/
#   bash demos/run.sh gallery --docs   the same in small, for docs/gallery.md
#   bash demos/run.sh bench [OPTION]   times this library against llvmpipe, frame by frame; --help lists the options
set -euo pipefail
cd "$(dirname "$0")/.."
. demos/setup.sh

demo=${1:-models}
case $demo in
    models | gallery | bench) ;;
    *)
        echo "usage: bash demos/run.sh [models | gallery [--docs] | bench [OPTION...]]" >&2
        exit 2
        ;;
esac
[ $# -eq 0 ] || shift

# The pictures are the same with any instruction set; these come faster.
march=
if has_x86_64_v3; then march=x86-64-v3; fi
if has_x86_64_v4; then march=x86-64-v4; fi

. "demos/$demo.sh"
