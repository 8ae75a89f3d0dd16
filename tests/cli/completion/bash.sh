# SPDX-License-Identifier: GPL-3.0-or-later
# bash bash.sh SCRIPTS LINE: what a tab at the end of the line offers, a word a line.
source /usr/share/bash-completion/bash_completion
source "$1/seamproof.bash"
source "$1/seamproof-check.bash"
COMP_LINE=$2
COMP_POINT=${#COMP_LINE}
# As readline splits it: at blanks that are not quoted, and before and behind : and =.
COMP_WORDS=()
rest=$COMP_LINE
while [[ $rest =~ ^\ *(([^\ :=\\\"\']|\\.|\'[^\']*\'|\"[^\"]*\")+|[:=]+)(.*)$ ]]; do
  COMP_WORDS+=("${BASH_REMATCH[1]}")
  rest=${BASH_REMATCH[3]}
done
[[ $COMP_LINE == *' ' && $COMP_LINE != *'\ ' ]] && COMP_WORDS+=('')
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
compopt() { :; }
_"${COMP_WORDS[0]//-/_}"
printf '%s\n' "${COMPREPLY[@]}"
