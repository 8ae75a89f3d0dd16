#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# pkg_config.sh INSTALLED WORK COMPILER: a program from the installed files, without CMake.
set -eu
installed=$1 work=$2 compiler=$3
source=$(dirname "$0")/outside
export PKG_CONFIG_PATH="$installed/lib/pkgconfig"

$compiler -std=c++20 -o "$work/judge" "$source/judge_certificate.cpp" \
  $(pkg-config --cflags --libs seamproof-check)
"$installed/bin/seamproof" verify "$source/first.seam" --out "$work/first" --quiet
"$work/judge" "$work"/first/certificates/*.json

# The prover's libraries are complete and in the right order.
$compiler -std=c++20 -o "$work/decide" "$source/decide_claims.cpp" \
  $(pkg-config --cflags --libs seamproof-prover)
"$work/decide" "$source/first.seam"
