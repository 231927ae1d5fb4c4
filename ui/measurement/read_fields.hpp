#pragma once

#include <QWidget>
#include <optional>
#include <string>

#include "core/measure/read_options.hpp"

class QComboBox;
class QGridLayout;
class QLineEdit;
class QToolButton;

namespace analogon::ui {

/// A step of time as it is typed, with a point or a comma ("0,001 s"), in the form of "time_format"; nothing: it is
/// none.
std::optional<std::string> typedInterval(const QString& text);

/// How a text is written, a field for each that a study can tell; what is left empty is found out from the file. The
/// usual ones are in sight, the others behind a button.
class ReadFields : public QWidget {
    Q_OBJECT

public:
    explicit ReadFields(QWidget* parent = nullptr);

    ReadOptions options() const;
    void show(const ReadOptions& options);
    QToolButton* moreButton() const { return more_; }

Q_SIGNALS:
    void changed();

private:
    void add(const QString& text, QWidget* field);
    QLineEdit* addLine(const QString& text, const QString& example, const QString& tip);
    QComboBox* addChoice(const QString& text, const QString& tip);
    void showRest(bool isShown);

    QGridLayout* grid_;
    int cells_{};
    QComboBox *separator_, *decimal_, *units_, *thousands_, *times_, *encoding_;
    QLineEdit *skip_, *header_, *timeFormat_, *timeZone_;
    std::map<std::string, std::string> unitNames_;  // that were answered
    QToolButton* more_;
};

}  // namespace analogon::ui
