# SPDX-License-Identifier: GPL-3.0-or-later
# zsh zsh.sh SCRIPTS LINE: what a tab at the end of the line offers, a word a line.
# A second zsh, on a terminal of its own, is typed at; there `compadd` prints what it is given.
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell "source ${(q)0:A:h}/in_zsh.zsh ${(q)1}"
zpty -n -w shell "$2"$'\t'
while zpty -r shell line && [[ $line != *'end of offers'* ]]; do
  [[ $line == 'offer: '* ]] && print -r -- ${${line#offer: }%%[[:cntrl:]]*}
done
