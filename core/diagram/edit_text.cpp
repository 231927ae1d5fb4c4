#include "core/diagram/edit_text.hpp"

#include <algorithm>
#include <map>

namespace analogon::edit_text {

using syntax::Modification;
using syntax::Replacement;

namespace {

bool isBlank(char c) { return c == ' ' || c == '\t'; }

std::uint32_t lineStart(std::string_view text, std::uint32_t offset) {
    while (offset > 0 && text[offset - 1] != '\n') --offset;
    return offset;
}

}  // namespace

std::string lineEnd(std::string_view text) {
    const auto newline = text.find('\n');
    return newline != std::string_view::npos && newline > 0 && text[newline - 1] == '\r' ? "\r\n" : "\n";
}

std::string indentation(std::string_view text, std::uint32_t offset) {
    const std::uint32_t begin = lineStart(text, offset);
    std::uint32_t end = begin;
    while (end < text.size() && isBlank(text[end])) ++end;
    return std::string(text.substr(begin, end - begin));
}

std::uint32_t beforeIndentation(std::string_view text, std::uint32_t offset) {
    const std::uint32_t begin = lineStart(text, offset);
    const bool onlyBlanks = std::all_of(text.begin() + begin, text.begin() + offset, isBlank);
    return onlyBlanks ? begin : offset;
}

std::uint32_t behindTrailingComment(std::string_view text, std::uint32_t offset) {
    std::uint32_t end = offset;
    while (end < text.size() && isBlank(text[end])) ++end;
    if (text.substr(end, 2) == "//")
        while (end < text.size() && text[end] != '\n' && text[end] != '\r') ++end;
    const bool endsLine = end == text.size() || text[end] == '\n' || text[end] == '\r';
    return endsLine ? end : offset;
}

Replacement removal(std::string_view text, std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t from = beforeIndentation(text, begin);
    std::uint32_t to = end;
    while (to < text.size() && isBlank(text[to])) ++to;
    const bool startsLine = from == 0 || text[from - 1] == '\n';
    if (startsLine && to < text.size() && (text[to] == '\n' || text.substr(to, 2) == "\r\n"))
        return {from, to + (text[to] == '\r' ? 2u : 1u), {}};
    return {begin, end, {}};
}

std::string applied(std::string_view text, std::uint32_t begin, std::uint32_t end, std::vector<Replacement> edits) {
    for (Replacement& edit : edits) {
        edit.begin -= begin;
        edit.end -= begin;
    }
    return syntax::apply(std::string(text.substr(begin, end - begin)), {{}, std::move(edits)}).text;
}

namespace {

using Values = std::vector<std::pair<std::string, std::string>>;

/// The last value of each name, in the order of first mention.
Values lastOfEach(const Values& values) {
    Values result;
    for (const auto& [name, value] : values) {
        const auto same = std::find_if(result.begin(), result.end(), [&](const auto& r) { return r.first == name; });
        if (same == result.end())
            result.emplace_back(name, value);
        else
            same->second = value;
    }
    return result;
}

/// Where `= value` goes behind `name` or `name( … )`.
std::uint32_t bindingOffset(const Modification& m) {
    if (!m.hasArguments) return m.name.span.end;
    const std::string& text = m.span.source->text();
    const std::uint32_t from = m.arguments.empty() ? m.name.span.end : m.arguments.back().span.end;
    const auto closing = text.find(')', from);
    return closing == std::string::npos ? m.span.end : static_cast<std::uint32_t>(closing) + 1;
}

/// Changes of one argument list.
class ListEdit {
public:
    explicit ListEdit(const std::vector<Modification>& list) : list_(list), removed_(list.size(), false) {}

    void set(const std::string& name, const std::string& value) {
        for (std::size_t i = 0; i < list_.size(); ++i) {
            const Modification& m = list_[i];
            if (m.redeclaredClass) continue;
            const std::string modified = m.name.text();
            if (modified == name && !m.redeclaredComponent) return setExisting(i, value);
            if (name.starts_with(modified + ".") && (m.redeclaredComponent || !m.arguments.empty())) {
                nested_[i].emplace_back(name.substr(modified.size() + 1), value);
                return;
            }
        }
        for (Redeclared& r : redeclared_)
            if (name.starts_with(r.name + ".")) {
                if (!value.empty()) r.arguments.push_back(name.substr(r.name.size() + 1) + "=" + value);
                return;
            }
        if (!value.empty()) added_.push_back(name + "=" + value);
    }

    /// Gives the element another class; before the values of its own parameters are set.
    void redeclare(const std::string& name, const std::string& className) {
        for (const Modification& m : list_) {
            if (m.redeclaredClass || m.name.text() != name) continue;
            if (m.redeclaredComponent) {
                const Span& type = m.redeclaredComponent->typeSpan;
                edits_.push_back({type.begin, type.end, className});
            } else if (m.span.begin == m.name.span.begin) {
                edits_.push_back({m.span.begin, m.span.begin, "redeclare " + className + " "});
            } else {  // `each`, `final` stand between
                edits_.push_back({m.span.begin, m.span.begin, "redeclare "});
                edits_.push_back({m.name.span.begin, m.name.span.begin, className + " "});
            }
            return;
        }
        redeclared_.push_back({name, className, {}});
    }

    std::vector<Replacement> finish(const Span& listSpan) {
        for (const auto& [i, values] : nested_) {
            if (removed_[i]) continue;
            const auto& component = list_[i].redeclaredComponent;
            ListEdit inner(component ? component->modifications : list_[i].arguments);
            for (const auto& [name, value] : values) inner.set(name, value);
            // The arguments of a nested list have no span of their own; it is never removed as a whole.
            for (Replacement& r : inner.finish(component ? component->modificationsSpan : Span{}))
                edits_.push_back(std::move(r));
        }
        for (const Redeclared& r : redeclared_) {
            std::string text = "redeclare " + r.className + " " + r.name;
            if (!r.arguments.empty()) text += "(" + joined(r.arguments) + ")";
            added_.push_back(std::move(text));
        }
        const bool nothingLeft = std::find(removed_.begin(), removed_.end(), false) == removed_.end();
        if (nothingLeft && listSpan.valid()) return replaceWhole(listSpan);
        cutRuns();
        if (!added_.empty() && !removed_.back()) {
            const std::uint32_t end = list_.back().span.end;
            edits_.push_back({end, end, ", " + joined()});
        }
        return std::move(edits_);
    }

private:
    void setExisting(std::size_t i, const std::string& value) {
        const Modification& m = list_[i];
        if (value.empty()) {
            removed_[i] = true;
        } else if (m.value) {
            // An array of values takes the place of one for each element.
            if (m.each && value.starts_with('{'))
                edits_.push_back({m.span.begin, m.name.span.begin, m.isFinal ? "final " : ""});
            edits_.push_back({m.value->span.begin, m.value->span.end, value});
        } else {
            const std::uint32_t at = bindingOffset(m);
            edits_.push_back({at, at, "=" + value});
        }
    }

    std::vector<Replacement> replaceWhole(const Span& listSpan) const {
        if (added_.empty()) {
            if (list_.empty()) return {};  // nothing to do; an empty `()` stays
            return {{listSpan.begin, listSpan.end, {}}};
        }
        return {{listSpan.begin, listSpan.end, "(" + joined() + ")"}};
    }

    /// Cuts each run of removed arguments with one comma; new arguments take the place of a run at the end.
    void cutRuns() {
        for (std::size_t i = 0; i < list_.size(); ++i) {
            if (!removed_[i]) continue;
            std::size_t last = i;
            while (last + 1 < list_.size() && removed_[last + 1]) ++last;
            if (last + 1 < list_.size()) {
                edits_.push_back({list_[i].span.begin, list_[last + 1].span.begin, {}});
            } else if (i > 0) {
                const std::string tail = added_.empty() ? std::string{} : ", " + joined();
                edits_.push_back({list_[i - 1].span.end, list_[last].span.end, tail});
            } else {
                edits_.push_back({list_[i].span.begin, list_[last].span.end, joined()});
            }
            i = last;
        }
    }

    std::string joined() const { return joined(added_); }

    static std::string joined(const std::vector<std::string>& arguments) {
        std::string text;
        for (const std::string& a : arguments) text += (text.empty() ? "" : ", ") + a;
        return text;
    }

    struct Redeclared {
        std::string name, className;
        std::vector<std::string> arguments;
    };

    const std::vector<Modification>& list_;
    std::vector<bool> removed_;
    std::map<std::size_t, Values> nested_;
    std::vector<std::string> added_;
    std::vector<Redeclared> redeclared_;
    std::vector<Replacement> edits_;
};

}  // namespace

std::vector<Replacement> setModifications(const std::vector<Modification>& list, const Span& listSpan,
                                          const Values& values, const Values& classes) {
    ListEdit edit(list);
    for (const auto& [name, className] : lastOfEach(classes)) edit.redeclare(name, className);
    for (const auto& [name, value] : lastOfEach(values)) edit.set(name, value);
    return edit.finish(listSpan);
}

syntax::Replacement setAnnotation(const std::optional<syntax::Annotation>& annotation, std::uint32_t without,
                                  std::string_view outer, std::string_view inner, const std::string& innerText,
                                  const std::string& fresh) {
    if (!annotation) return {without, without, " annotation (" + fresh + ")"};
    const syntax::Modification* record = annotation->find(outer);
    if (!record) {
        if (annotation->arguments.empty())
            return {annotation->span.begin, annotation->span.end, "annotation (" + fresh + ")"};
        const std::uint32_t end = annotation->arguments.back().span.end;
        return {end, end, ", " + fresh};
    }
    for (const syntax::Modification& member : record->arguments)
        if (member.name.text() == inner) return {member.span.begin, member.span.end, innerText};
    if (record->arguments.empty()) return {record->span.begin, record->span.end, fresh};
    const std::uint32_t begin = record->arguments.front().span.begin;
    return {begin, begin, innerText + ", "};
}

syntax::Replacement setClassAnnotation(const syntax::ClassDefinition& definition, std::string_view outer,
                                       std::string_view inner, const std::string& innerText) {
    const std::string fresh = std::string(outer) + "(" + innerText + ")";
    if (definition.annotation) return setAnnotation(definition.annotation, 0, outer, inner, innerText, fresh);
    const std::string& text = definition.source->text();
    const std::string newline = lineEnd(text), indent = indentation(text, definition.span.begin);
    const std::uint32_t at = beforeIndentation(text, definition.endSpan.begin);
    const bool startsLine = at == 0 || text[at - 1] == '\n';
    return {
        at, at,
        (startsLine ? "" : newline) + indent + "  annotation (" + fresh + ");" + newline + (startsLine ? "" : indent)};
}

}  // namespace analogon::edit_text
