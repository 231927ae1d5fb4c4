#include "ui/campaign/campaign_process.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <csignal>

namespace analogon::ui {

namespace {

constexpr int stopTime = 3000;  // [ms] that a campaign is given to end when the window goes
constexpr int notStarted = -1;

QString defaultProgram() {
    const QString beside = QDir(QCoreApplication::applicationDirPath()).filePath("analogon-cli");
    return QFileInfo(beside).isExecutable() ? beside : QStandardPaths::findExecutable("analogon-cli");
}

std::optional<CampaignProgress> progressIn(const QByteArray& line) {
    const QJsonObject json = QJsonDocument::fromJson(line).object();
    if (!json.contains("units")) return std::nullopt;
    const auto count = [&](const char* name) { return static_cast<std::size_t>(json.value(name).toInteger()); };
    CampaignProgress progress;
    progress.counts = {count("units"), 0, count("running"), count("done"), count("failed")};
    const CampaignCounts& c = progress.counts;
    progress.counts.waiting = c.units - std::min(c.units, c.running + c.done + c.failed);
    progress.secondsLeft = json.value("seconds_left").toDouble(-1);
    return progress;
}

std::optional<Text> noteIn(const QByteArray& line) {
    const QJsonObject json = QJsonDocument::fromJson(line).object();
    if (!json.contains("note")) return std::nullopt;
    std::vector<Text> arguments;
    for (const QJsonValue& argument : json.value("arguments").toArray())
        arguments.emplace_back(argument.toString().toStdString());
    return Text(json.value("pattern").toString().toStdString(), std::move(arguments),
                json.value("note").toString().toStdString());
}

}  // namespace

CampaignProcess::CampaignProcess(QObject* parent) : QObject(parent) {
    process_.setStandardOutputFile(QProcess::nullDevice());
    connect(&process_, &QProcess::readyReadStandardError, this, &CampaignProcess::read);
    connect(&process_, &QProcess::finished, this, [this](int status, QProcess::ExitStatus how) {
        read();
        said_ += QString::fromUtf8(std::exchange(pending_, {}));
        Q_EMIT ended(how == QProcess::NormalExit ? status : 128 + status, said_.trimmed());
    });
    connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError fault) {
        if (fault == QProcess::FailedToStart) Q_EMIT ended(notStarted, process_.errorString());
    });
}

CampaignProcess::~CampaignProcess() {
    disconnect(&process_, nullptr, this, nullptr);
    if (!isRunning()) return;
    stop();
    process_.waitForFinished(stopTime);
}

QStringList CampaignProcess::arguments(const CampaignOrder& order) {
    QStringList all{"campaign", order.file, "--out", order.out, "--progress", "json"};
    if (order.isOnCluster)
        all << "--slurm=" + order.clusterOptions;
    else
        all << "--jobs" << QString::number(order.jobs);
    if (order.retriesFailed) all << "--retry";
    return all;
}

void CampaignProcess::start(const CampaignOrder& order) {
    if (isRunning()) return;
    const QString program = program_.isEmpty() ? defaultProgram() : program_;
    said_.clear();
    pending_.clear();
    isStopping_ = false;
    if (program.isEmpty()) {
        Q_EMIT ended(notStarted, tr("The program analogon-cli, which works on campaigns, was found neither beside this "
                                    "one nor among those that are installed."));
        return;
    }
    process_.start(program, arguments(order));
}

void CampaignProcess::stop() {
    if (!isRunning()) return;
    isStopping_ = true;
    ::kill(static_cast<pid_t>(process_.processId()), SIGINT);
}

void CampaignProcess::read() {
    pending_ += process_.readAllStandardError();
    for (qsizetype end = pending_.indexOf('\n'); end >= 0; end = pending_.indexOf('\n')) {
        const QByteArray line = pending_.left(end);
        pending_.remove(0, end + 1);
        if (const std::optional<CampaignProgress> progress = progressIn(line))
            Q_EMIT progressed(*progress);
        else if (const std::optional<Text> note = noteIn(line))
            Q_EMIT noted(*note);
        else
            said_ += QString::fromUtf8(line) + '\n';
    }
}

}  // namespace analogon::ui
