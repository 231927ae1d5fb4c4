#pragma once

#include <QWidget>
#include <vector>

#include "ui/document/recovery.hpp"

class QLabel;
class QVBoxLayout;

namespace analogon::ui {

/// A study that ships with the program.
struct Example {
    QString path, title, description;
    QString icon{};  // its own picture, where there is one for its directory
};

/// Examples of the installation, or of the source tree it was built from.
std::vector<Example> findExamples();
/// Whether a study is one of them: it is to stay as it is.
bool isExample(const QString& path);

/// What is seen while no study is open: how to open one, and the examples.
class StartPage : public QWidget {
    Q_OBJECT

public:
    explicit StartPage(std::vector<Example> examples, QWidget* parent = nullptr);

    /// A study that could not be read; empty: no fault.
    void showFault(const QString& text);
    /// Studies opened lately, and work that was not saved when the program ended.
    void showWork(const QStringList& recent, const std::vector<Recovered>& recovered);

Q_SIGNALS:
    void openWanted();
    void newWanted();
    void generateWanted();
    void recoveryChosen(const analogon::ui::Recovered& recovered);
    void exampleChosen(const QString& path);

private:
    QLabel* fault_;
    QVBoxLayout* work_;  // recovered and recent studies
};

}  // namespace analogon::ui
