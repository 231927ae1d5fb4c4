#pragma once

#include <QWidget>

#include "ui/document/recovery.hpp"

namespace analogon::ui {

/// Offers one piece of work that an ended program left behind: open it, or throw it away.
class RecoveredLine : public QWidget {
    Q_OBJECT

public:
    explicit RecoveredLine(Recovered recovered, QWidget* parent = nullptr);

Q_SIGNALS:
    void chosen(const analogon::ui::Recovered& recovered);
    void discarded();
};

}  // namespace analogon::ui
