#pragma once

#include <QString>

namespace analogon::ui {

/// Whether each word that was typed is found in a text: as it was typed, anywhere, or in a word of the same meaning,
/// English or German. Capitals and ways to write an umlaut make no difference. Nothing typed is found in everything.
bool isFoundIn(const QString& text, const QString& typed);

}  // namespace analogon::ui
