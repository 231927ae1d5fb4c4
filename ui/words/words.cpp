#include "ui/words/words.hpp"

#include <QCoreApplication>

namespace analogon::ui {

namespace {

/// "{}" is the next argument, "{1}" the second one, "{{" a brace.
QString filled(const QString& pattern, const std::vector<Text>& arguments) {
    QString words;
    std::size_t next = 0;
    for (qsizetype at = 0; at < pattern.size(); ++at) {
        const QChar c = pattern[at];
        const bool isDoubled = at + 1 < pattern.size() && pattern[at + 1] == c;
        if ((c == '{' || c == '}') && isDoubled) ++at;
        if (c != '{' || isDoubled) {
            words += c;
            continue;
        }
        const qsizetype end = pattern.indexOf('}', at);
        if (end < 0) break;
        bool isNumber = false;
        const auto number = pattern.mid(at + 1, end - at - 1).toULong(&isNumber);
        const std::size_t argument = isNumber ? number : next++;
        if (argument < arguments.size()) words += inWords(arguments[argument]);
        at = end;
    }
    return words;
}

}  // namespace

QString inWords(const Text& text) {
    if (text.pattern().empty()) {
        QString words;
        for (const Text& part : text.arguments()) words += inWords(part);
        return text.arguments().empty() ? QString::fromStdString(text.english()) : words;
    }
    const QString pattern = QString::fromStdString(text.pattern());
    const QString translated = QCoreApplication::translate("core", text.pattern().c_str());
    return translated == pattern ? QString::fromStdString(text.english()) : filled(translated, text.arguments());
}

}  // namespace analogon::ui
