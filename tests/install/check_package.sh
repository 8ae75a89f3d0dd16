# SPDX-License-Identifier: GPL-3.0-or-later
# bash check_package.sh FOLDER WORK: unpacks the Debian packages of a folder and uses what is in them.
set -eu
folder=$1 work=$2
paper=$(cd "$(dirname "$0")" && pwd)/outside/first.seam
usr=$work/root/usr
rm -rf "$work"
mkdir -p "$work"
for package in "$folder"/*.deb; do
  name=$(dpkg-deb --field "$package" Package)
  dpkg-deb --extract "$package" "$work/root"
  test -s "$usr/share/doc/$name/copyright"
  gzip --test "$usr/share/doc/$name/changelog.gz"
done

# The programs find their libraries, which the package names, and work.
for program in seamproof seamproof-check; do
  ! ldd "$usr/bin/$program" | grep 'not found'
done
dpkg-deb --field "$folder"/seamproof_*.deb Depends | grep -q libginac
"$usr/bin/seamproof" verify "$paper" --out "$work/out"
"$usr/bin/seamproof-check" "$work/out"

# What else belongs to a program is where Debian looks for it.
gzip --test "$usr"/share/man/man1/seamproof.1.gz "$usr"/share/man/man1/seamproof-check.1.gz
for file in bash-completion/completions/seamproof zsh/vendor-completions/_seamproof \
  fish/vendor_completions.d/seamproof.fish texmf/tex/latex/seamproof/seamproof.sty; do
  test -s "$usr/share/$file"
done
