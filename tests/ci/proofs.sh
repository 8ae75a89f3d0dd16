# SPDX-License-Identifier: GPL-3.0-or-later
# bash proofs.sh BIN MODULE WORK: what ctest says of the project beside this file, then of edited files.
set -eu
bin=$1 module=$2 work=$3
project=$(cd "$(dirname "$0")" && pwd)/project
export PATH=$bin:$PATH
rm -rf "$work"
mkdir -p "$work"
cp -r "$project" "$work/project"
cmake -S "$work/project" -B "$work/build" -D MODULE="$module" > "$work/configured"

# The tests by name with what came of them, a line each.
outcomes() { sed -nE 's/^ *[0-9]+\/[0-9]+ Test +#[0-9]+: ([^ ]+) \.+ *(\*\*\*)?(Passed|Failed|Not Run) .*/\1 \3/p' "$work/said"; }
run() { ctest --test-dir "$work/build" --output-on-failure "$@" > "$work/said" 2>&1 || true; }
same() { diff -u "$1" "$2" || { cat "$work/said"; exit 1; }; }
says() { grep -qF -- "$1" "$work/said" || { echo "not said: $1"; cat "$work/said"; exit 1; }; }

run
outcomes > "$work/outcomes"
same - "$work/outcomes" <<'END'
good Passed
good.sum Passed
good.known:1 Passed
good.squares.k-k.one Passed
good.squares.k-k.two Passed
wrong Passed
wrong.right Passed
wrong.wrong Failed
wrong.surprise Failed
wrong.miscorrected Failed
open Passed
open.hard Failed
open.known Passed
unread Failed
open Passed
open.hard Passed
open.known Passed
END
says 'wrong: refuted, expected: proven'
says 'witness: -1 != 0'
says 'corrected: refuted'
says 'hard: undecided, expected: proven'
says 'reason: degenerate'
says "unread.seam:1:14: error: expected an expression after '+'"

# One claim alone is enough to have its file verified.
run -R '^good\.sum$'
outcomes > "$work/outcomes"
same - "$work/outcomes" <<'END'
good Passed
good.sum Passed
END

# Edited files need no new configuration.
echo 'claim added: 1 + 1 = 3' >> "$work/project/good.seam"
sed -i 's/2\*2 = 5/2*2 = 4/' "$work/project/wrong.seam"
run -R '^(good\.added|wrong\.wrong)$'
outcomes > "$work/outcomes"
same - "$work/outcomes" <<'END'
good Passed
good.added Failed
wrong Passed
wrong.wrong Passed
END

# Builds of several configurations have the same tests.
cmake -S "$work/project" -B "$work/build" -G 'Ninja Multi-Config' -D MODULE="$module" --fresh > "$work/configured"
run -C Release -R '^good\.sum$'
outcomes > "$work/outcomes"
same - "$work/outcomes" <<'END'
good Passed
good.sum Passed
END

# What rarely happens: a result by itself, with what a test says of it although undecided claims are allowed.
judge() { # EXPECTED MEMBERS
  mkdir -p "$work/judged"
  echo "{\"files\": [{\"claims\": [{\"id\": \"a\", $2}]}]}" > "$work/judged/results.json"
  status=0
  cmake -D STEP=judge -D ID=a -D INDEX="${3-0}" -D ALLOW_UNDECIDED=TRUE -D FOLDER="$work/judged" -P "$module" \
    > "$work/said" 2>&1 || status=$?
  [ "$status" = "$1" ] || { echo "$2: $status"; cat "$work/said"; exit 1; }
}
proven='"verdict": "proven", "expected": "proven", "as_expected": true'
judge 0 "$proven, \"corrected\": null, \"reason\": null"
judge 1 "$proven, \"alarm\": \"a sign; is [wrong\""
says 'alarm: a sign; is [wrong'
judge 1 "$proven, \"corrected_alarm\": \"0\""
judge 1 "$proven" 1
judge 0 '"verdict": "conditional", "expected": "proven", "as_expected": false'
judge 0 '"verdict": "refuted", "expected": "refuted", "as_expected": false, "corrected": "undecided"'
judge 1 '"verdict": "undecided", "expected": "refuted", "as_expected": false, "corrected": "refuted"'

# Mistakes in the project are said when it is configured.
refused() {
  printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(proofs LANGUAGES NONE)' "include($module)" "$1" \
    > "$work/project/CMakeLists.txt"
  if cmake -S "$work/project" -B "$work/refused" > "$work/said" 2>&1; then echo "not refused: $1"; exit 1; fi
  tr -s ' \n' ' ' < "$work/said" > "$work/line" && mv "$work/line" "$work/said"
  says "$2"
}
refused 'seamproof_add_proofs(missing.seam)' 'there is no file'
refused 'seamproof_add_proofs(good.seam ALOW_UNDECIDED)' 'what is meant by ALOW_UNDECIDED?'
refused 'seamproof_add_proofs(good.seam ARGS --claim sum)' '--claim cannot be in ARGS'
refused $'seamproof_add_proofs(good.seam)\nseamproof_add_proofs(good.seam)' 'tests called good are there already'
