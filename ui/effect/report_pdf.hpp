#pragma once

#include <QImage>
#include <QString>
#include <optional>
#include <vector>

#include "core/report/diagram_svg.hpp"
#include "core/report/report_head.hpp"
#include "ui/document/document.hpp"

namespace analogon::ui {

/// What paper shows beside words.
struct ReportPictures {
    std::vector<QImage> plots{};
    QImage logo{};                          // null: none
    std::optional<DiagramPair> diagrams{};  // empty: the model stayed as it was
};

/// The report on paper as HTML: what was found, before and after, what to mind, the diagram before and after,
/// parameters, evidence, what remains, what was tried; under its head and with the sections that this has (those that
/// paper has).
QString reportBody(const QString& title, RunKind kind, const Finding& finding, const ReportPictures& pictures,
                   const ReportHead& head = {});

/// The same as a file. Empty: done; else why not.
QString writeReportPdf(const QString& file, const QString& title, RunKind kind, const Finding& finding,
                       const ReportPictures& pictures, const ReportHead& head = {});

}  // namespace analogon::ui
