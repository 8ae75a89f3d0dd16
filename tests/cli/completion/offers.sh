# SPDX-License-Identifier: GPL-3.0-or-later
# bash offers.sh SHELL PROGRAMS SCRIPTS WORK: compares what the shell offers with what it should.
shell=$1 scripts=$3 work=$4
here=$(cd "$(dirname "$0")" && pwd)
export PATH=$2:$PATH HOME=$work/home
rm -rf "$work"
mkdir -p "$work/home" "$work/typed/folder"
cd "$work/typed" || exit 1
touch notes.txt
printf 'claim one.first "the first": 1 < 2\nclaim one.second: 1 < 2\nclaim two:last: 1 < 2\n' >paper.seam
cp paper.seam 'my paper.seam'
cp paper.seam ../home/far.seam

failures=0
offers() {  # LINE WORD...
  local line=$1 found wanted
  shift
  wanted=$(printf '%s\n' "$@" | sort)
  # The shells differ in how they quote, mark folders and repeat what is typed already.
  found=$("$shell" "$here/$shell.sh" "$scripts" "$line" 2>&1 |
    sed -e 's/\\//g' -e 's,/$,,' -e 's/^--[a-z]*=//' -e 's/^two://' | sort -u)
  [ "$found" = "$wanted" ] && return
  printf '%s\n' "<$line> offers" "$found" "and not" "$wanted"
  failures=1
}

offers 'seamproof ver' verify
offers 'seamproof exp' explain export
offers 'seamproof --v' --version
offers 'seamproof verify --all' --allow-undecided
offers 'seamproof verify --quiet --qu' ''
offers 'seamproof verify --claim two --cl' --claim
offers 'seamproof verify --color a' auto always
offers 'seamproof verify --color=n' never
offers 'seamproof verify ' paper.seam 'my paper.seam' folder
offers 'seamproof verify paper.seam ' paper.seam 'my paper.seam' folder
offers 'seamproof verify paper.seam --out ' folder
offers 'seamproof verify paper.seam --out=fo' folder
offers 'seamproof verify paper.seam --json no' notes.txt
offers 'seamproof explain paper.seam ' one.first one.second last
offers 'seamproof explain paper.seam two:' last
offers 'seamproof explain paper.seam one.first ' ''
offers "seamproof trust 'my paper.seam' one.s" one.second
offers 'seamproof trust my\ paper.seam one.s' one.second
offers 'seamproof trust ~/far.seam one.s' one.second
offers 'seamproof trust missing.seam ' ''
offers 'seamproof verify paper.seam --claim one' one.first one.second
offers 'seamproof-check --v' --version
exit $failures
