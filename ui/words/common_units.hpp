#pragma once

#include <QStringList>
#include <string>

namespace analogon::ui {

/// Units engineers use at the bench that measure the same as one, itself first; of an empty one all of them.
QStringList unitsLike(const std::string& unit);

/// Why a text is no unit that is known here, with the one it may stand for; empty: it is one.
QString whyNoUnit(const std::string& text);

}  // namespace analogon::ui
