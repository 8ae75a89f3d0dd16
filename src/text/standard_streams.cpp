// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "text/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>

// An open file has the lowest number that is free. What is read from a missing input is empty,
// what is written to a missing output has no room, and complaints are lost.

namespace seam::text {

void hold_standard_streams() {
  static const char* const instead[] = {"/dev/null", "/dev/full", "/dev/null"};
  for (int number = 0; number < 3; ++number)
    if (fcntl(number, F_GETFD) < 0 && errno == EBADF) (void)open(instead[number], O_RDWR);
}

std::string end_of_output() {
  errno = 0;
  std::cout.flush();
  if (std::cout) return {};
  return std::string("cannot write standard output") +
         (errno == 0 ? "" : std::string(": ") + std::strerror(errno)) + "\n";
}

}  // namespace seam::text
