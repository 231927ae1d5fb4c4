#pragma once

#include <QString>
#include <optional>

#include "core/base/text.hpp"

namespace analogon::ui {

class Document;

/// Something of the study that a sentence names: where a click on the sentence leads.
struct Mention {
    enum class Kind { Experiment, Parameter, Block };
    Kind kind{Kind::Block};
    QString name;  // a block's may be that of one of its connectors
    friend bool operator==(const Mention&, const Mention&) = default;
};

/// What of the study has this name.
std::optional<Mention> mentionOf(const Document& document, const QString& name);
/// The first of the names in a sentence that the study has.
std::optional<Mention> mentionIn(const Document& document, const Text& text);

/// As the target of a link, and back.
QString targetOf(const Mention& mention);
std::optional<Mention> mentionAt(const QString& target);

/// A sentence as HTML in which what it names of the study is linked.
QString linkedWords(const Document& document, const Text& text);

}  // namespace analogon::ui
