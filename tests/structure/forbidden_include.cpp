// SPDX-License-Identifier: GPL-3.0-or-later
// Must not compile as a part of src/check: the checker may not see the prover.
#include "prove/prove.h"
