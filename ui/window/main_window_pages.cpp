#include <QStatusBar>
#include <QTabWidget>
#include <QTableWidget>

#include "ui/campaign/campaign_window.hpp"
#include "ui/document/document.hpp"
#include "ui/document/mention.hpp"
#include "ui/fit/run_controller.hpp"
#include "ui/measurement/compare_page.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/measurement/recordings_page.hpp"
#include "ui/measurement/values_page.hpp"
#include "ui/plot/plot_panel.hpp"
#include "ui/sensitivity/sensitivity_page.hpp"
#include "ui/window/compose_actions.hpp"
#include "ui/window/main_window.hpp"

/// Pages that come beside the diagram when they are asked for, and go again.
namespace analogon::ui {

void MainWindow::showValues(const QString& experiment) {
    values_->show(experiment);
    if (centre_->indexOf(values_) < 0) centre_->addTab(values_, tr("Values"));
    centre_->setCurrentWidget(values_);
}

void MainWindow::leaveValues() {
    const int tab = centre_->indexOf(values_);
    if (tab < 0) return;
    centre_->removeTab(tab);
    showDiagram();
}

void MainWindow::showComparison(const QString& signal, const QString& experiment) {
    comparison_->show(signal, experiment);
    if (centre_->indexOf(comparison_) < 0) centre_->addTab(comparison_, tr("Compare"));
    centre_->setCurrentWidget(comparison_);
}

void MainWindow::leaveComparison() {
    const int tab = centre_->indexOf(comparison_);
    if (tab < 0) return;
    centre_->removeTab(tab);
    showDiagram();
}

void MainWindow::connectRecordings() {
    connect(measurements_, &MeasurementPanel::tableWanted, this, &MainWindow::showRecordings);
    connect(measurements_, &MeasurementPanel::sourceMade, this, [this](const QString& declaration) {
        showDiagram();
        compose_->placeDeclared(declaration);
    });
    connect(measurements_, &MeasurementPanel::told, this,
            [this](const QString& sentence) { statusBar()->showMessage(sentence, 8000); });
    connect(recordings_, &RecordingsPage::left, this, &MainWindow::leaveRecordings);
    connect(recordings_, &RecordingsPage::valuesWanted, this, &MainWindow::showValues);
    connect(recordings_, &RecordingsPage::locateWanted, this, &MainWindow::askWhereItIs);
    connect(recordings_, &RecordingsPage::experimentChosen, plots_, &PlotPanel::showExperiment);
    const auto start = [this](RunKind kind) {
        return [this, kind](const std::set<std::string>& recordings) {
            settle();
            controller_->startOn(kind, recordings);
        };
    };
    connect(recordings_, &RecordingsPage::fitWanted, this, start(RunKind::Fit));
    connect(recordings_, &RecordingsPage::searchWanted, this, start(RunKind::Discover));
    connect(controller_, &RunController::runningChanged, recordings_,
            [this] { recordings_->setRunning(controller_->isRunning()); });
}

void MainWindow::showRecordings() {
    if (!document_->isOpen()) return;
    if (centre_->indexOf(recordings_) < 0) centre_->addTab(recordings_, tr("Recordings"));
    centre_->setCurrentWidget(recordings_);
    recordings_->focusTable();
}

void MainWindow::leaveRecordings() {
    const int tab = centre_->indexOf(recordings_);
    if (tab < 0) return;
    centre_->removeTab(tab);
    showDiagram();
}

/// A campaign stands beside the study that is open; a second one takes the place of the first unless that runs.
void MainWindow::showCampaign(const QString& file) {
    auto* campaign = findChild<CampaignWindow*>();
    if (!campaign) {
        campaign = new CampaignWindow(this);
        connect(campaign, &CampaignWindow::studyWanted, this, [this](const Study& study, const Diagnostics& remarks) {
            leaveThen([this, study, remarks] { document_->startWith(study, remarks); });
        });
    }
    if (!file.isEmpty()) campaign->openCampaign(file);
    campaign->show();
    campaign->raise();
    campaign->activateWindow();
}

void MainWindow::showSensitivity() {
    if (!document_->isOpen()) return;
    if (!sensitivity_) {
        sensitivity_ = new SensitivityPage(*document_, this);
        connect(sensitivity_, &SensitivityPage::left, this, [this] {
            const int tab = centre_->indexOf(sensitivity_);
            if (tab < 0) return;
            centre_->removeTab(tab);
            showDiagram();
        });
        connect(sensitivity_, &SensitivityPage::parameterChosen, this, [this](const QString& name) {
            showMention({Mention::Kind::Parameter, name});
        });
    }
    if (centre_->indexOf(sensitivity_) < 0) centre_->addTab(sensitivity_, tr("Sensitivities"));
    centre_->setCurrentWidget(sensitivity_);
    sensitivity_->matrix()->setFocus();
}

}  // namespace analogon::ui
