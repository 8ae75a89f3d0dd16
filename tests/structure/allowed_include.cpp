// SPDX-License-Identifier: GPL-3.0-or-later
// Must compile as a part of src/check: shows that forbidden_include.cpp fails for its include
// alone.
#include "certificate/evidence.h"
