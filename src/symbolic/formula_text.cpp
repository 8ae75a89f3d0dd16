// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "symbolic/formula.h"

// Ends soon although a shared formula may have exponentially many occurrences: nothing is
// written past the bound.

namespace seam::symbolic {
namespace {

// What a formula is part of: a term that is added, one that is subtracted, a factor that comes
// first or later, the base of a power.
enum class Around { sum, difference, product, factor, power };

class Writer {
 public:
  explicit Writer(std::size_t most) : most_(most) {}

  void write(const Formula& f, Around around) {
    if (text_.size() > most_) return;
    switch (f.kind()) {
      case Formula::Kind::constant: {
        const std::string digits = f.value().get_str();
        const bool plain = digits.find_first_of("-/") == std::string::npos;
        return wrapped(!plain && around > Around::difference, [&] { text_ += digits; });
      }
      case Formula::Kind::symbol:
        text_ += f.name();
        return;
      case Formula::Kind::known:
        return write(f.operands()[0], around);
      case Formula::Kind::inverse:
        return wrapped(around > Around::difference, [&] {
          text_ += "1/";
          write(f.operands()[0], Around::power);
        });
      case Formula::Kind::root:
        text_ += f.exponent() == 2 ? "sqrt(" : "root_n(";
        write(f.operands()[0], Around::sum);
        text_ += f.exponent() == 2 ? ")" : ", " + std::to_string(f.exponent()) + ")";
        return;
      case Formula::Kind::applied:
        return write_applied(f);
      case Formula::Kind::power:
        return wrapped(around == Around::power, [&] {
          write(f.operands()[0], Around::power);
          text_ += "^" + std::to_string(f.exponent());
        });
      case Formula::Kind::product:
        return wrapped(
            around == Around::power ||
                (around != Around::sum && around != Around::product && begins_with_minus(f)),
            [&] { write_product(f); });
      case Formula::Kind::sum:
        return wrapped(around != Around::sum, [&] { write_sum(f); });
    }
  }

  std::string result() && {
    if (text_.size() > most_) text_.replace(most_, std::string::npos, "...");
    return std::move(text_);
  }

 private:
  template <class Inner>
  void wrapped(bool needed, const Inner& inner) {
    if (needed) text_ += "(";
    inner();
    if (needed) text_ += ")";
  }

  // `x''(t)`; with more than three derivatives, or in one of several operands, `D(x, 2, 0)(s,
  // t)`.
  void write_applied(const Formula& f) {
    const auto& orders = f.orders();
    const bool is_plain = std::ranges::all_of(orders, [](int order) { return order == 0; });
    if (orders.size() == 1 && orders[0] <= 3) {
      text_ += f.name() + std::string(orders[0], '\'');
    } else if (is_plain) {
      text_ += f.name();
    } else {
      text_ += "D(" + f.name();
      for (const int order : orders) text_ += ", " + std::to_string(order);
      text_ += ")";
    }
    const char* separator = "(";
    for (const Formula& operand : f.operands()) {
      text_ += separator;
      write(operand, Around::sum);
      separator = ", ";
    }
    text_ += ")";
  }

  void write_product(const Formula& f) {
    for (std::size_t i = 0; i < f.operands().size(); ++i) {
      const Formula& factor = f.operands()[i];
      if (i == 0 && factor.is(-1)) {
        text_ += "-";
        continue;
      }
      if (i > 0 && !text_.ends_with('-')) text_ += "*";
      write(factor, i == 0 ? Around::product : Around::factor);
    }
  }

  static bool begins_with_minus(const Formula& f) {
    const bool goes_on = f.kind() == Formula::Kind::product || f.kind() == Formula::Kind::known;
    return goes_on ? begins_with_minus(f.operands()[0]) : f.is_constant() && f.value() < 0;
  }

  static bool is_negative(const Formula& term) {
    const bool product = term.kind() == Formula::Kind::product;
    const Formula& first = product ? term.operands()[0] : term;
    return first.is_constant() && first.value() < 0;
  }

  // Of a negative term: its leading constant with the other sign.
  static Formula opposite(const Formula& term) {
    if (term.is_constant()) return Formula(-term.value());
    std::vector<Formula> factors = term.operands();
    factors[0] = Formula(-factors[0].value());
    return product(std::move(factors));
  }

  void write_sum(const Formula& f) {
    bool first = true;
    for (const Formula& term : f.operands()) {
      const bool negative = !first && is_negative(term);
      if (!first) text_ += negative ? " - " : " + ";
      write(negative ? opposite(term) : term, negative ? Around::difference : Around::sum);
      first = false;
    }
  }

  std::size_t most_;
  std::string text_;
};

}  // namespace

std::string text(const Formula& f, std::size_t most) {
  Writer writer(most);
  writer.write(f, Around::sum);
  return std::move(writer).result();
}

}  // namespace seam::symbolic
