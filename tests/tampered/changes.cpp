// SPDX-License-Identifier: GPL-3.0-or-later
#include "changes.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <utility>

#include "numbers.h"

// Goes through the JSON value once. What a number or a word means is told from the name of the
// member or list that it stands in.

namespace seam::tampered {
namespace {

const std::vector<std::vector<std::string>> exchangeable = {
    {">", ">=", "=", "!=", "<=", "<"},
    {"exp", "log", "sin", "cos", "pi"},
    {"proven", "refuted", "conditional", "undecided"},
    {"counts", "face_sizes", "valences", "valence", "connected", "closed", "manifold",
     "orientable", "oriented", "planar", "convex"}};
const std::vector<std::pair<std::string, std::string>> other_names = {
    {"sum", "product"},  {"product", "sum"},
    {"all", "any"},      {"any", "all"},
    {"above", "below"},  {"below", "above"},
    {"low", "high"},     {"numerators", "denominators"},
    {"inner", "outer"},  {"positive", "broken"},
    {"not", "suffices"}, {"suffices", "not"}};

class Walk {
 public:
  explicit Walk(const Json& certificate) : certificate_(certificate) {
    for (const char* side : {"statement", "evidence"})
      for (const Json& node : certificate.at(side).at("nodes"))
        if (node.is_object() && node.contains("symbol")) symbols_.insert(node["symbol"]);
  }

  std::vector<Change> run() {
    part_ = "verdict";
    visit(certificate_.at("verdict"), Json::json_pointer("/verdict"), "verdict");
    for (const char* side : {"statement", "evidence"})
      for (const auto& [name, value] : certificate_.at(side).items()) {
        const auto place = Json::json_pointer("") / side / name;
        const bool by_obligation = name == "obligations" || name == "proofs";
        part_ = name;
        if (!by_obligation) {
          visit(value, place, name);
          continue;
        }
        lists(value, place);
        for (std::size_t i = 0; i < value.size(); ++i) {
          part_ = std::string(name == "proofs" ? "proof of " : "") +
                  certificate_["statement"]["obligations"].at(i).begin().key();
          visit(value[i], place / i, name);
        }
      }
    return std::move(changes_);
  }

 private:
  const Json& certificate_;
  std::set<std::string> symbols_;
  std::string part_;
  std::vector<Change> changes_;

  void add(const std::string& kind, const Json::json_pointer& place,
           std::function<void(Json&)> apply) {
    changes_.push_back({kind, part_, place, std::move(apply)});
  }
  void put(const std::string& kind, const Json::json_pointer& place, Json value) {
    add(kind, place, [value = std::move(value)](Json& old) { old = value; });
  }

  void visit(const Json& value, const Json::json_pointer& place, const std::string& name) {
    if (name == "goal") goals(value, place);
    if (value.is_object()) {
      members(value, place);
      for (const auto& [inner, held] : value.items()) visit(held, place / inner, inner);
    } else if (value.is_array()) {
      lists(value, place);
      for (std::size_t i = 0; i < value.size(); ++i)
        visit(value[i], place / i, name == "power" && i == 1 ? "exponent" : name);
    } else if (value.is_boolean()) {
      put("mark flipped", place, !value.get<bool>());
    } else if (value.is_number_integer()) {
      integers(value.get<int>(), place, name);
    } else {
      words(value.get<std::string>(), place, name);
    }
  }

  void goals(const Json& value, const Json::json_pointer& place) {
    put("goal wrapped", place, {{"not", value}});
    put("goal wrapped", place, {{"suffices", value}});
    put("goal replaced", place, {{"all", Json::array()}});
  }

  void members(const Json& value, const Json::json_pointer& place) {
    for (const auto& entry : value.items()) {
      const std::string name = entry.key();
      add("field dropped", place, [name](Json& old) { old.erase(name); });
      for (const auto& [from, to] : other_names)
        if (from == name && !value.contains(to))
          put("field renamed", place, renamed(value, from, to));
        else if (from == name)
          add("fields exchanged", place,
              [from, to](Json& old) { std::swap(old[from], old[to]); });
    }
    if (value.contains("square"))
      add("square dropped", place, [](Json& old) {
        old.erase("square");
        old.erase("cofactor");
      });
    if (value.contains("outside") && value.size() == 1) put("step changed", place, "plain");
  }

  static Json renamed(const Json& value, const std::string& from, const std::string& to) {
    Json result = Json::object();
    for (const auto& [name, held] : value.items()) result[name == from ? to : name] = held;
    return result;
  }

  void lists(const Json& value, const Json::json_pointer& place) {
    const std::size_t n = value.size();
    if (n > 1) put("list emptied", place, Json::array());
    for (std::size_t i = 0; i < n; ++i) {
      const auto at = static_cast<long>(i);
      add("element dropped", place, [at](Json& old) { old.erase(old.begin() + at); });
      add("element doubled", place, [at](Json& old) {
        const Json copy = old[static_cast<std::size_t>(at)];
        old.insert(old.begin() + at, copy);
      });
      for (const std::size_t other : {i + 1, i + n / 2})
        if (other < n)
          add("two exchanged", place, [i, other](Json& old) { std::swap(old[i], old[other]); });
      if (i + 1 < n)
        add("element put for the next", place, [i](Json& old) { old[i + 1] = Json(old[i]); });
    }
  }

  void integers(int value, const Json::json_pointer& place, const std::string& name) {
    static const std::set<std::string> exponents = {"exponent", "multiplicities", "power",
                                                    "degree"};
    static const std::set<std::string> counts = {"euler", "vertices"};
    const std::string kind = name == "corners"          ? "corner of a domain changed"
                             : name == "polynomial"     ? "generator polynomial changed"
                             : name == "goal"           ? "goal changed"
                             : exponents.contains(name) ? "exponent changed"
                             : counts.contains(name) || (name == "values" && part_ == "mesh")
                                 ? "count changed"
                                 : "index changed";
    for (const int other : std::set{value + 1, value - 1, 0, 1, -1})
      if (other != value) put(kind, place, other);
  }

  void words(const std::string& value, const Json::json_pointer& place,
             const std::string& name) {
    if (value == "plain") {
      for (const int i : {0, 1, 2}) put("step changed", place, {{"outside", i}});
      return;
    }
    for (const auto& words : exchangeable)
      if (std::ranges::find(words, value) != words.end())
        for (const std::string& other : words)
          if (other != value)
            put(name == "verdict"    ? "verdict changed"
                : name == "property" ? "property changed"
                : name == "function" ? "function changed"
                                     : "relation changed",
                place, other);
    if (name == "symbol" || name == "name" || name == "unknown" || name == "unknowns" ||
        name == "variables" || name == "for_all") {
      auto next = symbols_.upper_bound(value);
      if (next == symbols_.end()) next = symbols_.begin();
      if (next != symbols_.end() && *next != value) put("symbol changed", place, *next);
      put("symbol changed", place, value + "'");
    }
    if (!is_number(value)) return;
    const bool is_end = name == "low" || name == "high";
    put(is_end ? "interval turned" : "sign flipped", place, negated(value));
    for (const std::string& other : nearby(value))
      put(is_end ? "interval moved or widened" : "number off by a little", place, other);
    for (const std::string& other : with_other_digits(value))
      put("digit changed", place, other);
  }
};

}  // namespace

std::vector<Change> changes(const Json& certificate) {
  return Walk(certificate).run();
}

}  // namespace seam::tampered
