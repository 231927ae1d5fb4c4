#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <type_traits>
#include <vector>

#include "core/base/guard.hpp"
#include "core/base/progress.hpp"

namespace analogon::ui {

/// One line of background work, and the only thread code of the screen. A job is a pure function of values that
/// it was given; its result comes back on the GUI thread. Starting another job, or drop(), asks the one under
/// way to stop and throws its result away; cancel() asks it to stop and takes what it has so far.
class JobRunner : public QObject {
    Q_OBJECT

public:
    explicit JobRunner(QObject* parent = nullptr);
    ~JobRunner() override;

    /// `work` runs on another thread; `done` on this one, unless the job was dropped meanwhile. What the work throws
    /// comes as a fault to `done` where a result can hold one, else by failed().
    template <class Result>
    void start(const QString& what, std::function<Result(const Progress&)> work, std::function<void(Result)> done) {
        launch(what, [this, work = std::move(work), done = std::move(done)](const Progress& progress) -> Delivery {
            std::shared_ptr<Result> result;
            const std::optional<Diagnostic> thrown =
                guarded([&] { result = std::make_shared<Result>(work(progress)); });
            if (!thrown) return [result, done] { done(std::move(*result)); };
            if constexpr (std::is_convertible_v<Diagnostic, Result>)
                return [fault = *thrown, done] { done(Result(fault)); };
            else if constexpr (requires { Result::failed(*thrown); })
                return [fault = *thrown, done] { done(Result::failed(fault)); };
            else
                return [this, fault = *thrown] { Q_EMIT failed(fault); };
        });
    }

    void cancel();
    void drop();

    bool isBusy() const { return busy_; }
    bool isCancelling() const { return cancelling_; }
    const QString& what() const { return what_; }

Q_SIGNALS:
    void started(const QString& what);
    /// At most one call per turn of the event loop.
    void progressed(const analogon::Progress::Report& report);
    void finished();
    /// The job that was under way has thrown, and its result cannot say so.
    void failed(const analogon::Diagnostic& fault);

private:
    using Delivery = std::function<void()>;
    void launch(const QString& what, std::function<Delivery(const Progress&)> work);
    void finish(unsigned long job, const Delivery& deliver);
    void showLatest();

    struct Mailbox;  // where the worker leaves its latest report
    std::shared_ptr<Mailbox> mailbox_;
    std::jthread thread_;
    struct Retired {
        std::shared_ptr<std::atomic<bool>> isDone;
        std::jthread thread;
    };
    std::shared_ptr<std::atomic<bool>> isDone_;  // of thread_
    std::vector<Retired> retired_;               // dropped jobs that are still about to stop
    unsigned long job_{};                        // number of the job whose result counts
    bool busy_{}, cancelling_{};
    QString what_;
};

}  // namespace analogon::ui
