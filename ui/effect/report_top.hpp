#pragma once

#include <QImage>
#include <QString>

#include "core/report/report_head.hpp"

namespace analogon::ui {

/// The name under which a document of Qt finds the logo.
inline constexpr const char* logoResource = "picture:logo";

/// The top of a report as HTML for a document of Qt: the logo (where there is one, as the resource of that name), the
/// title, and what the head says. `study`: the study's name. Without a head it is the title and the day.
QString reportTop(const QString& study, const ReportHead& head, bool hasLogo);

/// A PNG, JPEG or SVG file, so high that it is sharp on paper; null: it cannot be read.
QImage logoPicture(const QString& file);

}  // namespace analogon::ui
