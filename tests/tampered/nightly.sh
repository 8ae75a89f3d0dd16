#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Tampered certificates and results at their full size: nightly.sh BUILD_DIR [CAP [LONGEST [ASKED]]]
# CAP changes of a kind in a part of a certificate, certificates of LONGEST bytes or fewer, ASKED questions to the second checker.
set -euo pipefail
build=$(realpath "$1")
cap=${2:-8}
longest=${3:-60000}
asked=${4:-20000}
here=$(dirname "$(realpath "$0")")
project=$(realpath "$here/../..")
command -v python3 >/dev/null || { echo "skipped: Python is not there (Debian: python3)"; exit 0; }
cmake --build "$build" --target tampered >/dev/null
folder=$build/tampered
mkdir -p "$folder"
worst=0
"$build/bin/tampered" "$folder/questions.jsonl" "$cap" "$longest" \
  "$project/tests/proofs/valid" "$project"/reports/*/certificates || worst=1
python3 -B "$here/confirm.py" "$folder/questions.jsonl" "$asked" || worst=1
echo
XDG_CACHE_HOME=/dev/null python3 -B "$here/results_test.py" "$build/bin/seamproof" \
  "$project/tests/determinism/small.seam" "$folder/results" || worst=1
exit $worst
