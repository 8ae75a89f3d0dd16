// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/drawn.h"

#include "draw/figure.h"

namespace seam::cli {

report::FigureRun drawn(const claims::MeantFigure& figure, const symbolic::Numbers& numbers,
                        std::size_t before, const claims::Limits& within) {
  report::FigureRun run;
  const auto refusal = within("a figure after " + std::to_string(before) + " items",
                              [&] { run = draw::sampled(figure, numbers); });
  if (!refusal) return run;
  claims::MeantFigure empty{figure.id,
                            figure.title,
                            figure.at,
                            {},
                            {},
                            {},
                            figure.colour,
                            figure.with,
                            "drawing it: " + refusal->detail};
  return draw::sampled(empty, numbers);
}

}  // namespace seam::cli
