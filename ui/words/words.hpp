#pragma once

#include <QString>

#include "core/base/text.hpp"

namespace analogon::ui {

/// What the core says, in the language of the screen: the translation of its pattern with its arguments, which are
/// translated in their turn; the English text where there is no translation.
QString inWords(const Text& text);

}  // namespace analogon::ui
