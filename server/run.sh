#!/usr/bin/env bash
# Installs what is missing, builds Tia and starts the server; arguments go to `tia serve`.
# Run it as often as you like: what is done already is not done again.
set -euo pipefail
ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$ROOT/server/setup.sh"

{
  install_missing build
  [ -f "$ROOT/build/release/build.ninja" ] || (cd "$ROOT" && cmake --preset release -DTIA_TESTS=OFF)
  cmake --build "$ROOT/build/release" --target tia
} >&2
exec "$ROOT/build/release/tia" serve "$@"
