// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <type_traits>

#include "report/run.h"

// The fields of a run under their names in results.json, said once for writing and reading: an
// archive is called with a name and a field. A name of the contract is in json.cpp.
namespace seam::report {

template <typename T, typename Plain>
concept Some = std::same_as<std::remove_const_t<T>, Plain>;

template <typename Archive, Some<Slack> T>
void fields(Archive& archive, T& slack) {
  archive("low", slack.low);
  archive("high", slack.high);
  archive("at", slack.at);
  archive("of", slack.of);
  archive("unknown", slack.unknown);
}

template <typename Archive, Some<ObligationRun> T>
void fields(Archive& archive, T& obligation) {
  archive("about", obligation.about);
  archive("kind", obligation.kind);
  archive("latex", obligation.latex);
  archive("text", obligation.text);
  archive("guard", obligation.guard);
  archive("status", obligation.status);
  archive("evidence", obligation.evidence);
  archive("slack", obligation.slack);
}

/// What a statement and a claim have beside the keys of the contract.
template <typename Archive, Some<Outcome> T>
void fields(Archive& archive, T& outcome) {
  archive("text", outcome.text);
  archive("latex", outcome.latex);
  archive("digest", outcome.digest);
  archive("findings", outcome.obligations);
}

template <typename Archive, Some<Confirmation> T>
void fields(Archive& archive, T& confirmation) {
  archive("digest", confirmation.digest);
  archive("certificate", confirmation.certificate);
  archive("alarm", confirmation.alarm);
}

template <typename Archive, Some<ClaimRun> T>
void fields(Archive& archive, T& claim) {
  archive("title", claim.title);
  archive("at", claim.at);
  archive("comments", claim.comments);
  archive("included", claim.included);
  archive("line", claim.line);
  archive("column", claim.column);
  archive("true_digits", claim.true_digits);
  archive("digits_confirmed", claim.digits_confirmed);
  archive("predicates", claim.predicates);
  archive("definitions", claim.definitions);
}

template <typename Archive, Some<DefinitionRun> T>
void fields(Archive& archive, T& definition) {
  archive("names", definition.names);
  archive("text", definition.text);
  archive("latex", definition.latex);
  archive("is_parameter", definition.is_parameter);
  archive("comments", definition.comments);
}

template <typename Archive, Some<SectionRun> T>
void fields(Archive& archive, T& section) {
  archive("title", section.title);
}

template <typename Archive, Some<FigureRun::Line> T>
void fields(Archive& archive, T& line) {
  archive("kind", line.kind);
  archive("points", line.points);
}

template <typename Archive, Some<FigureRun::Mark> T>
void fields(Archive& archive, T& mark) {
  archive("at", mark.at);
  archive("label", mark.label);
}

template <typename Archive, Some<FigureRun> T>
void fields(Archive& archive, T& figure) {
  archive("id", figure.id);
  archive("title", figure.title);
  archive("at", figure.at);
  archive("coloured_by", figure.coloured_by);
  archive("coloured_by_latex", figure.coloured_by_latex);
  archive("note", figure.note);
  archive("closed", figure.closed);
  archive("points", figure.points);
  archive("normals", figure.normals);
  archive("values", figure.values);
  archive("triangles", figure.triangles);
  archive("lines", figure.lines);
  archive("marks", figure.marks);
}

template <typename Archive, Some<AskRun> T>
void fields(Archive& archive, T& ask) {
  archive("text", ask.text);
  archive("latex", ask.latex);
  archive("confirmed", ask.confirmed);
}

template <typename Archive, Some<ErrorRun> T>
void fields(Archive& archive, T& error) {
  archive("message", error.message);
  archive("hint", error.hint);
  archive("included", error.included);
  archive("line", error.line);
  archive("column", error.column);
}

template <typename Archive, Some<WarningRun> T>
void fields(Archive& archive, T& warning) {
  archive("rule", warning.rule);
  archive("claim", warning.claim);
  archive("message", warning.message);
  archive("hint", warning.hint);
  archive("included", warning.included);
  archive("line", warning.line);
  archive("column", warning.column);
}

template <typename Archive, Some<TableRun::Row> T>
void fields(Archive& archive, T& row) {
  archive("label", row.label);
  archive("latex", row.latex);
  archive("printed", row.printed);
}

template <typename Archive, Some<TableRun> T>
void fields(Archive& archive, T& table) {
  archive("id", table.id);
  archive("title", table.title);
  archive("at", table.at);
  archive("labels", table.labels);
  archive("comments", table.comments);
}

template <typename Archive, Some<FileRun> T>
void fields(Archive& archive, T& file) {
  archive("by", file.by);
  archive("source", file.source);
  archive("year", file.year);
  archive("errors", file.errors);
  archive("warnings", file.warnings);
}

}  // namespace seam::report
