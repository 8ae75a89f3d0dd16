# SPDX-License-Identifier: GPL-3.0-or-later
# Installs in the folder `destination` the headers that an outside project begins with, and those
# that they include; `work` is a folder for the edited ones. In this tree a header says
# #include "check/judge.h"; installed, it says #include "seamproof/check/judge.h": one include root
# serves, and an outside project may have folders called check and text itself.
cmake_policy(VERSION 3.25)
set(headers text/source.h certificate/json.h check/judge.h claims/meaning.h prove/prove.h)
set(done "")
while(headers)
  list(POP_FRONT headers header)
  if(header IN_LIST done)
    continue()
  endif()
  list(APPEND done ${header})

  file(READ ${CMAKE_CURRENT_LIST_DIR}/../src/${header} text)
  string(REGEX MATCHALL "#include \"[^\"]+" includes "${text}")
  list(TRANSFORM includes REPLACE "#include \"" "")
  list(APPEND headers ${includes})

  string(REPLACE "#include \"" "#include \"seamproof/" text "${text}")
  file(CONFIGURE OUTPUT ${work}/${header} CONTENT "${text}" @ONLY)
  cmake_path(GET header PARENT_PATH module)
  file(INSTALL ${work}/${header} DESTINATION ${destination}/${module})
endwhile()
