# SPDX-License-Identifier: GPL-3.0-or-later
# Makes a tab print the offers.
PROMPT= RPROMPT=
unsetopt zle_bracketed_paste 2>/dev/null
fpath=($1 $fpath)
autoload -Uz compinit
compinit -u -D

compadd() {
  # Called to fill arrays, not to offer.
  if [[ ${@[1,(i)(-|--)]} == *-(O|A|D)\ * ]]; then
    builtin compadd "$@"
    return
  fi
  local -a offers
  builtin compadd -A offers "$@"
  local offer
  for offer in $offers; do print -r -- "offer: $offer"; done
  builtin compadd "$@"
}
show() {
  print
  _main_complete
  print 'end of offers'
  exit
}
zle -C show complete-word show
bindkey '^I' show
