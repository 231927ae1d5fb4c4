#pragma once

#include <QObject>
#include <QProcess>
#include <QString>
#include <QStringList>

#include "core/campaign/campaign_run.hpp"

namespace analogon::ui {

/// What a campaign is started with.
struct CampaignOrder {
    QString file, out;         // campaign.json; the directory of the results
    int jobs{1};               // on this machine
    bool retriesFailed{};      // what failed in an earlier run, too
    bool isOnCluster{};        // as tasks of Slurm
    QString clusterOptions{};  // for sbatch
};

/// A campaign at work: analogon-cli in a process of its own, so that what a unit does to it costs the window nothing.
class CampaignProcess : public QObject {
    Q_OBJECT

public:
    explicit CampaignProcess(QObject* parent = nullptr);
    ~CampaignProcess() override;

    /// The program; default: the one beside this, or the one that is installed.
    void setProgram(const QString& program) { program_ = program; }
    static QStringList arguments(const CampaignOrder& order);

    void start(const CampaignOrder& order);
    /// As Ctrl-C does: what is done is done, and a later start goes on.
    void stop();
    bool isRunning() const { return process_.state() != QProcess::NotRunning; }
    bool isStopping() const { return isStopping_; }

Q_SIGNALS:
    void progressed(const analogon::CampaignProgress& progress);
    /// What the program tells while it works: that a job waits, say, and why.
    void noted(const analogon::Text& note);
    /// `said`: the faults that the program tells of it, without its progress and its notes.
    void ended(int status, const QString& said);

private:
    void read();

    QProcess process_;
    QString program_, said_;
    QByteArray pending_;
    bool isStopping_{};
};

}  // namespace analogon::ui
