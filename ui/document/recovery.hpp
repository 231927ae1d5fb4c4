#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <vector>

#include "core/base/diagnostic.hpp"
#include "ui/job/job.hpp"

namespace analogon::ui {

class Document;

/// Work that a program which did not end properly has left behind.
struct Recovered {
    QString file;   // the copy
    QString path;   // where the study was opened from; empty: it was never saved
    QString saved;  // when, for people
};

/// Keeps a copy of a study with unsaved changes in a directory of its own, a moment after each change, and takes it
/// away once the study is saved or closed. Programs that are no more are told by the lock of their directory.
class Recovery : public QObject {
    Q_OBJECT

public:
    explicit Recovery(Document& document, QObject* parent = nullptr);
    ~Recovery() override;

    /// Copies whose program is no more.
    static std::vector<Recovered> abandoned();
    static void discard(const Recovered& recovered);
    /// Ends the copy: the study is saved, or its changes are not wanted.
    void clear();

Q_SIGNALS:
    /// There is no copy of the latest changes, and why; once, until there is one again.
    void notKept(const analogon::Diagnostic& fault);

private:
    void changed();
    void write();
    void tell(const Diagnostics& faults);
    void dropInherited();
    QString file() const;

    struct Store;
    Document& document_;
    std::shared_ptr<Store> store_;  // null: nothing was to be kept yet
    QString inherited_;             // the copy this work was recovered from, until it has one of its own or is saved
    bool isTold_{};                 // that no copy can be kept
    QTimer delay_;
    JobRunner writer_;
};

}  // namespace analogon::ui
