#pragma once

#include <QWidget>

class QTextBrowser;

namespace analogon::ui {

/// The user guide, inside the program.
class GuidePage : public QWidget {
    Q_OBJECT

public:
    explicit GuidePage(QWidget* parent = nullptr);
    QTextBrowser* browser() const { return browser_; }

Q_SIGNALS:
    void left();

private:
    QTextBrowser* browser_;
};

/// Where the guide lies: beside the program, or in the source tree it was built from; empty: nowhere.
QString guideFile();

}  // namespace analogon::ui
