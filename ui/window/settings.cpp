#include "ui/window/settings.hpp"

#include <QSettings>
#include <utility>

namespace analogon::ui {

namespace {

bool store(const QVariantMap& values) {
    QSettings file;
    for (auto it = values.begin(); it != values.end(); ++it) file.setValue(it.key(), it.value());
    file.sync();
    return file.status() == QSettings::NoError;
}

}  // namespace

Settings::Settings() : writer_(std::make_unique<JobRunner>()) {
    const QSettings file;
    for (const QString& key : file.allKeys()) values_[key] = file.value(key);
}

Settings::~Settings() {
    writer_.reset();  // waits: what is under way must not overwrite what follows
    if (!unwritten_.isEmpty()) store(unwritten_);
}

void Settings::setValue(const QString& key, const QVariant& value) {
    if (values_.value(key) == value) return;
    values_[key] = unwritten_[key] = value;
    if (!writer_->isBusy()) write();
}

void Settings::write() {
    writer_->start<bool>(
        QString(), [values = std::exchange(unwritten_, {})](const Progress&) { return store(values); },
        [this](bool) {
            if (!unwritten_.isEmpty()) write();
        });
}

}  // namespace analogon::ui
