#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# nightly.sh BUILD_DIR: the tests of this folder at their full size: larger files, more kills, a whole paper.
set -euo pipefail
bin=$(cd "$1" && pwd)/bin
here=$(cd "$(dirname "$0")" && pwd)
export XDG_CACHE_HOME=/dev/null
failed=0
rows=()
one() {
  local name=$1 counted=$2 log word=passed
  shift 2
  log=$(mktemp)
  /usr/bin/python3 "$@" >"$log" 2>&1 || { word=FAILED failed=1; cat "$log"; }
  rows+=("| $name | $(grep -cE "$counted" "$log") | $word |")
  rm -f "$log"
}
one "limits for a claim" ": status " "$here/limits_test.py" "$bin/seamproof"
one "hostile files and certificates" ": status " "$here/hostile_files_test.py" "$bin/seamproof" "$bin/seamproof-check" --large
one "killed at 300 moments" "^undisturbed" "$here/killed_test.py" "$bin/seamproof" "$here/../determinism/small.seam" 300
one "a paper, killed at 100 moments" "^undisturbed" "$here/killed_test.py" "$bin/seamproof" \
  "$here/../../proofs/geodesic-patches/geodesic-patches.seam" 100
one "nowhere to write" " failures$" "$here/full_disk_test.py" "$bin/seamproof"
echo "| campaign | cases | |"
echo "| --- | --- | --- |"
printf '%s\n' "${rows[@]}"
exit "$failed"
