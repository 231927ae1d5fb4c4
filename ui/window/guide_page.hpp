#pragma once

#include <QPointer>
#include <QWidget>

class QTextBrowser;

namespace analogon::ui {

/// The user guide, inside the program.
class GuidePage : public QWidget {
    Q_OBJECT

public:
    explicit GuidePage(QWidget* parent = nullptr);
    QTextBrowser* browser() const { return browser_; }
    /// Where one was: the page that was shown, and what had the keys.
    struct Before {
        QPointer<QWidget> page, focus;
    };
    void comeFrom(const Before& before) { before_ = before; }
    const Before& before() const { return before_; }

Q_SIGNALS:
    void left();

private:
    QTextBrowser* browser_;
    Before before_;
};

/// Where the guide lies: beside the program, or in the source tree it was built from; empty: nowhere.
QString guideFile();

}  // namespace analogon::ui
