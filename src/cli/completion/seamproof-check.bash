# SPDX-License-Identifier: GPL-3.0-or-later
# Completion for bash, with the package bash-completion.

_seamproof_check() {
  local cur prev words cword
  _init_completion || return
  case $cur in
    -*) COMPREPLY=($(compgen -W '--help --version' -- "$cur")) ;;
    *) _filedir json ;;
  esac
}

complete -F _seamproof_check seamproof-check
