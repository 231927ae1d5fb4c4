#include "ui/style/translator.hpp"

#include <QFile>
#include <QXmlStreamReader>

static void loadTranslations() { Q_INIT_RESOURCE(icons); }

namespace analogon::ui {

QStringList languages() { return {QStringLiteral("en"), QStringLiteral("de")}; }

bool Translator::loadLanguage(const QString& language) {
    loadTranslations();
    texts_.clear();
    ofContext_.clear();
    QFile file(QStringLiteral(":/translations/analogon_%1.ts").arg(language));
    if (!file.open(QIODevice::ReadOnly)) return false;
    QXmlStreamReader xml(&file);
    QString context, source;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == u"name") context = xml.readElementText();
        if (xml.name() == u"source") source = xml.readElementText();
        if (xml.name() == u"translation") {
            const QString text = xml.readElementText();
            if (text.isEmpty()) continue;
            texts_.insert(source, text);
            ofContext_.insert(context + '/' + source, text);
        }
    }
    return !xml.hasError();
}

QString Translator::translate(const char* context, const char* source, const char*, int) const {
    const QString text = QString::fromUtf8(source);
    const QString named = QString::fromUtf8(context).section("::", -1);  // the class, without its namespaces
    return ofContext_.value(named + '/' + text, texts_.value(text));
}

}  // namespace analogon::ui
