#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# nightly.sh BUILD_DIR: every paper in every way of same_bytes_test.py, with the program of BUILD_DIR, with one that the
# other compiler made, and with sanitizers. A compiler that is not there is named and left out.
set -euo pipefail
build=$(cd "$1" && pwd)
root=$(cd "$(dirname "$0")/../.." && pwd)
programs=("$build/bin/seamproof")
notes=()
for compiler in g++ clang++; do
  command -v "$compiler" >/dev/null || { notes+=("$compiler is not there: skipped"); continue; }
  cmake -S "$root" -B "$build/determinism/$compiler" -G Ninja -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_COMPILER="$compiler" >&2
  cmake --build "$build/determinism/$compiler" --target seamproof >&2
  programs+=("$build/determinism/$compiler/bin/seamproof")
done
cmake -S "$root" -B "$build/determinism/sanitizers" -G Ninja -D CMAKE_BUILD_TYPE=RelWithDebInfo \
  -D CMAKE_CXX_FLAGS="-fsanitize=address,undefined" >&2
cmake --build "$build/determinism/sanitizers" --target seamproof >&2
programs+=("$build/determinism/sanitizers/bin/seamproof")

failed=0
rows=()
for file in "$root"/tests/determinism/small.seam "$root"/proofs/*/*.seam; do
  log=$(mktemp)
  word=same
  /usr/bin/python3 "$root/tests/determinism/same_bytes_test.py" "$file" "${programs[@]}" >"$log" 2>&1 || { word=DIFFERS failed=1; cat "$log"; }
  rows+=("| $(basename "$file" .seam) | ${#programs[@]} | $(grep -c ' files$' "$log") | $word |")
  rm -f "$log"
done
for note in ${notes[@]+"${notes[@]}"}; do echo "$note"; done
echo "| file | programs | runs | bytes |"
echo "| --- | --- | --- | --- |"
printf '%s\n' "${rows[@]}"
exit "$failed"
