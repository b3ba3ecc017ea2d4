# shellcheck shell=bash
# The steps of tests/run.sh, which sources this file: the table of them, and a function each, which
# books what passed and failed with pass, fail and count.

# name | in which run | which come first | what it protects
steps=(
  'style      | change |                  | the layout of the text; and lint in what is not committed yet'
  'release    | change |                  | what ships, all tests and the measurements compile without a warning'
  'core       | change | release          | the tracer: closed forms, statistics, the gallery to the byte, the architecture'
  'server     | change | release          | HTTP, limits, fairness, overload, restarts: the program over real sockets'
  'memory     | change | release          | every allocation may fail'
  'page       | change | release          | the page in headless Chromium: keys, drags, errors, widths, accessibility'
  'deploy     | change | release          | balancer, manifests, image'
  'pages      | change | release          | the README.md of every folder: commands, tables, links'
  'portable   | full   |                  | another compiler builds it, for any x86-64 processor'
  'same-bytes | full   | release portable | both draw the same bytes'
  'old        | full   | release portable | processors without AVX get a message, or the same bytes'
  'asan       | full   | release          | no wrong address, no leak, no undefined behaviour in all the tests'
  'coverage   | full   | asan             | the tests run nearly every line of core and server'
  'fuzz       | full   | asan             | whatever the bytes, no reader breaks'
  'tsan       | full   |                  | no data race in the server'
  'arm64      | full   |                  | a processor of another kind draws the same bytes'
)
# reads_of NAME: the paths that a step's tests are made of, where it need not run again while they
# and the packages are as they were.
reads_of() {
  case $1 in
    server) echo 'core server web tests' ;;
    core | memory) echo 'core server web tests :!tests/browser :!tests/deploy :!tests/pages :!*.md' ;;
    page) echo 'core server web tests/browser tests/pages :!*.md' ;;
    deploy) echo '. :!tests :!*.md tests/deploy' ;;
    pages) echo '.' ;;
  esac
}
is_build() { [[ $1 =~ ^(release|portable|asan)$ ]]; }

# ---- what steps are made of -----------------------------------------------------------------------

# build PRESET [CMAKE OPTION...] -- TARGET...
build() {
  local preset=$1 options=()
  shift
  await_ahead
  while [ "$1" != -- ]; do options+=("$1") && shift; done
  shift
  if ! cmake --preset "$preset" "${options[@]}" > "$scratch/log" 2>&1; then
    cat "$scratch/log"
  elif ninja -C "build/$preset" -t cleandead > /dev/null &&
    cmake --build --preset "$preset" --target "$@"; then
    pass
    return 0
  fi
  fail "build $preset"
  return 1
}

# ahead PRESET...: begins to build those of them whose steps are to come, of the time that processors
# have while a step waits for browsers or limits of time, until one builds again. Their own steps
# build what is left, and tell what is wrong.
ahead() {
  local preset presets=()
  for preset in "$@"; do
    if [[ " ${chosen[*]} " = *" $preset "* ]]; then presets+=("$preset"); fi
  done
  if [ ${#presets[@]} = 0 ] || [ -n "$being_built" ]; then return 0; fi
  set -m  # for a process group of its own
  build_behind "${presets[@]}" > /dev/null 2>&1 &
  set +m
  being_built=$!
}
build_behind() {
  local preset scratch=$scratch/ahead  # its logs are not those of the step
  mkdir -p "$scratch"
  renice -n 19 -p "$BASHPID"
  for preset in "$@"; do "build_$preset"; done
}
being_built=
await_ahead() {
  if [ -z "$being_built" ]; then return; fi
  local -a all
  mapfile -t all < <(family "$being_built")
  renice -n "$(nice)" "${all[@]}" > /dev/null 2>&1 || true  # now it is what is waited for
  wait "$being_built" || true
  being_built=
}
# signal_ahead SIGNAL: to each of those that build ahead, for ninja gives each compiler a group of its
# own; and again, for those begun meanwhile.
signal_ahead() {
  local -a all
  if [ -z "$being_built" ]; then return; fi
  for _ in 1 2; do
    mapfile -t all < <(family "$being_built")
    kill -s "$1" "${all[@]}" 2> /dev/null || true
  done
}
# family PROCESS: it, and all that it has begun, and they.
family() {
  local child
  echo "$1"
  for child in $(cat /proc/"$1"/task/*/children 2> /dev/null); do family "$child"; done
}
leave_ahead() { signal_ahead TERM && signal_ahead CONT; }

# show FILE: an output but for the tests that pass.
show() {
  sed -E '/^ *(\[ RUN|\[       OK|\[---|ok |# Subtest|---|duration_ms|\.\.\.|[0-9]+\.\.[0-9]+|$)/d' "$1"
}

last_match() { sed -nE "s/$1/\\1/p" "$scratch/log" | tail -n 1; }

# count NAME PASSED FAILED: books tests. A program that broke without a failed one is one failure.
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

# in_shares SHARES KIND ARGUMENT...: runs KIND_share SHARE ARGUMENT... for all shares at once, then
# KIND_count SHARE ARGUMENT... for each, with its output in $scratch/log and its exit status in $status.
in_shares() {
  local shares=$1 kind=$2 share running=()
  for ((share = 0; share < shares; ++share)); do
    "${kind}_share" "$share" "${@:3}" > "$scratch/share$share" 2>&1 &
    running[share]=$!
  done
  for ((share = 0; share < shares; ++share)); do
    status=0
    wait "${running[share]}" || status=$?
    mv "$scratch/share$share" "$scratch/log"
    show "$scratch/log"
    "${kind}_count" "$share" "${@:3}"
  done
}

# The sanitizers of older compilers cannot live with much address space randomisation.
fixed_addresses=()
if setarch -R true 2>/dev/null; then fixed_addresses=(setarch -R); fi

# googletest PRESET PROGRAM [WAITING MEASURING]: as many shares of the tests at once as there are
# processors; and as many more of those that match WAITING, which use none. Then those that match
# MEASURING, alone: what is built ahead stands still.
googletest() {
  in_shares $(($(nproc) * ${3:+2*}1)) googletest "$@"
  [ -n "${4:-}" ] || return 0
  signal_ahead STOP
  in_shares 1 alone "$@"
  signal_ahead CONT
}
emulator=()  # that it runs in
googletest_share() {
  local processors filter=${4:+-$4:$5}
  processors=$(nproc)
  if [ "$1" -ge "$processors" ]; then filter=$4; fi
  test_program $(($1 % processors)) "$processors" "${filter:-*}" "${@:2}"
}
alone_share() { test_program 0 1 "$5" "${@:2}"; }
alone_count() { googletest_count "$@"; }
# test_program SHARE SHARES FILTER PRESET PROGRAM...
test_program() {
  GTEST_SHARD_INDEX=$1 GTEST_TOTAL_SHARDS=$2 timeout 1200 \
    "${fixed_addresses[@]}" "${emulator[@]}" "build/$4/tests/$5" --gtest_filter="$3"
}
googletest_count() {
  local total good skipped
  total=$(last_match '^\[==========\] ([0-9]+) tests? from .* ran.*')
  good=$(last_match '^\[  PASSED  \] ([0-9]+) tests?.*')
  skipped=$(last_match '^\[  SKIPPED \] ([0-9]+) tests?.*')
  [ -n "$total" ] || echo "Broke off in $(last_match '^\[ RUN      \] (.*)')"
  count "$2 $3, share $(($1 + 1))" "$good" $((${total:-0} - ${good:-0} - ${skipped:-0}))
}

# node_tests FOLDER: the tests of a folder, which may have its own packages, as many shares of its
# files at once as there are processors.
node_tests() {
  local folder=tests/$1
  if [ -e "$folder/package-lock.json" ] &&
    [ ! "$folder/node_modules/.package-lock.json" -nt "$folder/package-lock.json" ]; then
    npm ci --prefix "$folder" --no-audit --no-fund || true
  fi
  in_shares "$(nproc)" node "$1" "$folder"/*.test.mjs
}
# A share's files run in one process: what they start, such as a browser, they start once.
node_share() {
  local files
  mapfile -t files < <(printf "import './%s';\n" "${@:3}" | awk -v n="$shares" -v i="$1" 'NR % n == i')
  TIA=$ROOT/build/release/tia timeout 600 \
    node --test-reporter=tap --input-type=module --eval "${files[*]}"
}
node_count() {
  local good bad cancelled
  good=$(last_match '^# pass ([0-9]+)')
  bad=$(last_match '^# fail ([0-9]+)')
  cancelled=$(last_match '^# cancelled ([0-9]+)')
  count "$2, share $(($1 + 1))" "$good" $((${bad:-0} + ${cancelled:-0}))
}

# ---- what a change needs --------------------------------------------------------------------------

build_release() {
  build tests -DTIA_WERROR=ON -- {core,server,memory}_tests &&
    build release -DTIA_WERROR=ON -DTIA_TESTS_OF="$ROOT/build/tests" -DTIA_BENCH=ON -- all
}
step_release() {
  install_missing bench || fail "installing the measurements' packages"
  build_release || true
}
step_core() {
  googletest release core_tests
  node_tests models
}
step_server() {
  ahead portable asan
  googletest release server_tests "$waiting" "$measuring"
}
waiting='Timeouts.*:Body.*:Drain.*:*Ending.*:Connections.*:Serve.*'  # for limits of time to pass
measuring='SoakOverload.*:StreamsInTime.*'  # how soon the program answers
step_memory() { googletest release memory_tests; }
step_page() {
  ahead portable asan
  node_tests browser
}
step_deploy() { node_tests deploy; }
step_pages() { node_tests pages; }

# All text is laid out as .clang-format has it. What differs from LINT_BASE (a commit; else from the
# last one) is linted, file by file: ten seconds each.
step_style() {
  local sources changed
  mapfile -t sources < <(git ls-files '*.h' '*.cpp')
  if clang-format --dry-run -Werror "${sources[@]}"; then pass; else fail "clang-format"; fi
  mapfile -t changed < <(git diff --name-only --diff-filter=AMR "${LINT_BASE:-HEAD}" -- \
    'core/*.cpp' 'server/*.cpp' 'tests/*.cpp')
  if [ "${#changed[@]}" = 0 ]; then return; fi
  cmake --preset debug -B build/lint -DCMAKE_CXX_COMPILER=clang++ \
    -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON > /dev/null
  if printf '%s\n' "${changed[@]}" |
    xargs -n 1 -P "$(nproc)" clang-tidy --quiet --warnings-as-errors='*' -p build/lint; then pass; else
    fail "clang-tidy"
  fi
}

# ---- other compilers and processors ---------------------------------------------------------------

build_portable() { build portable -DTIA_WERROR=ON -- tia; }
step_portable() { build_portable || true; }

# Another compiler and instruction set render the same pictures.
step_same_bytes() {
  local key format options model
  for key in none a d s w; do
    options=()
    [ "$key" = none ] || options+=(--key "$key")
    for format in png pfm hdr exr; do same_picture "$key.$format" thesis "${options[@]}"; done
  done
  for options in thesis normal depth albedo object shadow cost planar_depth label; do
    same_picture "$options.pfm" shapes --integrator "$options"
  done
  same_picture occlusion.pfm shapes --integrator ambient_occlusion --samples 4
  same_picture path.pfm cornell --integrator path --samples 4
  same_picture layers.exr cornell --samples 4 --integrator path \
    --aov rgba,normal,albedo,Z,object,direct,indirect,emission,variance,samples
  same_picture denoised.pfm cornell-light --samples 4 --denoise true
  same_picture samples.pfm shapes --samples 5 --seed 7
  same_picture threshold.pfm shapes --threshold 0.05
  same_picture lens.pfm shapes --samples 3 --camera '{"aperture": 1, "focus_distance": 12}'
  same_picture parallel.pfm shapes \
    --camera '{"projection": "orthographic", "height": 9, "fov_degrees": null}'
  for model in web/models/*.{glb,ply,stl}; do
    same_file "$(basename "$model").pfm" still "$model" --samples 4 --background 1,1,1
  done
  stated_hashes build/portable/tia
}

# stated_hashes PROGRAM...: draws the whole gallery, at the hashes that the tests hold release to.
# What NAME.4.pfm states is drawn with 4 samples: where rays are chance, few say as much as many; what
# NAME.t1.pfm states, at one second.
stated_hashes() {
  local file name how options
  for file in $(sed -nE 's/^[0-9a-f]+  (.*)\.pfm$/\1/p' tests/golden/gallery.sha256); do
    IFS=. read -r name how <<<"$file"
    options=(--width 160 --height 120)
    case $how in
      t*) options+=(--time "${how#t}") ;;
      ?*) options+=(--samples "$how") ;;
    esac
    "$@" render "$name" "${options[@]}" -o "$scratch/$file.pfm" || true
    if grep " $file.pfm" tests/golden/gallery.sha256 | (cd "$scratch" && sha256sum -c); then pass
    else fail "same bytes: the gallery's $name"; fi
  done
}

# same_picture FILE SCENE OPTION...: both builds make the same file.
same_picture() { same_file "$1" render "${@:2}"; }
# same_file FILE COMMAND OPTION...
same_file() {
  local preset
  for preset in release portable; do
    "build/$preset/tia" "${@:2}" --width 320 --height 240 -o "$scratch/$preset-$1" || true
  done
  if cmp "$scratch/release-$1" "$scratch/portable-$1"; then pass; else fail "same bytes: $1"; fi
}

# ARM64_TESTS=1 builds and runs the tracer's tests, too, which takes a quarter of an hour.
build_arm64() { build arm64 -- tia; }
step_arm64() {
  local -a emulator=(qemu-aarch64)
  if ! install_foreign arm64; then
    echo "Not run: this system has no packages for arm64." && return
  fi
  build_arm64 || return 0
  stated_hashes "${emulator[@]}" build/arm64/tia
  [ -n "${ARM64_TESTS:-}" ] || return 0
  build arm64 -- core_tests && googletest arm64 core_tests
}

# install_foreign ARCHITECTURE: the packages of that section, beside the system's own.
install_foreign() {
  local sudo=()
  if [ -z "$(missing_packages "$1")" ]; then return; fi
  [ "$(id -u)" = 0 ] || sudo=(sudo)
  "${sudo[@]}" dpkg --add-architecture "$1" && install_missing "$1"
}

# On a processor without AVX release says so and exits 2; portable renders the same bytes.
step_old() {
  local old=(qemu-x86_64 -cpu Nehalem) picture=(--width 32 --height 24 --key a)
  if [ "$(uname -m) $(sed -n 's/^TIA_ARCH:.*=//p' build/release/CMakeCache.txt)" != "x86_64 x86-64-v3" ]; then
    echo "This is no build for x86-64-v3." && return
  fi
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

# ---- what watches the program ---------------------------------------------------------------------

# Watched soaks need not be long: what a hundred rounds do not show, a thousand do not either.
# The tests are those of release: what is watched are the libraries.
build_asan() {
  build asan -DTIA_TESTS_OF="$ROOT/build/tests" -- core_tests server_tests memory_tests \
    {request,scene,query,formula,picture,model}_fuzz
}
step_asan() {
  local -x SOAK=0.5
  build_asan || return 0
  local -x LLVM_PROFILE_FILE=$ROOT/build/asan/counts/%4m.profraw
  rm -rf build/asan/counts
  googletest asan core_tests
  ahead tsan
  googletest asan server_tests "$waiting" "$measuring"
  googletest asan memory_tests
}

# What step asan has counted, of the tests and of every tia that they started and let end.
step_coverage() {
  local programs=({core,server,memory}_tests)
  llvm-profdata merge -sparse build/asan/counts/*.profraw -o build/asan/counts/all || true
  if llvm-cov export -summary-only -instr-profile=build/asan/counts/all build/asan/tia \
    "${programs[@]/#/-object=build/asan/tests/}" | python3 tests/coverage.py "$ROOT"; then pass; else
    fail coverage
  fi
}

# Who watches threads must see both sides of what passes between them: the tests' own as well.
build_tsan() { build tsan -- server_tests; }
step_tsan() {
  local -x SOAK=0.5
  build_tsan || return 0
  if [ -z "$(missing_packages arm64)" ]; then ahead arm64; fi
  TSAN_OPTIONS="suppressions=$ROOT/tests/tsan.supp" googletest tsan server_tests "$waiting" "$measuring"
}

# Each fuzzer for FUZZ_SECONDS, from the seeds on, all at once, each with a third of a processor,
# as the timeout allows for. What breaks it stays in build/asan.
step_fuzz() {
  in_shares 6 fuzz request scene query formula picture model
}
# What is not text by nature may be long: a kilobyte of a picture unpacks to a megabyte.
fuzz_share() {
  local names=("${@:2}") longest=4096
  local name=${names[$1]}
  if [[ $name =~ ^(picture|request|model)$ ]]; then longest=65536; fi
  mkdir -p "$scratch/$name"
  LLVM_PROFILE_FILE=/dev/null "build/asan/tests/${name}_fuzz" -max_total_time="${FUZZ_SECONDS:-25}" \
    -max_len="$longest" -timeout=12 -rss_limit_mb=2048 -verbosity=0 -artifact_prefix=build/asan/ \
    "$scratch/$name" "tests/fuzz/corpus/$name"
}
fuzz_count() {
  local names=("${@:2}")
  if [ "$status" = 0 ]; then pass; else fail "fuzz ${names[$1]}"; fi
}
