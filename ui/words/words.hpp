#pragma once

#include <QString>
#include <functional>

#include "core/base/text.hpp"

namespace analogon::ui {

/// What the core says, in the language of the screen: the translation of its pattern with its arguments, which are
/// translated in their turn (numbers have the decimal sign of the language); the English text where there is no
/// translation.
QString inWords(const Text& text);

/// What the block library says of a class or a parameter, in the language of the screen.
QString libraryText(const std::string& description);

/// The same of a documentation: HTML of which each paragraph has its translation. Formulas stay as they are.
QString libraryDocumentation(const QString& html);

/// The names and numbers among its arguments, in the order of the English sentence.
QStringList namesIn(const Text& text);

/// The same words as HTML, in which a name is a link where there is a target for it (empty: none).
QString linkedWords(const Text& text, const std::function<QString(const QString& name)>& target);

}  // namespace analogon::ui
