#pragma once

#include <QImage>
#include <QString>
#include <vector>

#include "core/report/report_head.hpp"
#include "ui/document/document.hpp"

namespace analogon::ui {

/// The report on paper as HTML: what was found, before and after, what to mind, parameters, evidence, what remains,
/// what was tried; with so many pictures, under its head and with the sections that this has (those that paper has).
QString reportBody(const QString& title, RunKind kind, const Finding& finding, std::size_t pictures,
                   const ReportHead& head = {}, bool hasLogo = false);

/// The same as a file with the pictures given. Empty: done; else why not.
QString writeReportPdf(const QString& file, const QString& title, RunKind kind, const Finding& finding,
                       const std::vector<QImage>& pictures, const ReportHead& head = {}, const QImage& logo = {});

}  // namespace analogon::ui
