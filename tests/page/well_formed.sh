#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# well_formed.sh SEAMPROOF FILE FOLDER: the page is well-formed XML, and made again it has the same bytes.
set -euo pipefail
for again in one two; do
  "$1" verify "$2" --out "$3/$again" --html --quiet || [ $? -le 2 ]
done
xmllint --noout --nonet "$3/one/report.html"
cmp "$3/one/report.html" "$3/two/report.html"
