#pragma once

#include <QFileDialog>
#include <QFileInfo>

#include "ui/window/settings.hpp"

namespace analogon::ui {

inline constexpr const char* folderKey = "window/folder";

/// A dialog beside the window. It begins where the last one ended, in this start or in an earlier one.
template <class Dialog = QFileDialog>
Dialog* fileDialog(QWidget* window, Settings& settings, const QString& title, const QString& name) {
    auto* dialog = new Dialog(window, title);
    dialog->setObjectName(name);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setModal(false);
    const QString folder = settings.value(folderKey).toString();
    if (!folder.isEmpty() && QFileInfo(folder).isDir()) dialog->setDirectory(folder);
    const auto remember = [&settings](const QString& path) {
        settings.setValue(folderKey, QFileInfo(path).absolutePath());
    };
    QObject::connect(dialog, &QFileDialog::fileSelected, dialog, remember);
    QObject::connect(dialog, &QFileDialog::filesSelected, dialog, [remember](const QStringList& paths) {
        if (paths.size() > 1) remember(paths.front());  // of one alone the other signal tells
    });
    return dialog;
}

}  // namespace analogon::ui
