# SPDX-License-Identifier: GPL-3.0-or-later
# fish fish.sh SCRIPTS LINE: what a tab at the end of the line offers, a word a line.
set fish_complete_path $argv[1]
complete --do-complete $argv[2] | string replace --regex '\t.*' ''
