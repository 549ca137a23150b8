#!/bin/bash
# run.sh: installs what is missing, builds the raster command, and renders a gallery of models into out/.
#
#   bash demos/run.sh             the gallery
#   bash demos/run.sh gallery     the same
#   bash demos/run.sh bench       times the drawing, if the benchmark is there
set -euo pipefail
cd "$(dirname "$0")/.."
. demos/setup.sh

demo=${1:-gallery}
if [ ! -f "demos/$demo.sh" ] || [ "$demo" = run ] || [ "$demo" = setup ]; then
    echo "usage: bash demos/run.sh [DEMO]; the demos are:" >&2
    find demos -name '*.sh' ! -name run.sh ! -name setup.sh -printf '  %f\n' | sed 's/\.sh$//' | sort >&2
    exit 2
fi

install_packages "${build_packages[@]}" "${model_packages[@]}"
preset=release
if has_x86_64_v3; then preset=native; fi
configure_and_build "$preset" -DRASTER_BUILD_TESTS=OFF
. "demos/$demo.sh"
