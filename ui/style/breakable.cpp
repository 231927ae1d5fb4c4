#include "ui/style/breakable.hpp"

namespace analogon::ui {

QString breakable(const QString& name, int whole) {
    if (name.size() <= whole) return name.toHtmlEscaped();
    constexpr int longest = 12;  // letters between two places to break: as many as the narrowest legend has room for
    QString html;
    int letters = 0;
    for (const QChar c : name) {
        html += QString(c).toHtmlEscaped();
        ++letters;
        const bool isPair = c.isHighSurrogate();
        if (isPair || (c.isLetterOrNumber() && letters < longest)) continue;
        if (!c.isSpace()) html += QChar(0x200B);  // a label of Qt knows no <wbr>
        letters = 0;
    }
    return html;
}

QString breakableAtSigns(const QString& text) {
    QString broken;
    for (qsizetype i = 0; i < text.size(); ++i) {
        broken += text[i];
        const bool isSign = text[i] == u'.' || text[i] == u'_';
        if (isSign && i + 1 < text.size() && text[i + 1].isLetter()) broken += QChar(0x200B);
    }
    return broken;
}

}  // namespace analogon::ui
