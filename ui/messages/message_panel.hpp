#pragma once

#include <QWidget>

class QLabel;
class QListWidget;
class QStackedLayout;

namespace analogon {
struct Place;
}

namespace analogon::ui {

class Document;
struct Mention;
struct Message;

/// What is wrong or worth knowing. A click leads to the place.
class MessagePanel : public QWidget {
    Q_OBJECT

public:
    explicit MessagePanel(Document& document, QWidget* parent = nullptr);
    QListWidget* list() const { return list_; }
    /// Marks the first error. A run was asked for: what is not finished is an error by now, until it is mended.
    void pointAtError();

Q_SIGNALS:
    void placeChosen(const analogon::Place& place);
    /// Of a message without a place in a file: what it speaks of.
    void mentionChosen(const analogon::ui::Mention& mention);
    void countChanged(int errors, int others);

private:
    void refresh();
    bool isHint(const Message& message) const;

    Document& document_;
    QListWidget* list_;
    QStackedLayout* pages_;
    bool isRunAsked_{};
};

}  // namespace analogon::ui
