#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# nightly.sh BUILD_DIR [SAMPLE]: mutants of the checker's guards, and of all else in it, SAMPLE of each at most; with builds of their
# own below BUILD_DIR.
set -euo pipefail
build=$(realpath "$1")
cd "$(dirname "$0")"
exec python3 -B run.py "$build/code_mutants" --sample "${2:-600}"
