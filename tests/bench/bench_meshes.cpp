// SPDX-License-Identifier: GPL-3.0-or-later
// What meshes cost that are truncated five and seven times: reading the claim, proving it,
// judging the certificate again.

#include <benchmark/benchmark.h>

#include "check/judge.h"
#include "claims/meaning.h"
#include "prove/prove.h"

namespace {

using namespace seam;

certificate::Statement stated(const std::string& statement) {
  const auto source = std::make_shared<text::Source>("mesh.seam", "claim c: " + statement);
  const claims::Meaning meaning =
      claims::mean(claims::parse(source).file,
                   [](const std::string&) { return std::shared_ptr<text::Source>(); });
  return std::get<claims::MeantClaim>(meaning.items.at(0)).printed.exported->statement;
}

void claim(benchmark::State& state, const char* statement) {
  for (auto _ : state) {
    const certificate::Statement s = stated(statement);
    const auto evidence = prove::prove(s, {});
    if (check::judge(s, evidence).verdict != certificate::Verdict::proven)
      return state.SkipWithError("not proven");
  }
}

void judging(benchmark::State& state, const char* statement) {
  const certificate::Statement s = stated(statement);
  const auto evidence = prove::prove(s, {});
  for (auto _ : state)
    if (check::judge(s, evidence).verdict != certificate::Verdict::proven)
      return state.SkipWithError("not proven");
}

#define CLAIM(name, text)                                              \
  BENCHMARK_CAPTURE(claim, name, text)->Unit(benchmark::kMillisecond); \
  BENCHMARK_CAPTURE(judging, name, text)->Unit(benchmark::kMillisecond)

CLAIM(counts_5, "counts(truncate(dodecahedron, 1/4, 5)) = (4860, 7290, 2432)");
CLAIM(counts_7, "counts(truncate(dodecahedron, 1/4, 7)) = (43740, 65610, 21872)");
CLAIM(planar_5, "planar(truncate(dodecahedron, 1/4, 5))");
CLAIM(planar_7, "planar(truncate(dodecahedron, 1/4, 7))");
CLAIM(convex_5, "convex(truncate(dodecahedron, 1/4, 5))");
CLAIM(golden_ratios_5, "planar(truncate(dodecahedron, (5 - sqrt(5))/10, 5))");

}  // namespace
