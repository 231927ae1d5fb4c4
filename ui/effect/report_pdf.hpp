#pragma once

#include <QImage>
#include <QString>
#include <vector>

#include "ui/document/document.hpp"

namespace analogon::ui {

/// The report on paper: what was found, before and after, parameters, evidence, what was tried, and the pictures
/// given. Empty: done; else why not.
QString writeReportPdf(const QString& file, const QString& title, RunKind kind, const Finding& finding,
                       const std::vector<QImage>& pictures);

}  // namespace analogon::ui
