// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/mutation.h"

#include <algorithm>
#include <utility>

#include "claims/excerpt.h"
#include "claims/mutants_of_node.h"

// The walk goes once over each tree, with the names that may stand at each place: those defined
// in earlier items and those bound around it. So a mutant refers to nothing that comes later.

namespace seam::claims {
namespace {

using Kind = Expression::Kind;

class Walk {
 public:
  explicit Walk(const File& file) : file_(file) {}

  std::vector<Mutation> all() {
    for (item_ = 0; item_ < file_.items.size(); ++item_) {
      const Item& item = file_.items[item_];
      part_ = 0;
      for (const Expression* e : expressions_of(item)) {
        NodeContext context;
        context.known = &known_;
        context.bound = item.parameters;
        for (const Expression& column : item.columns) add_bound(column, context.bound);
        context.is_set =
            (item.kind == Item::Kind::param && part_ == 0 && !item.expressions.empty()) ||
            (item.kind == Item::Kind::root && part_ == 1);
        visit(*e, context);
        ++part_;
      }
      for (const std::string& name : item.names) known_.push_back({name, &item});
      if (item.names.empty()) known_.push_back({item.name, &item});
    }
    return std::move(found_);
  }

 private:
  void visit(const Expression& e, const NodeContext& context) {
    for (auto& [kind, instead] : mutants_of_node(e, context))
      if (!same(e, instead)) found_.push_back({kind, item_, part_, path_, std::move(instead)});
    NodeContext inside = context;
    inside.parent = &e;
    for (const Expression& child : e.children)
      if (child.kind == Kind::binding) add_bound(child, inside.bound);
    if (e.kind == Kind::solve) add_bound(e.children[0], inside.bound);
    if (e.kind == Kind::limit) inside.bound.push_back(e.text);
    for (std::size_t i = 0; i < e.children.size(); ++i) {
      if (is_list_of_names(e, i)) continue;
      inside.child = i;
      inside.is_set = e.kind == Kind::binding && e.text == "in" && i == 1;
      inside.is_in_set = context.is_set;
      path_.push_back(i);
      visit(e.children[i], inside);
      path_.pop_back();
    }
  }

  static bool is_list_of_names(const Expression& e, std::size_t child) {
    if (child != 0) return false;
    return e.kind == Kind::binding ||
           (e.kind == Kind::solve &&
            std::ranges::all_of(e.children[0].children,
                                [](const auto& c) { return c.kind == Kind::name; }));
  }

  static void add_bound(const Expression& e, std::vector<std::string>& bound) {
    if (e.kind == Kind::name) bound.push_back(e.text);
    if (e.kind == Kind::binding) return add_bound(e.children[0], bound);
    if (e.kind == Kind::list || e.kind == Kind::tuple)
      for (const Expression& child : e.children) add_bound(child, bound);
  }

  const File& file_;
  std::vector<KnownName> known_;
  std::vector<Mutation> found_;
  std::size_t item_ = 0, part_ = 0;
  std::vector<std::size_t> path_;
};

Expression& at(Expression& root, const std::vector<std::size_t>& path, std::size_t depth) {
  Expression* e = &root;
  for (std::size_t i = 0; i < depth; ++i) e = &e->children[path[i]];
  return *e;
}

}  // namespace

std::vector<Mutation> mutations(const File& file) {
  return Walk(file).all();
}

File mutated(const File& file, const Mutation& mutation) {
  File result = file;
  Expression& root = *expressions_of(result.items[mutation.item])[mutation.part];
  Expression& place = at(root, mutation.path, mutation.path.size());
  const text::Span span = place.span;
  place = mutation.instead;
  place.span = span;
  return result;
}

Difference difference(const File& file, const Mutation& mutation) {
  constexpr std::size_t at_a_glance = 72, too_short = 12, too_long = 240;
  File before = file, after = mutated(file, mutation);
  const auto root = [&](File& f) -> Expression& {
    return *expressions_of(f.items[mutation.item])[mutation.part];
  };
  const std::size_t depth = mutation.path.size();
  Difference result{at(root(before), mutation.path, depth).span, {}, {}};
  for (std::size_t d = depth + 1; d-- > 0;) {
    // A binding and what stands in it can only be printed with what is round it.
    const Kind kind = at(root(before), mutation.path, d).kind;
    if (kind == Kind::binding || kind == Kind::named || kind == Kind::control) continue;
    std::string was = format(at(root(before), mutation.path, d));
    std::string is = format(at(root(after), mutation.path, d));
    const std::size_t most = result.before.size() < too_short ? too_long : at_a_glance;
    if (!result.before.empty() && std::max(was.size(), is.size()) > most) break;
    result.before = std::move(was);
    result.after = std::move(is);
  }
  return result;
}

}  // namespace seam::claims
