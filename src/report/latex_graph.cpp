// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/latex_graph.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <vector>

#include "report/escape.h"
#include "report/latex_claim.h"

// A layered drawing: a claim stands one column to the right of the last that it rests on; a
// line over several columns has a place in each that it passes; within a column all are ordered
// by the mean height of what they rest on, so that few lines cross. `using` has no circles.

namespace seam::report {
namespace {

constexpr std::size_t most_claims = 60, most_columns = 5;

struct Node {
  const ClaimRun* claim = nullptr;  // null: a line passes here
  std::vector<std::size_t> rests_on;
  std::size_t column = 0;
  double height = 0;
};

// In file order, which is not the order of resting on each other.
std::vector<Node> nodes_of(const FileRun& file) {
  const std::vector<const ClaimRun*> all = claims(file);
  const auto is_used = [&](const std::string& id) {
    return std::ranges::any_of(all, [&](const ClaimRun* claim) {
      return std::ranges::find(claim->using_claims, id) != claim->using_claims.end();
    });
  };
  std::vector<Node> nodes;
  for (const ClaimRun* claim : all)
    if (!claim->using_claims.empty() || is_used(claim->id)) nodes.push_back({claim, {}, 0, 0});
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < nodes.size(); ++i) places[nodes[i].claim->id] = i;
  for (Node& node : nodes)
    for (const std::string& id : node.claim->using_claims)
      if (const auto place = places.find(id); place != places.end())
        node.rests_on.push_back(place->second);
  return nodes;
}

// The longest way to each; after as many rounds as there are nodes nothing changes any more.
std::size_t put_in_columns(std::vector<Node>& nodes) {
  std::size_t columns = 0;
  for (std::size_t round = 0; round < nodes.size(); ++round)
    for (Node& node : nodes) {
      for (const std::size_t used : node.rests_on)
        node.column = std::max(node.column, nodes[used].column + 1);
      columns = std::max(columns, node.column + 1);
    }
  return columns;
}

// A node in each column that a line passes.
void add_passages(std::vector<Node>& nodes) {
  for (std::size_t i = 0, claims = nodes.size(); i < claims; ++i)
    for (std::size_t k = 0; k < nodes[i].rests_on.size(); ++k) {
      std::size_t from = nodes[i].rests_on[k];
      for (; nodes[from].column + 1 < nodes[i].column; from = nodes.size() - 1)
        nodes.push_back({nullptr, {from}, nodes[from].column + 1, 0});
      nodes[i].rests_on[k] = from;
    }
}

void put_in_rows(std::vector<Node>& nodes, std::size_t columns) {
  for (std::size_t column = 0; column < columns; ++column) {
    std::vector<Node*> here;
    for (Node& node : nodes)
      if (node.column == column) here.push_back(&node);
    for (Node* node : here) {
      for (const std::size_t used : node->rests_on) node->height += nodes[used].height;
      if (!node->rests_on.empty()) node->height /= static_cast<double>(node->rests_on.size());
    }
    std::ranges::stable_sort(here, {}, &Node::height);
    for (std::size_t i = 0; i < here.size(); ++i)
      here[i]->height = static_cast<double>(i) - static_cast<double>(here.size() - 1) / 2;
  }
}

std::string position(double x, double y) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "(%.2f,%.2f)", x, y);
  return buffer;
}

// A claim in its frame, or a line that passes between two points.
std::string drawn(const Node& node, const std::string& name, double left, double right,
                  double height) {
  if (!node.claim)
    return "\\draw[seamquiet] " + position(left, height) + " coordinate (" + name +
           "west) -- " + position(right, height) + " coordinate (" + name + "east);\n";
  return "\\node[anchor=west,draw=seamquiet,rounded corners=2pt,inner sep=3pt] (" + name +
         ") at " + position(left, height) + " {\\SeamMark{" +
         word(node.claim->printed.verdict) + "}" + latex_claim_link(*node.claim) +
         "};\n\\coordinate (" + name + "west) at (" + name + ".west);\\coordinate (" + name +
         "east) at (" + name + ".east);\n";
}

}  // namespace

std::string latex_graph(const FileRun& file) {
  constexpr double width_of_letter = 0.18, height_of_row = 0.75, gap = 1.6;  // centimetres
  std::vector<Node> nodes = nodes_of(file);
  if (nodes.empty() || nodes.size() > most_claims) return "";
  const std::size_t columns = put_in_columns(nodes);
  if (columns > most_columns) return "";
  add_passages(nodes);
  put_in_rows(nodes, columns);

  std::vector<double> left(columns + 1, 0);
  for (std::size_t column = 0; column < columns; ++column) {
    std::size_t longest = 0;
    for (const Node& node : nodes)
      if (node.claim && node.column == column)
        longest = std::max(longest, node.claim->id.size());
    left[column + 1] = left[column] + width_of_letter * static_cast<double>(longest) + gap;
  }
  const auto name = [](std::size_t i) { return "c" + std::to_string(i); };
  std::string result = "\\par\\medskip\\SeamFit{\\begin{tikzpicture}\n";
  for (std::size_t i = 0; i < nodes.size(); ++i)
    result += drawn(nodes[i], name(i), left[nodes[i].column], left[nodes[i].column + 1] - gap,
                    -height_of_row * nodes[i].height);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (const std::size_t used : nodes[i].rests_on)
      result += std::string("\\draw[") + (nodes[i].claim ? "->," : "") + "seamquiet] (" +
                name(used) + "east) to[out=0,in=180] (" + name(i) + "west);\n";
  return result + "\\end{tikzpicture}}\n";
}

}  // namespace seam::report
