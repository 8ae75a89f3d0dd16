# SPDX-License-Identifier: GPL-3.0-or-later
# Completion for bash, with the package bash-completion: the program itself says what may follow.

_seamproof() {
  local cur prev words cword split line
  _init_completion -s -n : || return
  local before=() word
  for word in "${words[@]:1:cword-1}"; do
    # Quotes are taken away where that executes nothing.
    [[ $word == *[\$\`\(\)\<\>\;\&\|]* ]] || eval "word=$word" 2>/dev/null
    before+=("$word")
  done
  $split && before+=("$prev")  # --option=value

  while IFS= read -r line; do
    case $line in
      /) _filedir -d ;;
      /\*.*) _filedir "${line#/\*.}" ;;
      /*) _filedir ;;
      *) COMPREPLY+=("${line%%$'\t'*}") ;;
    esac
  done < <("${words[0]}" complete "${before[@]}" "$cur" 2>/dev/null)
  __ltrim_colon_completions "$cur"
}

complete -F _seamproof seamproof
