// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "prove/nonvanishing.h"

namespace seam::prove {

/// base^exponent.
struct Power {
  exact::Polynomial base;
  int exponent = 1;
};

/// multiplier * f = product of powers.
struct Product {
  exact::Polynomial multiplier;
  std::vector<Power> powers;
};

/// Splits f, which is not 0, as far as it can be seen; the solutions that are claimed are tried
/// too.
Product factored(const exact::Polynomial& f, const Equations&);

/// What is known at a node of the search: `certificate::Elimination`.
struct Facts {
  /// To be worked on: known equation number `equation`, times a number, is the product of
  /// powers, any of which may vanish.
  struct Open {
    int equation = 0;
    Product product;
  };
  /// An equation that gives a variable by those not solved before; its initial vanishes
  /// nowhere.
  struct Solved {
    int variable = 0, equation = 0;
  };
  std::vector<exact::Polynomial> equations;
  Nonvanishing::Conditions conditions;
  std::vector<Open> open;
  std::vector<Solved> solved;
};

/// Looks for an elimination: equations are solved for one variable after another, and fall
/// apart into cases where they are products.
class Eliminator {
 public:
  /// `leftover` sees every set of facts that is solved but is no claimed solution, nor
  /// excluded. It returns true to stop the search.
  using Leftover = std::function<bool(const Facts&)>;

  Eliminator(Workshop&, const Equations&, Leftover);

  /// The elimination, if all cases came to an end.
  std::optional<certificate::Elimination> run();
  /// Why not.
  const certificate::Nothing& reason() const { return reason_; }

 private:
  using Combination = std::vector<std::pair<int, exact::Polynomial>>;  // equation, cofactor
  /// Product of initials^powers * f = combination + remainder.
  struct Reduction {
    std::vector<Power> initials;
    Combination combination;
    exact::Polynomial remainder;
  };
  struct Pivot {
    std::size_t place = 0;  // in `open`
    int variable = 0, degree = 0;
    bool is_sure = false;  // the initial vanishes nowhere
  };
  enum class Outcome { goes_on, closed, failed };

  bool solve(Facts);
  bool branch(const Facts&, std::size_t place);
  bool distinguish(const Facts&, const exact::Polynomial&);
  /// From `f` = combination: a step, and `f` without what vanishes nowhere as an open equation.
  Outcome derive(Facts&, Combination, const exact::Polynomial& f);
  Outcome refresh(Facts&);
  Outcome reduce(Facts&, const Pivot&);
  std::optional<Pivot> choose(const Facts&, bool linear);
  bool vanishes_nowhere(const exact::Polynomial&, const Facts&);

  bool conclude(Facts&);
  bool is_solution(Facts&, std::size_t k);
  bool is_outside(const Facts&, std::size_t condition);
  Reduction reduced(const exact::Polynomial&, const Facts&) const;

  /// Why a power vanishes nowhere; `multiplier` is scaled where its base is.
  std::optional<certificate::EliminationFactor> sure(const Power&, const Facts&,
                                                     exact::Polynomial& multiplier);
  std::vector<certificate::EliminationFactor> sure(const Reduction&, const Facts&,
                                                   exact::Polynomial& multiplier);
  void step(const Combination&, const exact::Polynomial& multiplier,
            std::vector<certificate::EliminationFactor>);
  certificate::Combination write(const Combination&, const exact::Polynomial& multiplier);
  bool give_up(std::string reason, std::string detail);

  Workshop* workshop_;
  const Equations* stated_;
  Leftover leftover_;
  Nonvanishing nonvanishing_;
  std::vector<certificate::EliminationStep> steps_;
  certificate::Nothing reason_;
  long taken_ = 0;
  bool stopped_ = false;
};

}  // namespace seam::prove
