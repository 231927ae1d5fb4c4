#pragma once

#include <QDateTime>
#include <QDialog>
#include <QTimer>
#include <memory>
#include <optional>

#include "core/campaign/campaign_look.hpp"
#include "ui/campaign/campaign_process.hpp"
#include "ui/job/job.hpp"

class QCheckBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSortFilterProxyModel;
class QSpinBox;
class QTableView;

namespace analogon::ui {

class UnitsModel;

/// A campaign: opened, started on this machine or on a cluster, watched, and the study of a unit opened from its row.
class CampaignWindow : public QDialog {
    Q_OBJECT

public:
    explicit CampaignWindow(QWidget* parent = nullptr);
    ~CampaignWindow() override;

    /// campaign.json as it is written, or the state of one that was worked on, in the directory of its results.
    void openCampaign(const QString& file);

    CampaignProcess& process() { return process_; }
    UnitsModel* model() const { return model_; }
    QTableView* view() const { return view_; }
    QLineEdit* fileField() const { return file_; }
    QLineEdit* outField() const { return out_; }
    QLineEdit* filterField() const { return filter_; }
    QSpinBox* jobsField() const { return jobs_; }
    QCheckBox* clusterBox() const { return cluster_; }
    QLineEdit* clusterOptionsField() const { return clusterOptions_; }
    QCheckBox* retryBox() const { return retry_; }
    QPushButton* startButton() const { return start_; }
    QPushButton* openStudyButton() const { return openStudy_; }
    QPushButton* openReportButton() const { return openReport_; }
    QPushButton* pageButton() const { return page_; }
    QLabel* told() const { return told_; }
    QProgressBar* bar() const { return bar_; }
    void chooseUnit(const QString& name);

Q_SIGNALS:
    /// The study of a unit, its parameters beginning where its run ended, and what there is to say of it.
    void studyWanted(const analogon::Study& study, const analogon::Diagnostics& remarks);

public Q_SLOTS:
    void reject() override;

private:
    /// A campaign that was read, with its study.
    struct Opened {
        std::string file, out;  // campaign.json as it is written; the results, where that was told
        std::shared_ptr<const Campaign> campaign;
        std::shared_ptr<const CampaignTemplate> study;
        Diagnostics faults;  // why not
    };
    static Opened read(std::string file);

    QLayout* placeFields();
    QLayout* runFields();
    QLayout* rowButtons();
    QWidget* withButton(QLineEdit* field, const QString& text, const char* name, void (CampaignWindow::*ask)());
    void setWidths();
    void askForFile();
    void askForPlace();
    void showOpened(Opened opened);
    void lookAgain();
    void look();
    void watch();
    void showLook(const CampaignLook& found);
    void showCounts(const CampaignProgress& progress);
    void startOrStop();
    void end(int status, const QString& said);
    void showNote(const Text& note);
    void tell(const QString& text, bool isFault);
    void updateState();
    const CampaignUnit* chosen() const;
    QString folderOfChosen() const;
    void openStudyOfChosen();
    void openFile(const QString& path);

    CampaignProcess process_;
    JobRunner reader_, looker_, opener_;
    QTimer timer_;
    QString asked_;  // the campaign that was opened last, also where it is faulty
    QString note_;   // what the program told last
    Opened opened_;
    std::shared_ptr<const CampaignLook> look_;
    QString lookedAt_;    // the directory of that
    QDateTime written_;   // its state, when it was looked at
    bool isLookStale_{};  // begun before what it is to show
    UnitsModel* model_;
    QSortFilterProxyModel* sorted_;
    QLineEdit *file_, *out_, *clusterOptions_, *filter_;
    QSpinBox* jobs_;
    QCheckBox *cluster_, *retry_;
    QPushButton *start_, *openStudy_, *openReport_, *page_, *table_;
    QTableView* view_;
    QProgressBar* bar_;
    QLabel *told_, *counts_;
};

}  // namespace analogon::ui
