#include "ui/find/study_entries.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <array>

#include "ui/document/document.hpp"
#include "ui/effect/finding_words.hpp"
#include "ui/signals/signal_list.hpp"
#include "ui/style/number.hpp"
#include "ui/style/sought_words.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

using Kind = StudyEntry::Kind;

QString words(const char* text) { return QCoreApplication::translate("analogon::ui::FindDialog", text); }
QString of(const std::string& text) { return QString::fromStdString(text); }

/// Parts that there are, with a dot between.
QString dotted(const QStringList& parts) {
    QStringList told = parts;
    told.removeAll(QString());
    return told.join(QStringLiteral(" · "));
}

class Collector {
public:
    explicit Collector(const Document& document) : document_(document) {}

    std::vector<StudyEntry> collect() {
        components();
        parameters();
        signalsOfAll();
        recordings();
        tried();
        runs();
        texts();
        return std::move(entries_);
    }

private:
    void add(StudyEntry entry) { entries_.push_back(withWords(std::move(entry))); }

    /// Of the study's model, whatever diagram is shown.
    void components() {
        const std::string& own = document_.study().className;
        if (document_.shownClass() == own || document_.shownClass().empty()) return components(document_.diagram());
        if (const Outcome<Diagram> diagram = readDiagram(document_.library(), own)) components(*diagram);
    }
    void components(const Diagram& diagram) {
        for (const Block& block : diagram.blocks)
            add({Kind::Component, of(block.name),
                 dotted({of(block.className), shortDescription(of(block.description))}), of(block.name)});
    }

    void parameters() {
        for (const ParameterFact& fact : document_.facts().parameters) {
            const auto own = document_.study().parameters.find(fact.name);
            const bool isOwn = own != document_.study().parameters.end() && own->second.value;
            const std::optional<double> value = isOwn ? own->second.value : fact.value;
            const QString number = value ? (style::numberText(*value, 5) + " " + of(fact.unit)).trimmed() : QString();
            add({Kind::Parameter, of(fact.name), dotted({number, shortDescription(of(fact.description))}),
                 of(fact.name)});
        }
    }

    void signalsOfAll() {
        for (const Signal& signal : allSignals(document_, {}))
            add({Kind::Signal, signal.reference.name, dotted({signal.group, signal.unit, signal.description}),
                 signal.reference.name, signal.reference.recording});
    }

    void recordings() {
        for (const StudyExperiment& e : document_.study().experiments)
            add({Kind::Recording, of(e.name),
                 dotted({of(e.file), e.role == Role::Fit ? words("fit") : words("validate")}), of(e.name)});
    }

    void tried() {
        const Finding* finding = document_.finding();
        if (!finding) return;
        for (const CandidateResult& c : finding->candidates) {
            const LibraryClass* cls = document_.library().find(c.className);
            const QString what = cls ? shortDescription(of(cls->definition->description)) : QString();
            add({Kind::Tried, what.isEmpty() ? of(c.kind) : what,
                 dotted({placeText(of(c.at), of(c.channel)), of(c.kind), verdictText(c.verdict)}), of(c.kind),
                 of(c.at)});
        }
    }

    void runs() {
        for (const RunRecord& run : document_.history())
            add({Kind::Run,
                 run.label(),
                 dotted({run.name.isEmpty() ? QString() : run.when, run.note}),
                 {},
                 {},
                 run.number});
    }

    /// Lines of the models' texts that hold something.
    void texts() {
        for (const auto& [file, text] : document_.study().models) {
            unsigned long line = 0;
            for (const QString& each : of(text).split('\n')) {
                ++line;
                constexpr qsizetype longest = 300;  // characters: what follows are annotations
                if (const QString shown = each.simplified(); !shown.isEmpty())
                    add({Kind::Text,
                         shown.left(longest),
                         words("%1, line %2").arg(of(file)).arg(line),
                         of(file),
                         {},
                         line});
            }
        }
    }

    const Document& document_;
    std::vector<StudyEntry> entries_;
};

}  // namespace

QString titleOf(StudyEntry::Kind kind) {
    static constexpr std::array titles{QT_TRANSLATE_NOOP("analogon::ui::FindDialog", "Components"),
                                       QT_TRANSLATE_NOOP("analogon::ui::FindDialog", "Parameters"),
                                       QT_TRANSLATE_NOOP("analogon::ui::FindDialog", "Signals"),
                                       QT_TRANSLATE_NOOP("analogon::ui::FindDialog", "Recordings"),
                                       QT_TRANSLATE_NOOP("analogon::ui::FindDialog", "What was tried"),
                                       QT_TRANSLATE_NOOP("analogon::ui::FindDialog", "Runs"),
                                       QT_TRANSLATE_NOOP("analogon::ui::FindDialog", "Text of the models")};
    return words(titles[static_cast<std::size_t>(kind)]);
}

StudyEntry withWords(StudyEntry entry) {
    entry.words = (entry.name + '\n' + entry.detail).toLower();
    return entry;
}

std::vector<StudyEntry> studyEntries(const Document& document) {
    return document.isOpen() ? Collector(document).collect() : std::vector<StudyEntry>();
}

std::vector<int> matchingEntries(const std::vector<StudyEntry>& entries, const QString& query) {
    const style::SoughtWords asked(query);
    std::vector<int> found;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const StudyEntry& entry = entries[i];
        if (asked.isEmpty() && entry.kind == Kind::Text) continue;
        if (asked.areIn(entry.words)) found.push_back(static_cast<int>(i));
    }
    if (asked.isEmpty()) return found;
    const auto rank = [&](int i) {
        const StudyEntry& entry = entries[static_cast<std::size_t>(i)];
        return std::pair(entry.kind, entry.words.startsWith(asked.first()) ? 0 : 1);
    };
    std::stable_sort(found.begin(), found.end(), [&](int a, int b) { return rank(a) < rank(b); });
    return found;
}

}  // namespace analogon::ui
