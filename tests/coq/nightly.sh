#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Every theorem that is exported of the reports goes through coqc.
#
#   nightly.sh BUILD_DIR
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -B "$here/exported_test.py" "$build/bin/seamproof" "$here/../../reports" "$work" --all || {
  status=$?
  [ "$status" -eq 77 ] && exit 0
  exit "$status"
}
