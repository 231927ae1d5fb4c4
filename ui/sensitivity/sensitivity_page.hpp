#pragma once

#include <QWidget>
#include <memory>

#include "core/study/sensitivity.hpp"
#include "ui/job/job.hpp"

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace analogon::ui {

class Document;
class SignalChart;

/// What the recordings say of the parameters together: how their estimates go with each other (the correlation matrix),
/// and how far each trace moves with each of them. Of the fitted values where a fit or a search is shown, else of the
/// present ones; worked out beside the window, and anew when the study changes while the page is seen.
class SensitivityPage : public QWidget {
    Q_OBJECT

public:
    explicit SensitivityPage(Document& document, QWidget* parent = nullptr);

    QTableWidget* matrix() const { return matrix_; }
    SignalChart* chart() const { return chart_; }
    QLabel* legend() const { return legend_; }
    QComboBox* traceBox() const { return trace_; }
    QComboBox* measureBox() const { return measure_; }
    QPushButton* closeButton() const { return close_; }
    QLabel* caption() const { return caption_; }
    const Sensitivity* shown() const { return shown_.get(); }

Q_SIGNALS:
    void left();
    void parameterChosen(const QString& name);

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void layOut();
    void workOut();
    void show(Outcome<Sensitivity> found, bool isOfFit);
    void fillMatrix();
    void draw();

    Document& document_;
    JobRunner worker_;
    QLabel *caption_, *legend_;
    QTableWidget* matrix_;
    QComboBox *trace_, *measure_;
    SignalChart* chart_;
    QPushButton* close_;
    std::shared_ptr<const Sensitivity> shown_;
    bool isOwed_{true};  // something changed while nobody saw the page
};

}  // namespace analogon::ui
