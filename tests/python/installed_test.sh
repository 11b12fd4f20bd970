#!/usr/bin/env bash
# Usage: installed_test.sh PYTHON FOLDER
# Tests the module as its user gets it: installed in this folder below a prefix, and imported from there alone.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$DELABOLE_BUILD" --component python --prefix "$work/prefix" >"$work/install.log"
cd "$work"
PYTHONPATH=$work/prefix/$2 "$1" -B - <<'PYTHON'
import pathlib

import delabole

folder = pathlib.Path(delabole.__file__).parent
assert "prefix" in folder.parts, folder
assert {"py.typed", "_delabole.pyi", "models.py"} <= {path.name for path in folder.iterdir()}
assert delabole.Coulomb(cohesion="25 kPa", friction_angle="37 deg").cohesion == 25e3
PYTHON
