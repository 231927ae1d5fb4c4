#pragma once

#include <QWidget>
#include <vector>

class QLabel;

namespace analogon::ui {

/// A study that ships with the program.
struct Example {
    QString path, title, description;
};

/// Examples of the installation, or of the source tree it was built from.
std::vector<Example> findExamples();

/// What is seen while no study is open: how to open one, and the examples.
class StartPage : public QWidget {
    Q_OBJECT

public:
    explicit StartPage(std::vector<Example> examples, QWidget* parent = nullptr);

    /// A study that could not be read; empty: no fault.
    void showFault(const QString& text);

Q_SIGNALS:
    void openWanted();
    void exampleChosen(const QString& path);

private:
    QLabel* fault_;
};

}  // namespace analogon::ui
