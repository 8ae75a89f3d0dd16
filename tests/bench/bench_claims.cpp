// SPDX-License-Identifier: GPL-3.0-or-later
// What whole claims cost, those of a paper with a symbolic parameter, roots of functions of it
// and nested radicals: proving each, and judging the certificate again.

#include <benchmark/benchmark.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "check/judge.h"
#include "claims/meaning.h"
#include "prove/prove.h"

namespace {

using namespace seam;

const std::filesystem::path paper = "proofs/sphere-approximation/sphere-approximation.seam";

const claims::Meaning& meaning() {
  static const claims::Meaning all = [] {
    std::stringstream text;
    text << std::ifstream(paper).rdbuf();
    const auto source = std::make_shared<text::Source>(paper.string(), text.str());
    return claims::mean(claims::parse(source).file,
                        [](const std::string&) { return std::shared_ptr<text::Source>(); });
  }();
  return all;
}

const certificate::Statement* statement(const std::string& id) {
  for (const auto& item : meaning().items)
    if (const auto* claim = std::get_if<claims::MeantClaim>(&item);
        claim && claim->claim.id == id && claim->printed.exported)
      return &claim->printed.exported->statement;
  return nullptr;
}

void reading(benchmark::State& state) {
  std::stringstream text;
  text << std::ifstream(paper).rdbuf();
  for (auto _ : state) {
    const auto source = std::make_shared<text::Source>(paper.string(), text.str());
    benchmark::DoNotOptimize(claims::mean(claims::parse(source).file, [](const std::string&) {
      return std::shared_ptr<text::Source>();
    }));
  }
}
BENCHMARK(reading)->Unit(benchmark::kMillisecond);

void proving(benchmark::State& state, const char* id) {
  const auto* s = statement(id);
  if (!s) return state.SkipWithError("no such claim");
  for (auto _ : state) benchmark::DoNotOptimize(prove::prove(*s, {}));
}
void judging(benchmark::State& state, const char* id) {
  const auto* s = statement(id);
  if (!s) return state.SkipWithError("no such claim");
  const auto evidence = prove::prove(*s, {});
  for (auto _ : state)
    if (check::judge(*s, evidence).verdict == certificate::Verdict::undecided)
      return state.SkipWithError("not accepted");
}

#define CLAIM(name, id)                                                \
  BENCHMARK_CAPTURE(proving, name, id)->Unit(benchmark::kMillisecond); \
  BENCHMARK_CAPTURE(judging, name, id)->Unit(benchmark::kMillisecond)

CLAIM(curve_of_the_cubic_patch, "cubic.curve.second");
CLAIM(curve_of_the_quartic_patch, "quartic.curve.second");
CLAIM(regular_for_every_c, "cubic.regular");
CLAIM(nested_radicals_balance, "icosa.gamma_0.only");
CLAIM(curvature_continuous_surface, "quartic.G2.icosa");

}  // namespace
