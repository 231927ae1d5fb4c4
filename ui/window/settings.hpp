#pragma once

#include <QVariantMap>
#include <memory>

#include "ui/job/job.hpp"

namespace analogon::ui {

/// What the program remembers from one start to the next. Read once; a change holds at once and is written in the
/// background, for a disk may let a writer wait longer than a window may.
class Settings {
public:
    Settings();
    ~Settings();

    QVariant value(const QString& key, const QVariant& fallback = {}) const { return values_.value(key, fallback); }
    void setValue(const QString& key, const QVariant& value);

private:
    void write();

    QVariantMap values_, unwritten_;
    std::unique_ptr<JobRunner> writer_;
};

}  // namespace analogon::ui
