#include "ui/words/words.hpp"

#include <QCoreApplication>
#include <QRegularExpression>

#include "ui/style/number.hpp"
#include "ui/words/window_words.hpp"

namespace analogon::ui {

namespace {

using ToWords = std::function<QString(const QString&)>;

QString wordsOf(const Text& text, const ToWords& plain, const ToWords& name);

/// "{}" is the next argument, "{1}" the second one, "{{" a brace.
QString filled(const QString& pattern, const std::vector<Text>& arguments, const ToWords& plain, const ToWords& name) {
    QString words, between;
    std::size_t next = 0;
    for (qsizetype at = 0; at < pattern.size(); ++at) {
        const QChar c = pattern[at];
        const bool isDoubled = at + 1 < pattern.size() && pattern[at + 1] == c;
        if ((c == '{' || c == '}') && isDoubled) ++at;
        if (c != '{' || isDoubled) {
            between += c;
            continue;
        }
        const qsizetype end = pattern.indexOf('}', at);
        if (end < 0) break;
        bool isNumber = false;
        const auto number = pattern.mid(at + 1, end - at - 1).section(':', 0, 0).toULong(&isNumber);
        const std::size_t argument = isNumber ? number : next++;
        words += plain(between);
        between.clear();
        if (argument < arguments.size()) words += wordsOf(arguments[argument], plain, name);
        at = end;
    }
    return words + plain(between);
}

QString wordsOf(const Text& text, const ToWords& plain, const ToWords& name) {
    if (text.isNumber()) return plain(style::withDecimalSign(text.english()));
    if (text.pattern().empty()) {
        QString words;
        for (const Text& part : text.arguments()) words += wordsOf(part, plain, name);
        return text.arguments().empty() ? name(QString::fromStdString(text.english())) : words;
    }
    const char* const own = windowPattern(text.pattern());
    const QString pattern = own ? QCoreApplication::translate("WindowWords", own)
                                : QCoreApplication::translate("core", text.pattern().c_str());
    return filled(pattern, text.arguments(), plain, name);
}

}  // namespace

QString inWords(const Text& text) {
    const auto asItIs = [](const QString& words) { return words; };
    return wordsOf(text, asItIs, asItIs);
}

QString libraryText(const std::string& description) {
    return QCoreApplication::translate("Library", description.c_str());
}

QString libraryDocumentation(const QString& html) {
    static const QRegularExpression paragraph("<p>(.*?)</p>", QRegularExpression::DotMatchesEverythingOption);
    QString words;
    qsizetype done = 0;
    for (auto found = paragraph.globalMatch(html); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        const std::string text = match.captured(1).simplified().toStdString();
        words += html.mid(done, match.capturedStart() - done) + "<p>" + libraryText(text) + "</p>";
        done = match.capturedEnd();
    }
    return words + html.mid(done);
}

QStringList namesIn(const Text& text) {
    if (text.pattern().empty() && text.arguments().empty())
        return QString::fromStdString(text.english()).split(", ", Qt::SkipEmptyParts);  // "R, k and b" has two of them
    QStringList names;
    for (const Text& argument : text.arguments()) names += namesIn(argument);
    return names;
}

QString linkedWords(const Text& text, const std::function<QString(const QString&)>& target) {
    const auto plain = [](const QString& words) { return words.toHtmlEscaped(); };
    const auto link = [&](const QString& words) {
        QStringList parts = words.split(", ");
        for (QString& part : parts) {
            const QString to = target(part);
            part = part.toHtmlEscaped();
            if (!to.isEmpty()) part = QStringLiteral("<a href=\"%1\">%2</a>").arg(to.toHtmlEscaped(), part);
        }
        return parts.join(", ");
    };
    return wordsOf(text, plain, link);
}

}  // namespace analogon::ui
