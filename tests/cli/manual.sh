# SPDX-License-Identifier: GPL-3.0-or-later
# bash manual.sh SEAMPROOF SEAMPROOF-CHECK PAGE CHECK-PAGE DOCUMENT: the manual pages say what
# --help and docs/command-line.md say.
seamproof=$1 checker=$2 page=$3 check_page=$4 document=$5
failures=0

same() {  # WHAT HELP MANUAL
  [ -n "$2" ] && [ "$2" = "$3" ] && return
  printf '%s\n' "$1: --help says" "$2" 'and the manual' "$3"
  failures=1
}
shown() { mandoc -T ascii -O width=200 "$1" | col -b; }
options() { grep -oE '^ +(-[a-z], ?)?--[a-z-]+' | grep -oE -- '--[a-z-]+' | grep -vx -- --help | sort; }
arguments() { sed -nE 's/^.*\[(OPTIONS|option \.\.\.)\] //p' | sed 's/ *\.\.\.//g'; }
section() { shown "$page" | awk -v title="   seamproof $1" '/^   ?[^ ]/ || /^[A-Z]/ { on = ($0 == title) } on'; }

commands=$("$seamproof" --help | awk '/^Subcommands:/ { on = 1; next } on && NF { print $1 }')
same commands "$commands" "$(shown "$page" | sed -n 's/^   seamproof //p')"
for command in $commands; do
  help=$("$seamproof" "$command" --help)
  [ -z "$(options <<<"$help")$(section "$command" | options)" ] ||
    same "options of $command" "$(options <<<"$help")" "$(section "$command" | options)"
  same "arguments of $command" "$(arguments <<<"$help")" \
    "$(section "$command" | arguments)"
done
same 'statuses of seamproof-check' "$("$checker" --help | sed -n '/^Exit status/p' | grep -oE '[0-9]+' | sort)" \
  "$(shown "$check_page" | sed -n '/^EXIT STATUS/,/^EXAMPLES/p' | grep -oE '^ +[0-9]+' | tr -d ' ' | sort)"
same 'exit statuses, where --help is docs/command-line.md' \
  "$(sed -n '/^## Exit status/,/^## [^E]/p' "$document" | grep -oE '^\| [0-9 ]+' | grep -oE '[0-9]+' | sort)" \
  "$(shown "$page" | sed -n '/^EXIT STATUS/,/^EXAMPLES/p' | grep -oE '^ +[0-9]+' | tr -d ' ' | sort)"
same 'files, where --help is docs/command-line.md' \
  "$(sed -n '/^With `--out DIR`/,/^With several/p' "$document" | sed -n 's/^| \(`[^|]*`\) |.*/\1/p' |
    grep -oE '[A-Za-z*]+[./][A-Za-z.*]*' | sort)" \
  "$(shown "$page" | sed -n '/^FILES/,/^EXIT/p' | grep -oE '^     [A-Za-z*]+[./][A-Za-z.*]*' | tr -d ' ' | sort)"

for file in "$page" "$check_page"; do
  complaints=$(mandoc -T lint -W warning "$file")
  [ -z "$complaints" ] || { echo "$complaints"; failures=1; }
  if command -v groff >/dev/null; then
    complaints=$(groff -mdoc -ww -T utf8 "$file" 2>&1 >/dev/null)
    [ -z "$complaints" ] || { echo "$complaints"; failures=1; }
  fi
done
exit $failures
