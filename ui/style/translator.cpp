#include "ui/style/translator.hpp"

#include <QFile>
#include <QXmlStreamReader>

static void loadTranslations() { Q_INIT_RESOURCE(icons); }

namespace analogon::ui {

QStringList languages() { return {QStringLiteral("en"), QStringLiteral("de")}; }

bool Translator::loadLanguage(const QString& language) {
    loadTranslations();
    texts_.clear();
    QFile file(QStringLiteral(":/translations/analogon_%1.ts").arg(language));
    if (!file.open(QIODevice::ReadOnly)) return false;
    QXmlStreamReader xml(&file);
    QString source;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == u"source") source = xml.readElementText();
        if (xml.name() == u"translation") {
            const QString text = xml.readElementText();
            if (!text.isEmpty()) texts_.insert(source, text);
        }
    }
    return !xml.hasError();
}

QString Translator::translate(const char*, const char* source, const char*, int) const {
    return texts_.value(QString::fromUtf8(source));
}

}  // namespace analogon::ui
