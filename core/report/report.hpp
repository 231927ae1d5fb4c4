#pragma once

#include <optional>
#include <string>

#include "core/effect/catalogue/finding.hpp"
#include "core/report/diagram_svg.hpp"
#include "core/report/report_head.hpp"

namespace analogon {

struct ReportContext {
    std::string title;    // study name
    std::string command;  // "simulate", "fit" or "discover"
    std::string version;
    ReportHead head{};                      // of the page; empty: it is called as the study is, with all sections
    std::string logoUri{};                  // of the picture that the head names (core/report/logo)
    std::optional<DiagramPair> diagrams{};  // empty: the model stayed as it was
};

/// report.json (contract, section 6). NaN and infinity are written as null.
std::string reportJson(const Finding& finding, const ReportContext& context);

/// Self-contained page: its head, before/after table, the diagram before and after, measured against simulated before
/// and after with the residual below (inline SVG, decimated), parameter table with standard errors, effects with their
/// evidence, what was tried and why it was taken or not, warnings. No script from outside, light and dark.
std::string reportHtml(const Finding& finding, const ReportContext& context);

/// traces.csv: one row per sample and experiment; time, then per output measured, before, after. A header that a
/// spreadsheet could read as a formula is escaped.
std::string tracesCsv(const Finding& finding);

/// The before/after table for a terminal.
std::string summaryText(const Finding& finding);

}  // namespace analogon
