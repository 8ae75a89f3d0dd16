# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D BUILD=<build folder> -D FROM=<prefix> -D TO=<where it is then> -P install_and_move.cmake
file(REMOVE_RECURSE ${FROM} ${TO})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${FROM}
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${FROM} ${TO})
