#pragma once

#include <QFrame>
#include <QIcon>
#include <functional>
#include <vector>

class QLabel;
class QLineEdit;
class QListWidget;

namespace analogon::ui {

/// One line of a chooser.
struct Choice {
    QString text, detail, key;
    QIcon icon;
    QString further{};  // by which it is found as well
};

/// A small list with a search field over the diagram: for naming a block to place, a connector to connect. Type to
/// search, arrows to choose, Enter takes it, Escape leaves.
class Chooser : public QFrame {
    Q_OBJECT

public:
    explicit Chooser(QWidget* parent);

    /// `chosen` gets the key. Shown in the middle of the parent.
    void choose(const QString& title, std::vector<Choice> choices, const QString& typed,
                std::function<void(const QString&)> chosen);
    /// Asks for a text, starting from one.
    void ask(const QString& title, const QString& text, std::function<void(const QString&)> entered);
    /// The same where the text stands: over that rectangle, in the parent's pixels. Empty: in the middle.
    void askInPlace(const QRect& textRect, const QString& title, const QString& text,
                    std::function<void(const QString&)> entered);
    QLineEdit* field() const { return field_; }
    QListWidget* list() const { return list_; }

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void filter();
    void take();
    void leave();
    void place();

    QLabel* title_;
    QLineEdit* field_;
    QListWidget* list_;
    std::vector<Choice> choices_;
    std::function<void(const QString&)> chosen_;
    bool isAsking_{};
    QRect inPlaceOf_;  // empty: in the middle
};

}  // namespace analogon::ui
