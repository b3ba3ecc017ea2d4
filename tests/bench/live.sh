#!/usr/bin/env bash
# live.sh [PROGRAM]: what a live film of the thesis' scene takes of a processor: 640 x 480, 30 pictures
# a second asked for, four seconds. Times of the process, so that others' load does not matter.
set -euo pipefail
ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
tia=${1:-$ROOT/build/release/tia}
coproc SERVER { exec "$tia" serve --port 0 2>/dev/null; }
pid=$SERVER_PID
trap 'kill $pid' EXIT
read -r line <&"${SERVER[0]}"
base=${line##* }

# cpu_ms: user and system time of the server so far.
cpu_ms() { awk -v hz="$(getconf CLK_TCK)" '{print ($14 + $15) * 1000 / hz}' "/proc/$pid/stat"; }

# film PARAMETERS: asks for it, and says what came.
film() {
  local before after shown
  before=$(cpu_ms)
  shown=$(curl -sN "$base/film?scene=lamp-round&width=640&height=480&fps=30&to=4&$1" |
          grep -ac "^Tia-Frame: " || true)
  after=$(cpu_ms)
  awk -v n="$shown" -v ms="$(awk -v a="$before" -v b="$after" 'BEGIN {print b - a}')" -v what="$1" \
    'BEGIN {printf "%s: %d of 120 pictures shown, %.1f ms of a processor each\n", what, n, n ? ms / n : 0}'
}
film format=mjpeg
film 'format=mjpeg&samples=4'
