#pragma once

#include <QHash>
#include <QTranslator>

namespace analogon::ui {

/// Texts of the screen in another language, read from a Qt Linguist file (.ts) of the resources. A text has one
/// translation wherever it is used.
class Translator : public QTranslator {
    Q_OBJECT

public:
    explicit Translator(QObject* parent = nullptr) : QTranslator(parent) {}

    /// "de"; false when there is no such file.
    bool loadLanguage(const QString& language);
    QString translate(const char* context, const char* source, const char* disambiguation, int n) const override;
    bool isEmpty() const override { return texts_.isEmpty(); }
    bool knows(const QString& source) const { return texts_.contains(source); }

private:
    QHash<QString, QString> texts_;      // by the text alone: what means the same everywhere stands in the file once
    QHash<QString, QString> ofContext_;  // by class and text: "Fit" is an order on a button, and the name of a run
};

/// The languages there are: "en", "de".
QStringList languages();

}  // namespace analogon::ui
