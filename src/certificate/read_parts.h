// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <array>

#include "certificate/evidence.h"
#include "certificate/reader.h"
#include "certificate/to_json.h"

// The parts of a certificate; see `Reader` on what is not as expected.
namespace seam::certificate {

Relation read_relation(const Reader&);
Node read_node(const Reader&);
Generator read_generator(const Reader&);
Statement read_statement(const Reader&);
Evidence read_evidence(const Reader&);

/// The kind that is spelled there.
template <typename Kind, std::size_t Count>
Kind read_spelling(const Reader& in, const std::array<Kind, Count>& kinds) {
  const std::string text = in.text();
  for (const Kind kind : kinds)
    if (text == spelling(kind)) return kind;
  in.fail("another word than '" + text + "'");
}

}  // namespace seam::certificate
