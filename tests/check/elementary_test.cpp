// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/elementary.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "builder.h"

namespace seam::check::test {
namespace {

using certificate::Elementary;
using enum Relation;

constexpr int bits = 256;

// The decimal, cut off, as an interval that holds what was cut.
Interval around(const std::string& decimal) {
  std::string digits = decimal;
  const bool is_negative = digits.front() == '-';
  if (is_negative) digits.erase(0, 1);
  const std::size_t point = digits.find('.');
  const auto places = static_cast<unsigned>(digits.size() - point - 1);
  digits.erase(point, 1);
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
  const Integer scale = boost::multiprecision::pow(Integer(10), places);
  const Integer n(digits);
  const Interval size{floor_quotient(n << bits, scale),
                      ceiling_quotient((n + 1) << bits, scale)};
  return is_negative ? Interval{-size.high, -size.low} : size;
}

Interval value(Elementary function, int numerator, int denominator, Meter& meter) {
  const Integer n = Integer(numerator) << bits;
  return elementary(function,
                    {floor_quotient(n, denominator), ceiling_quotient(n, denominator)}, bits,
                    meter);
}

// From bc, with 75 digits.
TEST(Elementary, values_are_those_of_another_program) {
  using enum Elementary;
  const std::tuple<Elementary, int, int, const char*> known[] = {
      {pi, 0, 1, "3.14159265358979323846264338327950288419716939937510582097494459230"},
      {exp, 1, 1, "2.71828182845904523536028747135266249775724709369995957496696762772"},
      {exp, -10, 1, "0.0000453999297624848515355915155605506102379180888665649692590713"},
      {exp, 20, 1, "485165195.40979027796910683054154055868463898894484725435361080031"},
      {log, 2, 1, "0.69314718055994530941723212145817656807550013436025525412068000949"},
      {log, 3, 1, "1.09861228866810969139524523692252570464749055782274945173469433363"},
      {log, 1, 1000, "-6.9077552789821370520539743640530926228033044658863189280999837"},
      {log, 123456789, 1, "18.6314017661680180331939333479632042097136818410204019751850899"},
      {sin, 1, 1, "0.84147098480789650665250232163029899962256306079837106567275170999"},
      {sin, 100, 1, "-0.50636564110975879365655761045978543206503272129065732344339247"},
      {sin, -1, 3, "-0.32719469679615224417334408526762060606430140689375979159005627"},
      {cos, 1, 1, "0.54030230586813971740093660744297660373231042061792222767009725538"},
      {cos, 100, 1, "0.86231887228768393410193851395084253551008400853551082928016211"},
      {cos, 1000, 1, "0.562379076290702991078249226605395968755811821738196917702825185"},
  };
  Meter meter(1'000'000'000);
  for (const auto& [function, numerator, denominator, decimal] : known) {
    const Interval found = value(function, numerator, denominator, meter);
    const Interval true_value = around(decimal);
    EXPECT_LE(found.low, true_value.high) << decimal;
    EXPECT_GE(found.high, true_value.low) << decimal;
    EXPECT_LT(found.width(), Integer(1) << 60) << decimal;
  }
}

TEST(Elementary, a_wide_interval_holds_all_values) {
  Meter meter(1'000'000'000);
  const Integer one = Integer(1) << bits;
  for (const Elementary function : {Elementary::exp, Elementary::sin, Elementary::cos}) {
    const Interval all = elementary(function, {-one, one}, bits, meter);
    for (int n = -4; n <= 4; ++n) {
      const Interval one_value = value(function, n, 4, meter);
      EXPECT_LE(all.low, one_value.low);
      EXPECT_GE(all.high, one_value.high);
    }
  }
}

TEST(Elementary, a_value_in_finer_units_lies_in_the_coarse_one) {
  Meter meter(2'000'000'000);
  for (const Elementary function :
       {Elementary::exp, Elementary::log, Elementary::sin, Elementary::cos, Elementary::pi})
    for (const int fine : {64, 100, 1024}) {
      const Integer three = Integer(3) << 30, same = Integer(3) << fine;
      const Interval coarse = elementary(function, {three, three}, 30, meter);
      const Interval exact = elementary(function, {same, same}, fine, meter);
      EXPECT_LE(coarse.low << (fine - 30), exact.low);
      EXPECT_GE(coarse.high << (fine - 30), exact.high);
    }
}

/// Statements about values of functions.
struct OfValues : Case {
  Term one = number(1), nil = number(0);
  Term value_of(const std::string& name, Elementary function, Term argument) {
    statement.generators.push_back({name, 0, {}, {}, function, argument});
    return symbol(name);
  }
  Finding sign(Term formula, Relation relation) {
    claim(Sign{formula, relation, {}});
    return finding(Computation{});
  }
};

TEST(Elementary, signs_of_their_values_are_decided) {
  OfValues k;
  const Term e = k.value_of("e", Elementary::exp, k.one);
  const Term pi = k.value_of("p", Elementary::pi, 0);
  const Term log3 = k.value_of("l", Elementary::log, k.number(3));
  EXPECT_HOLDS(k.sign(k.difference(pi, e), positive));
  EXPECT_HOLDS(k.sign(k.difference(k.number("355/113"), pi), positive));
  EXPECT_FAILS(k.sign(k.difference(k.number("355/113"), pi), zero));
  EXPECT_HOLDS(k.sign(k.difference(log3, k.number("11/10")), negative));
}

TEST(Elementary, what_is_nearly_an_integer_is_not_one) {
  OfValues k;
  const Term root = k.root("r", k.number(163), "12", "13");
  const Term pi = k.value_of("p", Elementary::pi, 0);
  const Term e = k.value_of("e", Elementary::exp, k.product({pi, root}));
  const Term n = k.number("262537412640768744");
  EXPECT_FAILS(k.sign(k.difference(e, n), zero));
  EXPECT_HOLDS(k.sign(k.difference(e, n), negative));
}

TEST(Elementary, equal_values_that_no_normal_form_shows_stay_open) {
  OfValues k;
  const Term half = k.value_of("h", Elementary::exp, k.number("1/2"));
  const Term e = k.value_of("e", Elementary::exp, k.one);
  EXPECT_OPEN(k.sign(k.difference(k.power(half, 2), e), zero), "could not be decided");
  EXPECT_OPEN(k.sign(k.difference(k.power(half, 2), e), positive), "could not be decided");
}

TEST(Elementary, sine_and_cosine_of_one_number_lie_on_the_circle) {
  OfValues k;
  const Term c = k.value_of("c", Elementary::cos, k.one);
  const Term s = k.value_of("s", Elementary::sin, k.sum({k.nil, k.one}));
  const Term other = k.value_of("t", Elementary::sin, k.number(2));
  EXPECT_HOLDS(k.sign(k.difference(k.sum({k.power(c, 2), k.power(s, 2)}), k.one), zero));
  EXPECT_FAILS(k.sign(k.difference(k.sum({k.power(c, 2), k.power(other, 2)}), k.one), zero));
}

TEST(Elementary, a_logarithm_of_what_is_not_positive_is_no_number) {
  for (const char* argument : {"0", "-1", "-1/1000000000000"}) {
    OfValues k;
    k.value_of("l", Elementary::log, k.number(argument));
    EXPECT_OPEN(k.sign(k.nil, zero), "not positive");
  }
}

TEST(Elementary, a_number_that_rests_on_itself_is_rejected) {
  OfValues k;
  k.value_of("e", Elementary::exp, k.symbol("e"));
  EXPECT_OPEN(k.sign(k.nil, zero), "later one");
}

TEST(Elementary, a_number_that_rests_on_a_variable_is_rejected) {
  OfValues k;
  k.value_of("e", Elementary::exp, k.symbol("x"));
  EXPECT_OPEN(k.sign(k.nil, zero), "later one");
}

/// exp(x) is y, cos(x) is c, sin(x) is s, log(x) is l.
struct OfFunctions : Case {
  Term one = number(1), nil = number(0), x = symbol("x");
  Term y = symbol("y"), c = symbol("c"), s = symbol("s"), l = symbol("l");
  OfFunctions() {
    statement.functions = {{"y", x, 0, Elementary::exp},
                           {"c", x, 0, Elementary::cos},
                           {"s", x, 0, Elementary::sin},
                           {"l", x, 0, Elementary::log}};
  }
  Witness at(const std::string& point, const std::string& function, Term value) {
    return {{{"x", function}, {number(point), value}}, {}};
  }
};

TEST(Elementary, squares_of_sine_and_cosine_add_up_to_1_in_normal_form) {
  OfFunctions k;
  k.claim(Zero{k.difference(k.sum({k.power(k.c, 2), k.power(k.s, 2)}), k.one)});
  EXPECT_HOLDS(k.finding(Computation{}));
  k.claim(Zero{k.difference(k.sum({k.power(k.c, 2), k.power(k.y, 2)}), k.one)});
  EXPECT_OPEN(k.finding(Computation{}), "the normal form is not 0");
}

TEST(Elementary, a_value_at_a_point_is_a_known_one_or_a_number_of_the_same_function) {
  OfFunctions k;
  k.claim(Zero{k.difference(k.y, k.sum({k.one, k.x}))});
  k.evidence_begins();
  const Term e = k.symbol("e"), c = k.symbol("k");
  k.evidence.generators = {{"e", 0, {}, {}, Elementary::exp, k.one},
                           {"k", 0, {}, {}, Elementary::cos, k.one}};
  EXPECT_FAILS(k.finding(k.at("1", "y", e)));
  EXPECT_OPEN(k.finding(k.at("2", "y", e)), "not seen to be that of its function");
  EXPECT_OPEN(k.finding(k.at("1", "y", c)), "not seen to be that of its function");
  EXPECT_OPEN(k.finding(k.at("1", "y", k.number(3))), "not seen to be that of its function");
  EXPECT_OPEN(k.finding(k.at("0", "y", k.number(1))), "is 0 at the witness");
  EXPECT_OPEN(k.finding(k.at("0", "y", k.number(2))), "not seen to be that of its function");
}

TEST(Elementary, where_a_logarithm_has_no_value_nothing_is_claimed) {
  OfFunctions k;
  k.claim(Zero{k.l});
  k.evidence_begins();
  EXPECT_OPEN(k.finding(k.at("1", "l", k.number(0))), "is 0 at the witness");
  EXPECT_OPEN(k.finding(k.at("-1", "l", k.number(1))), "not seen to be that of its function");
  EXPECT_OPEN(k.finding(k.at("0", "l", k.number(1))), "not seen to be that of its function");
}

TEST(Elementary, an_exponential_is_positive_and_a_cosine_at_most_1) {
  OfFunctions k;
  const Domain line{{k.ray("x", "0")}, {}};
  k.claim(Sign{k.y, positive, line});
  EXPECT_HOLDS(k.finding(pieces({plain()})));
  k.claim(Sign{k.difference(k.one, k.c), nonnegative, line});
  EXPECT_HOLDS(k.finding(pieces({plain()})));
  k.claim(Sign{k.difference(k.one, k.c), positive, line});
  EXPECT_OPEN(k.finding(pieces({plain()})), "");
  k.claim(Sign{k.difference(k.y, k.one), nonnegative, line});  // true, but not by this
  EXPECT_OPEN(k.finding(pieces({plain()})), "");
}

TEST(Elementary, a_logarithm_has_no_coordinate) {
  OfFunctions k;
  const Domain line{{k.ray("x", "0", true)}, {}};
  k.claim(Sign{k.sum({k.power(k.l, 2), k.one}), positive, line});
  EXPECT_OPEN(k.finding(pieces({plain()})), "");
}

TEST(Elementary, functions_of_other_operands_do_not_lie_on_the_circle) {
  OfFunctions k;
  k.statement.functions[2].operand = k.scaled(2, k.x);
  k.claim(Zero{k.difference(k.sum({k.power(k.c, 2), k.power(k.s, 2)}), k.one)});
  EXPECT_OPEN(k.finding(Computation{}), "the normal form is not 0");
}

TEST(Elementary, a_function_of_itself_is_rejected) {
  OfFunctions k;
  k.statement.functions[0].operand = k.y;
  k.claim(Zero{k.nil});
  EXPECT_OPEN(k.finding(Computation{}), "its own function");
}

}  // namespace
}  // namespace seam::check::test
