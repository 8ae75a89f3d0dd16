// SPDX-License-Identifier: GPL-3.0-or-later
#include "numbers.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <set>

#include "certificate/fault.h"

namespace seam::tampered {
namespace {

using Rational = boost::multiprecision::cpp_rational;

}  // namespace

bool is_number(const std::string& text) {
  return certificate::is_rational(text);
}

std::string negated(const std::string& number) {
  if (number == "0") return "1";
  return number.front() == '-' ? number.substr(1) : "-" + number;
}

std::vector<std::string> nearby(const std::string& number) {
  const Rational value(number), little(1, 1000000000);
  std::vector<std::string> found;
  for (const Rational& step : {Rational(1), Rational(-1), little, Rational(-little)})
    found.push_back(Rational(value + step).str());
  return found;
}

std::vector<std::string> with_other_digits(const std::string& number) {
  std::vector<std::string> found;
  for (const std::size_t i : std::set{std::size_t{0}, number.size() / 2, number.size() - 1}) {
    std::string other = number;
    if (other[i] < '0' || other[i] > '9') continue;
    other[i] = other[i] == '9' ? '1' : static_cast<char>(other[i] + 1);
    found.push_back(other);
  }
  return found;
}

}  // namespace seam::tampered
