#!/usr/bin/env bash
# Measures Tia beside its yardsticks in one run and prints ratios, which drift less than times do
# between runs and machines. Takes two minutes; run it on a machine that does nothing else.
# Embree, where it is installed (apt-get install libembree-dev), traces the same rays beside Tia's
# index, and gnuplot (gnuplot-nox) draws that, into build/release/rays.svg: two minutes. POV-Ray and
# Tachyon (povray tachyon) trace the scenes of peers/ beside it, which takes ten minutes more, and
# POV-Ray surfaces from formulas: three minutes. Blender's Cycles (blender) follows the same paths
# as Tia: an hour, with --cycles only.
# Options: --quick: fewer repetitions, smaller pictures; --no-peers: Tia alone; --cycles.
set -euo pipefail
rounds=9
peers=(tests/bench/peers/compare.py)
formulas=(tests/bench/peers/formulas.py)
rays=(tests/bench/peers/rays.py --svg build/release/rays.svg)
cycles=(true)
quick=()
for option in "$@"; do
  case $option in
    --quick) rounds=3 quick=(--quick) peers+=(--quick) formulas+=(--quick) rays+=(--quick) ;;
    --no-peers) peers=(true) formulas=(true) rays=(true) ;;
    --cycles) cycles=(tests/bench/peers/cycles.py --svg build/release/cycles.svg) ;;
    *) echo "unknown option $option; there are --quick, --no-peers and --cycles" >&2 && exit 2 ;;
  esac
done
ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$ROOT"
. server/setup.sh
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

{
  install_missing build
  install_missing bench
  cmake --preset release -DTIA_BENCH=ON
  cmake --build --preset release --target tia tia_bench tia_rays
} > "$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }

# Lines "NAME VALUE", times in ms.
measured=$scratch/measured
note() { echo "$1 $2" >> "$measured"; }
value() { awk -v name="$1" '$1 == name { print $2 }' "$measured"; }
median() { sort -n | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }
repeat() {
  local i
  for ((i = 0; i < rounds; i++)); do "$@"; done | median
}

# The medians of all repetitions as trace:640:480:1 and the like, counters after a point. The
# library writes JSON with one member a line.
benchmarks() {
  build/release/tests/tia_bench --benchmark_filter="-^(index|exact|moving)_" \
    --benchmark_repetitions="$rounds" --benchmark_min_time=0.1 \
    --benchmark_enable_random_interleaving=true --benchmark_report_aggregates_only=true \
    --benchmark_format=json 2> "$scratch/log" |
    awk -F '"' '
      { number = $3; gsub(/[:, ]/, "", number) }
      $2 == "run_name" {
        name = $4
        gsub(/\/(real_time|iterations:[0-9]+)/, "", name)
        gsub(/\/[a-z]+:/, ":", name)
      }
      $2 == "aggregate_name" { wanted = $4 == "median" }
      wanted && $2 == "real_time" { print name, number / 1e6 }
      wanted && $2 ~ /^(bytes|median_ms|p99_ms|work_ms|rays|processors)$/ { print name "." $2, number }
    ' >> "$measured"
}

# From the start of the process to the first picture's last byte, and the memory that it rests at.
start() {
  local from url pid
  from=$(date +%s%N)
  coproc build/release/tia serve --port 0 2> "$scratch/log"
  pid=$COPROC_PID
  read -r url <&"${COPROC[0]}"
  curl -s -o /dev/null "${url##* }/render?key=a"
  echo $((($(date +%s%N) - from) / 1000)) | awk '{ print $1 / 1000 }'
  awk '/VmRSS/ { print $2 / 1024 }' "/proc/$pid/status" > "$scratch/rss"
  kill "$pid"
  wait "$pid"
}

row() {  # row WHAT VALUE UNIT RATIO-OF TO TARGET
  awk -v what="$1" -v value="$2" -v unit="$3" -v yard="$4" -v name="$5" -v target="$6" 'BEGIN {
    if (value == "" || yard == "") { printf "| %s | not measured | | %s |\n", what, target; exit }
    printf "| %s | %.4g %s | %.3g x %s | %s |\n", what, value, unit, value / yard, name, target }'
}

per_ray() {
  echo "$(value "many_balls:$1") $(value "many_balls:$1.rays")" |
    awk '{ printf "%.3g", 1e6 * $1 / $2 }'
}

table() {
  local trace1 trace2 base png stb bound
  trace1=$(value trace:640:480:1) trace2=$(value trace:640:480:2) base=$(value baseline)
  png=$(value png:640:480) stb=$(value png_of_stb)
  bound=$(value key_to_png.work_ms | awk '{ print 1.5 * $1 + 0.5 }')
  echo "| what | measured | ratio | target |"
  echo "|---|---:|---:|---:|"
  row "tracing, 2 threads" "$trace2" ms "$base" "scalar baseline ($base ms)" "1/6 = 0.167"
  row "tracing, 1 thread" "$trace1" ms "$base" "scalar baseline" ""
  row "tracing 1920x1080, 2 threads" "$(value trace:1920:1080:2)" ms "$trace2" "640x480" "7.5"
  row "PNG" "$png" ms "$stb" "stb_image_write as it comes ($stb ms)" "1/4"
  row "PNG" "$(value png:640:480.bytes)" bytes "$(value png_of_stb.bytes)" "stb's" "1"
  row "PNG 1920x1080 in strips, 1 thread" "$(value png_in_strips:1)" ms "$(value png:1920:1080)" \
    "as a whole ($(value png:1920:1080) ms)" "1"
  row "PNG 1920x1080 in strips, 2 threads" "$(value png_in_strips:2)" ms \
    "$(value png:1920:1080)" "as a whole" ""
  row "the same" "$(value png_in_strips:2.bytes)" bytes "$(value png:1920:1080.bytes)" \
    "as a whole" "1.1"
  row "key to PNG, keep-alive, median" "$(value key_to_png.median_ms)" ms "$bound" \
    "1.5 (tracing + PNG) + 0.5 ms" "1"
  row "key to PNG, keep-alive, 99 %" "$(value key_to_png.p99_ms)" ms \
    "$(value key_to_png.median_ms)" "median" "2"
  row "10 000 balls, one thread" "$(per_ray 10000)" "ns a ray" "$(per_ray 100)" \
    "that of 100 balls ($(per_ray 100) ns)" "3"
  row "every shape, 2 threads" "$(value every_shape:1)" ms "$trace2" "the thesis' picture" ""
  row "the same, 64 rays a pixel" "$(value every_shape:64)" ms \
    "$(value every_shape:1)" "one ray a pixel" ""
  row "processors that it uses" "$(value every_shape:64.processors)" "" 2 "both" "0.95"
  row "start to first picture" "$(value start)" ms 200 "200 ms" "1"
  row "memory after it" "$(value rss)" MiB 30 "30 MiB" "1"
}

benchmarks || { cat "$scratch/log"; exit 1; }
note start "$(repeat start)"
note rss "$(cat "$scratch/rss")"
grep -m 1 'model name' /proc/cpuinfo | sed 's/.*: //'
table
echo
"${rays[@]}" || echo "No comparison with Embree, or not with equal hits."
echo
"${peers[@]}" || echo "No comparison with POV-Ray and Tachyon, or not with equal pictures."
echo
"${formulas[@]}" || echo "No comparison of formulas, or unequal pictures, or a target missed."
echo
"${cycles[@]}" "${quick[@]}" || echo "No comparison with Cycles, or not with equal light."
