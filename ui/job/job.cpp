#include "ui/job/job.hpp"

#include <QCoreApplication>
#include <algorithm>

#include "core/base/stop.hpp"

namespace analogon::ui {

struct JobRunner::Mailbox {
    std::mutex mutex;
    Progress::Report latest;
    bool isPosted{};
    JobRunner* runner{};  // null once the runner is gone or listens to another job
};

JobRunner::JobRunner(QObject* parent) : QObject(parent) {}

JobRunner::~JobRunner() {
    drop();
    retired_.clear();  // joins
}

void JobRunner::launch(const QString& what, std::function<Delivery(const Progress&)> work) {
    drop();
    const unsigned long job = ++job_;
    busy_ = true;
    cancelling_ = false;
    what_ = what;
    mailbox_ = std::make_shared<Mailbox>();
    mailbox_->runner = this;

    const auto sink = [mailbox = mailbox_](const Progress::Report& report) {
        const std::lock_guard lock(mailbox->mutex);
        mailbox->latest = report;
        if (mailbox->isPosted || !mailbox->runner) return;
        mailbox->isPosted = true;  // further reports only replace the latest until it has been shown
        QMetaObject::invokeMethod(
            mailbox->runner, [runner = mailbox->runner] { runner->showLatest(); }, Qt::QueuedConnection);
    };
    isDone_ = std::make_shared<std::atomic<bool>>(false);
    thread_ =
        std::jthread([job, mailbox = mailbox_, sink, work = std::move(work), isDone = isDone_](std::stop_token stop) {
            const StackGuard stack;
            Delivery deliver;  // empty: it was stopped before it had anything
            try {
                const StopScope scope(stop);
                deliver = work(Progress(std::move(stop), sink));
            } catch (const Stopped&) {
            }
            isDone->store(true);
            const std::lock_guard lock(mailbox->mutex);
            if (!mailbox->runner) return;
            QMetaObject::invokeMethod(
                mailbox->runner, [runner = mailbox->runner, job, deliver] { runner->finish(job, deliver); },
                Qt::QueuedConnection);
        });
    Q_EMIT started(what);
}

void JobRunner::cancel() {
    if (!busy_) return;
    cancelling_ = true;
    thread_.request_stop();
}

void JobRunner::drop() {
    if (mailbox_) {
        const std::lock_guard lock(mailbox_->mutex);
        mailbox_->runner = nullptr;
    }
    mailbox_.reset();
    if (thread_.joinable()) {
        thread_.request_stop();
        retired_.push_back({isDone_, std::move(thread_)});
    }
    if (busy_) {
        busy_ = false;
        ++job_;
        Q_EMIT finished();
    }
}

void JobRunner::showLatest() {
    if (!mailbox_) return;
    Progress::Report report;
    {
        const std::lock_guard lock(mailbox_->mutex);
        report = mailbox_->latest;
        mailbox_->isPosted = false;
    }
    Q_EMIT progressed(report);
}

void JobRunner::finish(unsigned long job, const Delivery& deliver) {
    if (job != job_ || !busy_) return;
    thread_.join();  // it has posted this call as its last act
    std::erase_if(retired_, [](const Retired& r) { return r.isDone->load(); });
    busy_ = false;
    mailbox_.reset();
    if (deliver) deliver();
    if (!busy_) Q_EMIT finished();  // unless the result started the next job
}

}  // namespace analogon::ui
