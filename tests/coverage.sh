#!/usr/bin/env bash
# Which lines and branches of core/ and server/ the tests run: the sum of each, and the files of
# which fewer lines than LEAST percent are. Needs a build of the tests (preset release), clang and
# llvm. By hand: it takes as long as all tests with a sanitizer.
set -euo pipefail
ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
TESTS_OF=${TESTS_OF:-$ROOT/build/release}
BUILD=${BUILD:-$ROOT/build/coverage}
LEAST=${LEAST:-90}
programs=(core_tests server_tests memory_tests)
cd "$ROOT"

cmake --preset coverage -B "$BUILD" -DTIA_TESTS_OF="$TESTS_OF" > /dev/null
cmake --build "$BUILD" --parallel "${JOBS:-$(nproc)}" --target tia "${programs[@]}"

# The counts of all programs: of tests, and of every tia that they start and let end.
rm -rf "$BUILD/counts" && mkdir "$BUILD/counts"
export LLVM_PROFILE_FILE="$BUILD/counts/%4m.profraw"
for program in "${programs[@]}"; do
  "$BUILD/tests/$program" --gtest_brief=1 || echo "FAILED: $program"
done
llvm-profdata merge -sparse "$BUILD"/counts/*.profraw -o "$BUILD/counts/all"

llvm-cov export -summary-only -instr-profile="$BUILD/counts/all" "$BUILD/tia" \
  "${programs[@]/#/-object=$BUILD/tests/}" | python3 tests/coverage.py "$ROOT" "$LEAST"
