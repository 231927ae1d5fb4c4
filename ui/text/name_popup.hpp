#pragma once

#include <QObject>
#include <string>

#include "core/library/library.hpp"

class QCompleter;
class QKeyEvent;
class QStandardItemModel;

namespace analogon::ui {

class Document;
class TextView;

/// The list of names that may be meant, at the cursor of the model's text. It comes by Ctrl+Space, behind the point of
/// a name, and with the third letter of a word. Down marks a name and Enter takes it; Tab takes the first; Enter
/// without a mark is a new line, as it is without the list; Escape closes it.
class NamePopup : public QObject {
    Q_OBJECT

public:
    NamePopup(Document& document, TextView& text);

    /// Before the text has the key; true: it is not for the text.
    bool takes(const QKeyEvent& event);
    /// After the text had the key.
    void follow(const QKeyEvent& event);
    bool isOpen() const;
    QCompleter* completer() const { return completer_; }

private:
    void learn();
    void offer(bool isAskedFor);
    void put(const QString& name);

    Document& document_;
    Library known_;      // when the text parsed last: while one types, it does not
    std::string model_;  // its class
    TextView& text_;
    QCompleter* completer_;
    QStandardItemModel* names_;
    int typed_{};
};

}  // namespace analogon::ui
