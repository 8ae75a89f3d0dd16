#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The campaign of mutated papers at its full size: nightly.sh BUILD_DIR [PER_CLAIM [SEED]]
# First the papers as they are, then some mutants of every claim. Fails with a finding.
set -euo pipefail
build=$(realpath "$1")
per_claim=${2:-5}
seed=${3:-1}
here=$(dirname "$(realpath "$0")")
project=$(realpath "$here/../..")
command -v python3 >/dev/null || { echo "skipped: Python is not there (Debian: python3)"; exit 0; }
folder=$build/mutants
mkdir -p "$folder"
worst=0
for paper in "$project"/proofs/*/*.seam; do
  name=$(basename "$paper" .seam)
  "$build/bin/seamproof" verify "$paper" --no-cache --quiet --json "$folder/$name.json" || [ $? -le 2 ]
  echo
  echo "$name as it is: verdict, what the evaluator says"
  python3 -B "$here/evaluate.py" "$paper" "$folder/$name.json" > "$folder/$name.txt" || worst=1
  grep -e '^CONTRARY' -e '^ *[0-9]' "$folder/$name.txt"
done
python3 -B "$here/campaign.py" "$build/bin/seamproof" "$folder/papers" --per-claim "$per_claim" --seed "$seed" \
  --jobs "$(nproc)" "$project"/proofs/*/*.seam || worst=1
exit $worst
