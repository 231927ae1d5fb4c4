#pragma once

#include <QString>

#include "core/report/diagram_svg.hpp"

class QTextDocument;

namespace analogon::ui {

/// The model before and after on paper, with a legend of what is outlined; as HTML, whose pictures `addDiagrams` gives.
QString diagramsOnPaper(const DiagramPair& pair);
void addDiagrams(QTextDocument& document, const DiagramPair& pair);

}  // namespace analogon::ui
