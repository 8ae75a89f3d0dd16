// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace seam::exact {

/// The caller broke a stated precondition. A bug in the calling code, never a
/// property of the user's input: nobody but a test or `main` may catch it.
struct ContractError : std::logic_error {
  using std::logic_error::logic_error;
};

/// Stays on in release builds: a verifier that skips checks proves nothing.
inline void require(bool condition, const char* message) {
  if (!condition) throw ContractError(message);
}

}  // namespace seam::exact
