#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;
class QStackedLayout;
class QTableView;
class QToolButton;

namespace analogon::ui {

class Document;
class Knob;
class ParameterModel;
struct Mention;

/// Table of parameters with a search field; follows the block that is selected in the diagram.
class ParameterPanel : public QWidget {
    Q_OBJECT

public:
    explicit ParameterPanel(Document& document, QWidget* parent = nullptr);

    void showComponent(const QString& component);
    /// Marks a parameter, whatever search or filter was hiding it.
    void pointAt(const QString& name);
    /// What is to be known of the marked one.
    QLabel* note() const { return note_; }
    QLabel* fault() const { return fault_; }
    QTableView* table() const { return table_; }
    /// Turns the marked one.
    Knob* knob() const { return knob_; }
    ParameterModel* model() const { return model_; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void updateState();
    void updateFault();
    void fitColumns();
    void updateNote();
    void showMenu(QPoint at);

    Document& document_;
    ParameterModel* model_;
    QTableView* table_;
    Knob* knob_;
    QLineEdit* search_;
    QToolButton* chip_;  // the selected component; a click shows all again
    QToolButton* onlyFitted_;
    QStackedLayout* pages_;
    QLabel *empty_, *note_;
    QLabel* fault_;  // that the model has an error, above what its text tells all the same
    QString component_;
    bool wantsPriors_{};  // asked for, though no parameter has one yet

Q_SIGNALS:
    void componentCleared();
    /// Something that the note speaks of.
    void mentionChosen(const analogon::ui::Mention& mention);
};

}  // namespace analogon::ui
