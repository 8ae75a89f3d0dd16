# SPDX-License-Identifier: GPL-3.0-or-later
# bash package_twice.sh BUILD WORK COMPONENT...: packages made in another place, at another time and
# in another time zone and language are the same.
set -eu
umask 022  # CPack gives the members of a package the permissions that new files have
build=$1 work=$2
shift 2
rm -rf "$work"
pack() { cpack --config "$build/CPackConfig.cmake" -D "CPACK_COMPONENTS_ALL=$(IFS=';' && echo "$*")" -B "$work/$place"; }
place=one pack "$@"
place=two TZ=Asia/Tokyo LC_ALL=C pack "$@"
for package in "$work"/one/*.deb; do
  cmp "$package" "$work/two/$(basename "$package")"
done
