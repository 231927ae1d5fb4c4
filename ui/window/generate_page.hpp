#pragma once

#include <QWidget>

#include "core/study/generate.hpp"
#include "ui/job/job.hpp"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace analogon::ui {

/// From a classification and a measurement to a composed, mapped study: the domains of the component in the order of
/// the chain, and its recordings.
class GeneratePage : public QWidget {
    Q_OBJECT

public:
    explicit GeneratePage(QWidget* parent = nullptr);

    /// Starts anew.
    void clear();
    void addDomain(const QString& domain);
    void addRecording(const QString& path);
    QListWidget* knownDomains() const { return known_; }
    QListWidget* chain() const { return chain_; }
    QListWidget* recordings() const { return recordings_; }
    QPushButton* generateButton() const { return generate_; }
    QString fault() const;

Q_SIGNALS:
    void generated(const analogon::GeneratedStudy& study);
    void cancelled();
    void recordingsWanted();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void takeOut(QListWidget* list);
    QPushButton* takeOutOf(QListWidget* list, const char* name);
    void generate();
    void update();
    void say(const QString& text, bool isFault);

    JobRunner worker_;
    QListWidget *known_, *chain_, *recordings_;
    QLineEdit* name_;
    QLabel* message_;
    QPushButton *add_, *browse_, *generate_, *cancel_;
};

}  // namespace analogon::ui
