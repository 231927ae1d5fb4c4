#pragma once

#include <QTimer>
#include <QWidget>

#include "ui/signals/signal_model.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;
class QTreeView;

namespace analogon::ui {

class Document;

/// All signals of the study, to search in and to take into the plots: with the mouse, by a double click or by Enter.
class SignalBrowser : public QWidget {
    Q_OBJECT

public:
    explicit SignalBrowser(Document& document, QWidget* parent = nullptr);

    QLineEdit* searchField() const { return search_; }
    QLineEdit* formulaField() const { return formula_; }
    QComboBox* recordingBox() const { return recording_; }
    QTreeView* tree() const { return tree_; }
    const SignalModel& model() const { return *model_; }

Q_SIGNALS:
    /// To be shown, together on one axis.
    void wanted(const std::vector<SignalRef>& references);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void follow();
    void refresh();
    void showSearch();
    void send();
    void addFormula();

    Document& document_;
    SignalModel* model_;
    QLineEdit *search_, *formula_;
    QComboBox* recording_;
    QTreeView* tree_;
    QLabel *count_, *fault_;
    QToolButton *show_, *add_;
    bool isSimulated_{};   // the model by itself, beside its recordings
    bool isBehind_{true};  // something has changed since they were listed
    QTimer refreshing_;
};

}  // namespace analogon::ui
