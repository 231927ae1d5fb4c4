#pragma once

#include <QLineEdit>
#include <optional>

namespace analogon::ui {

class Document;

/// Until when the model is simulated by itself [s]: the StopTime of its annotation `experiment`, which typing writes as
/// one undoable edit. What is no time above 0 is coloured, and changes nothing.
class StopField : public QLineEdit {
    Q_OBJECT

public:
    explicit StopField(Document& document, QWidget* parent = nullptr);

private:
    void refresh();
    void apply();
    std::optional<double> typed() const;

    Document& document_;
};

}  // namespace analogon::ui
