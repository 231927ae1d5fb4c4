#pragma once

#include <QString>
#include <QStringList>
#include <algorithm>

namespace analogon::ui::style {

/// What someone types into a field to find something: each of its words is asked for, in whatever case.
class SoughtWords {
public:
    explicit SoughtWords(const QString& typed) : words_(typed.toLower().split(' ', Qt::SkipEmptyParts)) {}

    bool isEmpty() const { return words_.isEmpty(); }
    const QString& first() const { return words_.front(); }
    /// `text`: in small letters. No word is in every text.
    bool areIn(const QString& text) const {
        return std::all_of(words_.begin(), words_.end(), [&](const QString& word) { return text.contains(word); });
    }

private:
    QStringList words_;
};

}  // namespace analogon::ui::style
