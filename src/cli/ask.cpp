// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "cli/commands.h"
#include "cli/decide.h"
#include "cli/files.h"
#include "cli/supervisor.h"

namespace seam::cli {

int ask(const std::string& file, const std::string& expression, int digits,
        const VerifyOptions& options) {
  const auto source =
      std::make_shared<const text::Source>(text::Source{"question", expression});
  claims::ParsedExpression question = claims::parse_expression(source);
  std::vector<text::Diagnostic> errors = std::move(question.errors);
  claims::MeantAsk meant_ask;
  if (errors.empty())
    meant_ask = claims::mean_question(parsed(file), opener_beside(file), question.expression,
                                      digits, errors, limits(options, file));
  if (!errors.empty()) {
    std::string all;
    for (const auto& error : errors) all += text::render(error);
    throw Failure{bad_file, all};
  }
  const auto attempt = [&](const claims::Lowered& lowered) {
    const Question asked{"", &lowered, &meant_ask.expression};
    return decide({asked}, options, [](const symbolic::Formula& f) { return f; }).front();
  };
  Decided decided = attempt(meant_ask.statement);
  const bool is_enclosed =
      decided.outcome.verdict != certificate::Verdict::proven && meant_ask.enclosure;
  if (is_enclosed) decided = attempt(*meant_ask.enclosure);
  if (decided.outcome.verdict != certificate::Verdict::proven) {
    std::cerr << "no certified value: "
              << (decided.outcome.detail.empty()
                      ? "the value that was found could not be confirmed"
                      : decided.outcome.detail)
              << "\n";
    return 2;
  }
  std::cout << meant_ask.decimal << "\n";
  if (!is_enclosed) std::cout << "= " << meant_ask.closed_form << "\n";
  return ok;
}

}  // namespace seam::cli
