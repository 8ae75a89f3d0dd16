// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/approximate.h"

#include <cmath>
#include <limits>
#include <unordered_map>

namespace seam::symbolic {
namespace {

class Approximation {
 public:
  Approximation(const std::map<std::string, double>& point, const Numbers& numbers)
      : point_(point), numbers_(numbers) {}

  double operator()(const Formula& f) {
    if (const auto known = done_.find(f.identity()); known != done_.end()) return known->second;
    const double value = compute(f);
    done_.emplace(f.identity(), value);
    return value;
  }

 private:
  double compute(const Formula& f) {
    double result = f.kind() == Formula::Kind::product ? 1 : 0;
    switch (f.kind()) {
      case Formula::Kind::constant:
        return f.value().get_d();
      case Formula::Kind::symbol:
        if (const auto placed = point_.find(f.name()); placed != point_.end())
          return placed->second;
        return is_generator(f.name()) ? numbers_.approximate(f)
                                      : std::numeric_limits<double>::quiet_NaN();
      case Formula::Kind::sum:
        for (const Formula& term : f.operands()) result += (*this)(term);
        return result;
      case Formula::Kind::product:
        for (const Formula& factor : f.operands()) result *= (*this)(factor);
        return result;
      case Formula::Kind::power:
        return std::pow((*this)(f.operands()[0]), f.exponent());
      case Formula::Kind::inverse:
        return 1 / (*this)(f.operands()[0]);
      case Formula::Kind::root:
        return std::pow((*this)(f.operands()[0]), 1.0 / f.exponent());
      case Formula::Kind::applied:
        return applied(f.name(), (*this)(f.operands()[0]));
      case Formula::Kind::known:
        return (*this)(f.operands()[0]);
    }
    return result;
  }

  static double applied(const std::string& function, double x) {
    if (function == "exp") return std::exp(x);
    if (function == "sin") return std::sin(x);
    if (function == "cos") return std::cos(x);
    if (function == "log") return std::log(x);
    return std::numeric_limits<double>::quiet_NaN();
  }

  const std::map<std::string, double>& point_;
  const Numbers& numbers_;
  std::unordered_map<const void*, double> done_;
};

}  // namespace

double approximate(const Formula& f, const std::map<std::string, double>& point,
                   const Numbers& numbers) {
  return Approximation(point, numbers)(f);
}

}  // namespace seam::symbolic
