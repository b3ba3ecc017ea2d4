#!/usr/bin/env bash
# Installs what is missing, builds Tia in every way that matters and runs every test. A step that
# fails does not stop the next one. The last line of output is "N passed, N failed".
set -euo pipefail
ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$ROOT"
. server/setup.sh

passed=0
failed=0
running=()
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

title() { printf '\n== %s (%d s)\n' "$1" "$SECONDS"; }
pass() { passed=$((passed + 1)); }
fail() {
  failed=$((failed + 1))
  echo "FAILED: $*"
}

# show FILE: an output but for the tests that pass.
show() {
  sed -E '/^(\[ RUN|\[       OK|\[---|ok |# Subtest|  ---|  duration_ms|  \.\.\.|$)/d' "$1"
}

# run NAME COMMAND...: keeps the output in $scratch/log, leaves the exit status in $status.
run() {
  title "$1"
  status=0
  timeout 600 "${@:2}" > "$scratch/log" 2>&1 || status=$?
  show "$scratch/log"
}

# count NAME PASSED FAILED: books a step. A step that broke without a failed test is one failure.
count() {
  local good=${2:-0} bad=${3:-0}
  passed=$((passed + good))
  failed=$((failed + bad))
  if [ "$bad" -gt 0 ]; then
    echo "FAILED: $1: $bad of $((good + bad))"
  elif [ "$status" -ne 0 ] || [ "$good" -eq 0 ]; then
    fail "$1: exit status $status, $good tests passed"
  fi
}

last_match() { sed -nE "s/$1/\\1/p" "$scratch/log" | tail -n 1; }

# build PRESET [CMAKE OPTION...] -- TARGET...
build() {
  local preset=$1 options=()
  shift
  while [ "$1" != -- ]; do options+=("$1") && shift; done
  shift
  title "build $preset"
  if ! cmake --preset "$preset" "${options[@]}" > "$scratch/log" 2>&1; then
    cat "$scratch/log"
  elif cmake --build --preset "$preset" --target "$@"; then
    return 0
  fi
  fail "build $preset"
  return 1
}

# The sanitizers of older compilers cannot live with much address space randomisation.
fixed_addresses=()
if setarch -R true 2>/dev/null; then fixed_addresses=(setarch -R); fi

# finish SHARE: waits for it, keeps its output in $scratch/log, leaves its exit status in $status.
finish() {
  status=0
  wait "${running[$1]}" || status=$?
  mv "$scratch/shard$1" "$scratch/log"
  show "$scratch/log"
}

# googletest PRESET PROGRAM: as many shares of the tests at once as there are processors.
googletest() {
  local shards shard total good skipped
  shards=$(nproc)
  title "$1 $2"
  for ((shard = 0; shard < shards; ++shard)); do
    GTEST_TOTAL_SHARDS=$shards GTEST_SHARD_INDEX=$shard timeout 600 \
      "${fixed_addresses[@]}" "build/$1/tests/$2" > "$scratch/shard$shard" 2>&1 &
    running[shard]=$!
  done
  for ((shard = 0; shard < shards; ++shard)); do
    finish "$shard"
    total=$(last_match '^\[==========\] ([0-9]+) tests? from .* ran.*')
    good=$(last_match '^\[  PASSED  \] ([0-9]+) tests?.*')
    skipped=$(last_match '^\[  SKIPPED \] ([0-9]+) tests?.*')
    [ -n "$total" ] || echo "Broke off in $(last_match '^\[ RUN      \] (.*)')"
    count "$1 $2, share $((shard + 1))" "$good" $((${total:-0} - ${good:-0} - ${skipped:-0}))
  done
}

# same_bytes: another compiler and instruction set render the same pictures.
same_bytes() {
  local key format options
  title "release and portable render the same bytes"
  for key in none a d s w; do
    options=()
    [ "$key" = none ] || options+=(--key "$key")
    for format in png pfm; do same_picture "$key.$format" thesis "${options[@]}"; done
  done
  for options in thesis normal depth albedo object shadow cost; do
    same_picture "$options.pfm" shapes --integrator "$options"
  done
  same_picture samples.pfm shapes --samples 5 --seed 7
  same_picture threshold.pfm shapes --threshold 0.05
  same_picture lens.pfm shapes --samples 3 --camera '{"aperture": 1, "focus_distance": 12}'
  same_picture parallel.pfm shapes \
    --camera '{"projection": "orthographic", "height": 9, "fov_degrees": null}'
  stated_hashes
}

# stated_hashes: portable draws the whole gallery, at the hashes that the tests hold release to.
stated_hashes() {
  local name
  for name in $(sed -nE 's/^[0-9a-f]+  (.*)\.pfm$/\1/p' tests/golden/gallery.sha256); do
    build/portable/tia render "$name" --width 160 --height 120 -o "$scratch/$name.pfm" || true
    if grep " $name.pfm" tests/golden/gallery.sha256 | (cd "$scratch" && sha256sum -c); then pass
    else fail "same bytes: the gallery's $name"; fi
  done
}

# same_picture FILE SCENE OPTION...: both builds make the same file.
same_picture() {
  local preset
  for preset in release portable; do
    "build/$preset/tia" render "${@:2}" --width 320 --height 240 -o "$scratch/$preset-$1" || true
  done
  if cmp "$scratch/release-$1" "$scratch/portable-$1"; then pass; else fail "same bytes: $1"; fi
}

# old_processor: on one without AVX, release says so and exits 2; portable renders the same bytes.
old_processor() {
  local old=(qemu-x86_64 -cpu Nehalem) picture=(--width 32 --height 24 --key a)
  title "on an old processor"
  status=0
  "${old[@]}" build/release/tia render thesis -o "$scratch/old.png" 2> "$scratch/log" || status=$?
  if [ "$status" = 2 ] && grep -q 'lacks:.* avx2' "$scratch/log"; then pass; else
    cat "$scratch/log"
    fail "release on an old processor: exit status $status"
  fi
  "${old[@]}" build/portable/tia render thesis "${picture[@]}" -o "$scratch/old.png" || true
  build/release/tia render thesis "${picture[@]}" -o "$scratch/new.png" || true
  if cmp "$scratch/old.png" "$scratch/new.png"; then pass; else fail "old processor: same bytes"; fi
}

# fuzz: each fuzzer for FUZZ_SECONDS, from the seeds on. What breaks it stays in build/asan. What is
# not text by nature may be long: a kilobyte of a picture unpacks to a megabyte.
fuzz() {
  local name longest
  for name in request scene query formula picture; do
    mkdir -p "$scratch/$name"
    longest=4096
    if [ "$name" = picture ] || [ "$name" = request ]; then longest=65536; fi
    run "fuzz $name" "build/asan/tests/${name}_fuzz" -max_total_time="${FUZZ_SECONDS:-10}" \
      -max_len="$longest" -timeout=5 -rss_limit_mb=2048 -verbosity=0 -artifact_prefix=build/asan/ \
      "$scratch/$name" "tests/fuzz/corpus/$name"
    if [ "$status" = 0 ]; then pass; else fail "fuzz $name"; fi
  done
}

# node_tests FOLDER: the tests of a folder that has its own packages, as many shares of its files
# at once as there are processors.
node_tests() {
  local name=$1 folder=tests/$1 all=(tests/"$1"/*.test.mjs) shards shard files good bad cancelled
  title "$name packages"
  if [ ! "$folder/node_modules/.package-lock.json" -nt "$folder/package-lock.json" ]; then
    npm ci --prefix "$folder" --no-audit --no-fund || true
  fi
  shards=$(nproc)
  if [ "$shards" -gt "${#all[@]}" ]; then shards=${#all[@]}; fi  # without a file node runs them all
  title "$name"
  for ((shard = 0; shard < shards; ++shard)); do
    mapfile -t files < <(printf '%s\n' "${all[@]}" | awk -v n="$shards" -v i="$shard" 'NR % n == i')
    TIA=$ROOT/build/release/tia timeout 600 node --test --test-reporter=tap "${files[@]}" \
      > "$scratch/shard$shard" 2>&1 &
    running[shard]=$!
  done
  for ((shard = 0; shard < shards; ++shard)); do
    finish "$shard"
    good=$(last_match '^# pass ([0-9]+)')
    bad=$(last_match '^# fail ([0-9]+)')
    cancelled=$(last_match '^# cancelled ([0-9]+)')
    count "$name, share $((shard + 1))" "$good" $((${bad:-0} + ${cancelled:-0}))
  done
}

title "set-up"
install_missing build || fail "installing the build's packages"
install_missing test || fail "installing the tests' packages"

release=no
if build release -DTIA_WERROR=ON -DTIA_TESTS=ON -- all; then
  release=yes
  googletest release core_tests
  googletest release server_tests
  googletest release memory_tests
  node_tests browser
  node_tests deploy
fi
if build portable -DTIA_WERROR=ON -- tia && [ $release = yes ]; then
  same_bytes
  if [ "$(uname -m) $(sed -n 's/^TIA_ARCH:.*=//p' build/release/CMakeCache.txt)" = "x86_64 x86-64-v3" ]; then
    old_processor
  fi
fi
# The tests are those that release has compiled: what they watch are the libraries.
if build asan -DTIA_TESTS_OF="$ROOT/build/release" -- core_tests server_tests \
  memory_tests request_fuzz scene_fuzz query_fuzz formula_fuzz picture_fuzz; then
  googletest asan core_tests
  googletest asan server_tests
  googletest asan memory_tests
  fuzz
fi
if build tsan -- server_tests; then
  googletest tsan server_tests
fi

title "done"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
