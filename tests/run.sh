#!/usr/bin/env bash
# Installs what is missing, builds Tia and tests it. A step that fails does not stop the next one.
# The last line of output is "N passed, N failed".
#   tests/run.sh                 what a change needs: minutes; of steps that read nothing that has
#                                changed since they passed it tells that
#   tests/run.sh --full          all: other compilers and processors, sanitizers, fuzzers, coverage
#   tests/run.sh core page       single steps, and the builds that they need
#   tests/run.sh --list          the steps: what each protects, and how long it took last
set -euo pipefail
ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$ROOT"
. server/setup.sh
. tests/steps.sh

passed=0
failed=0
declare -A done_steps=()
scratch=$(mktemp -d)
trap 'leave_ahead; rm -rf "$scratch"' EXIT

pass() { passed=$((passed + 1)); }
fail() {
  failed=$((failed + 1))
  echo "FAILED: $*"
}

# field N ROW: of the table of steps.
field() { cut -d'|' -f"$1" <<< "$2" | sed -E 's/^ +| +$//g'; }

row_of() {
  local row
  for row in "${steps[@]}"; do
    if [ "$(field 1 "$row")" = "$1" ]; then echo "$row" && return; fi
  done
  echo "There is no step called $1; tests/run.sh --list names them." >&2
  exit 2
}

list_steps() {
  local row name took
  for row in "${steps[@]}"; do
    name=$(field 1 "$row")
    took=$(cut -d' ' -f1 "build/steps/$name" 2>/dev/null || echo '-')
    printf '%-11s %-7s %6s s  %s\n' "$name" "$(field 2 "$row")" "$took" "$(field 4 "$row")"
  done
}

# key_of NAME: changes with every file that the step's tests are made of or read, with the system's
# packages, and with how long the soaks are.
key_of() {
  local -a reads
  read -ra reads <<< "$(reads_of "$1")"
  {
    echo "${SOAK:-}"
    stat -c %Y /var/lib/dpkg/status 2> /dev/null || true
    git ls-files -coz --exclude-standard -- CMakeLists.txt CMakePresets.json tests/*.sh "${reads[@]}" |
      sort -zu | xargs -0 sha256sum 2>&1
  } | sha256sum | cut -d' ' -f1
}

# is_known NAME: whether all of its tests have passed with just these files; then counts them.
is_known() {
  local took tests key
  [ "$again" = no ] && [ -n "$(reads_of "$1")" ] || return 1
  read -r took tests key 2> /dev/null < "build/steps/$1" || return 1
  [ "$key" = "$(key_of "$1")" ] || return 1
  passed=$((passed + tests))
  printf '\n== %s: nothing that it reads has changed since its %d tests passed, in %d s\n' "$1" "$tests" "$took"
}

# do_step NAME: once, after those that it needs; not at all where one of them failed.
do_step() {
  local name=$1 row needed key
  local -a before
  [ -z "${done_steps[$name]:-}" ] || return 0
  row=$(row_of "$name")
  done_steps[$name]=yes
  for needed in $(field 3 "$row"); do
    do_step "$needed"
    if [ "${done_steps[$needed]}" = broken ]; then
      done_steps[$name]=broken
      fail "$name, for $needed failed"
      return 0
    fi
  done
  if is_known "$name"; then return; fi
  printf '\n== %s (%d s)\n' "$name" "$SECONDS"
  before=("$passed" "$failed" "$SECONDS")
  rm -f "build/steps/$name"
  key=$(key_of "$name")
  "step_${name//-/_}"
  if [ "$failed" = "${before[1]}" ]; then
    echo "$((SECONDS - before[2])) $((passed - before[0])) $key" > "build/steps/$name"
  elif is_build "$name"; then done_steps[$name]=broken; fi
}

chosen=()
again=yes  # steps that were named, and all of them, run whatever is known
for word in "$@"; do
  case $word in
    --list) list_steps && exit ;;
    --full)
      export SOAK=${SOAK:-1}  # the soaks at their whole length
      for row in "${steps[@]}"; do chosen+=("$(field 1 "$row")"); done ;;
    *) row_of "$word" > /dev/null && chosen+=("$word") ;;
  esac
done
if [ $# = 0 ]; then
  again=no
  for row in "${steps[@]}"; do
    [ "$(field 2 "$row")" = change ] && chosen+=("$(field 1 "$row")")
  done
fi

mkdir -p build/steps
install_missing build || fail "installing the build's packages"
install_missing test || fail "installing the tests' packages"
# Before all builds, for its packages may renew headers of the system. Where there are none its step says so.
if [[ " ${chosen[*]} " = *' arm64 '* ]]; then install_foreign arm64 || true; fi
for name in "${chosen[@]}"; do do_step "$name"; done

printf '\n== done (%d s)\n' "$SECONDS"
list_steps
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
