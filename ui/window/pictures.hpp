#pragma once

#include <QString>

namespace analogon::ui {

/// Pictures of the window at work, in light and dark, English and German, empty and filled, for the guide and for
/// people who look after the layout. The scale is that of the process (QT_SCALE_FACTOR). In one language; empty: in
/// all. False: one could not be made.
bool writePictures(const QString& directory, const QString& language = {});

}  // namespace analogon::ui
