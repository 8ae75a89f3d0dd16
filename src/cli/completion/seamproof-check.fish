# SPDX-License-Identifier: GPL-3.0-or-later
# Completion for fish.

complete --command seamproof-check --short-option h --long-option help --description 'how it is used'
complete --command seamproof-check --long-option version --description 'which version this is'
