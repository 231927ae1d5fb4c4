#include "ui/text/name_completion.hpp"

#include <QRegularExpression>
#include <algorithm>
#include <set>

#include "core/library/library.hpp"
#include "core/library/package_entries.hpp"

namespace analogon::ui {

namespace {

constexpr std::size_t most = 200;  // that are worth showing

const char* const keywords[] = {"parameter", "constant",   "input",       "output",    "extends",
                                "equation",  "annotation", "connect",     "model",     "initial",
                                "algorithm", "redeclare",  "replaceable", "protected", "public",
                                "discrete",  "Real",       "Integer",     "Boolean",   "String"};

QString text(const std::string& s) { return QString::fromStdString(s); }

bool begins(const QString& name, const QString& typed) { return name.startsWith(typed, Qt::CaseInsensitive); }

/// Whether the end of a text lies within a comment or a string.
bool endsInComment(const QString& before) {
    enum { Code, Line, Block, Text } state = Code;
    for (qsizetype i = 0; i < before.size(); ++i) {
        const QStringView two = QStringView(before).mid(i, 2);
        if (state == Code && two == u"//")
            state = Line;
        else if (state == Code && two == u"/*")
            state = Block, ++i;
        else if (state == Code && before[i] == u'"')
            state = Text;
        else if (state == Line && before[i] == u'\n')
            state = Code;
        else if (state == Block && two == u"*/")
            state = Code, ++i;
        else if (state == Text && before[i] == u'\\')
            ++i;
        else if (state == Text && before[i] == u'"')
            state = Code;
    }
    return state != Code;
}

/// The name before the innermost parenthesis that is open at the end; empty: there is none, or no name stands there.
QString openedName(const QString& before) {
    int depth = 0;
    for (qsizetype i = before.size() - 1; i >= 0 && before[i] != u';'; --i) {
        if (before[i] == u')') ++depth;
        if (before[i] != u'(' || depth-- > 0) continue;
        static const QRegularExpression name(R"(([A-Za-z_]\w*)\s*$)");
        return name.match(before.left(i)).captured(1);
    }
    return {};
}

class Offers {
public:
    Offers(const Library& library, const std::string& model, const QString& before)
        : library_(library), scope_(model), before_(before) {
        if (const LibraryClass* own = library.find(model)) definition_ = own->definition.get();
    }

    void addMembers(const LibraryClass& of, const QString& typed, bool onlyParameters) {
        constexpr std::size_t mostBases = 100;
        if (seen_.size() > mostBases || !seen_.insert(of.qualifiedName).second) return;
        for (const LibraryClass* base : library_.bases(of)) addMembers(*base, typed, onlyParameters);
        for (const syntax::Component& c : of.definition->components)
            if (!c.isProtected && (!onlyParameters || c.variability == syntax::Variability::Parameter))
                add(text(c.name), typed, c.description.empty() ? text(c.type.text()) : text(c.description));
    }
    /// Those in files of their own are not read for it: what they are is not told.
    void addClassesOf(const std::string& package, const QString& typed) {
        for (const PackageEntry& entry : packageEntries(library_, package))
            add(text(entry.name), typed, entry.read ? text(entry.read->definition->description) : QString());
    }
    void addOwn(const QString& typed) {
        if (definition_)
            for (const syntax::Component& c : definition_->components) add(text(c.name), typed, text(c.type.text()));
        static const QRegularExpression declared(
            R"((?:^|;)\s*(?:(?:parameter|input|output)\s+)*([A-Za-z_][\w.]*)\s+([A-Za-z_]\w*)\s*[;(=\x22])",
            QRegularExpression::MultilineOption);
        for (auto i = declared.globalMatch(before_); i.hasNext();) {  // what is new in a text that does not parse yet
            const QRegularExpressionMatch match = i.next();
            const QString type = match.captured(1);
            if (library_.lookup(type.toStdString(), scope_)) add(match.captured(2), typed, type);
        }
        for (const char* word : keywords) add(QString::fromLatin1(word), typed, {});
    }
    /// By the short name, with the full one as what is put in.
    void addClasses(const QString& typed) {
        for (const LibraryClass* c : library_.classes()) {
            if (c->definition->isProtected || c->definition->isPartial) continue;
            if (!begins(text(c->definition->name), typed)) continue;
            const QString full = text(c->qualifiedName);
            put(definition_ && c->definition->name == definition_->name ? text(c->definition->name) : full,
                text(c->definition->description));
        }
    }
    /// The class of what a dotted path of components leads to; null: that cannot be told.
    const LibraryClass* classOf(const QStringList& path) const {
        const LibraryClass* at{};
        for (const QString& name : path) {
            const std::string type = at ? typeIn(*at, name.toStdString()) : declaredType(name);
            at = type.empty() ? nullptr : library_.lookup(type, at ? at->qualifiedName : scope());
            if (!at) return nullptr;
        }
        return at;
    }
    const std::string& scope() const { return scope_; }
    std::vector<NameOffer> take() {
        if (offers_.size() > most) offers_.resize(most);
        return std::move(offers_);
    }

private:
    void put(const QString& name, const QString& detail) {
        for (const NameOffer& there : offers_)
            if (there.name == name) return;
        offers_.push_back({name, detail});
    }
    void add(const QString& name, const QString& typed, const QString& detail) {
        if (begins(name, typed)) put(name, detail);
    }
    std::string typeIn(const LibraryClass& in, const std::string& name, int depth = 0) const {
        constexpr int deepest = 30;
        for (const syntax::Component& c : in.definition->components)
            if (c.name == name) return c.type.text();
        if (depth >= deepest) return {};
        for (const LibraryClass* base : library_.bases(in))
            if (const std::string type = typeIn(*base, name, depth + 1); !type.empty()) {
                const LibraryClass* of = library_.lookup(type, base->qualifiedName);
                return of ? of->qualifiedName : type;
            }
        return {};
    }
    /// As the text says, also where it does not parse.
    std::string declaredType(const QString& name) const {
        if (definition_)
            for (const syntax::Component& c : definition_->components)
                if (c.name == name.toStdString()) return c.type.text();
        const QRegularExpression declared(R"(([A-Za-z_][\w.]*)\s+)" + QRegularExpression::escape(name) + R"(\b)");
        for (auto i = declared.globalMatch(before_); i.hasNext();) {
            const std::string type = i.next().captured(1).toStdString();
            if (library_.lookup(type, scope())) return type;
        }
        return {};
    }

    const Library& library_;
    std::string scope_;
    const syntax::ClassDefinition* definition_{};
    QString before_;
    std::set<std::string> seen_;
    std::vector<NameOffer> offers_;
};

}  // namespace

NameOffers nameOffers(const Library& library, const std::string& model, const QString& before) {
    if (endsInComment(before)) return {};
    static const QRegularExpression last(R"((?:[A-Za-z_]\w*(?:\[[^\]\n]*\])?\.)*(?:[A-Za-z_]\w*)?$)");
    const QString dotted = last.match(before).captured(0);
    const QChar ahead = before.size() > dotted.size() ? before[before.size() - dotted.size() - 1] : QChar();
    if (ahead.isLetterOrNumber() || ahead == u'.') return {};  // a number
    QStringList path = dotted.split(u'.');
    const QString typed = path.takeLast();
    Offers offers(library, model, before);
    if (!path.isEmpty()) {
        QStringList names = path;
        static const QRegularExpression subscripts(R"(\[.*\])");
        for (QString& name : names) name.remove(subscripts);
        const LibraryClass* named = library.lookup(path.join(u'.').toStdString(), offers.scope());
        const bool isPackage = named && named->definition->restriction == syntax::ClassDefinition::Restriction::Package;
        // What stands before the name of a package looks like a declaration of it: "model Drive  Modelica."
        if (const LibraryClass* of = isPackage ? nullptr : offers.classOf(names))
            offers.addMembers(*of, typed, false);
        else if (named)
            offers.addClassesOf(named->qualifiedName, typed);
    } else {
        const QString opened = openedName(before.left(before.size() - dotted.size()));
        const LibraryClass* of = opened.isEmpty() ? nullptr : offers.classOf({opened});
        if (of) offers.addMembers(*of, typed, true);
        offers.addOwn(typed);
        if (!typed.isEmpty()) offers.addClasses(typed);
        if (!typed.isEmpty()) offers.addClassesOf({}, typed);
    }
    return {static_cast<int>(typed.size()), offers.take()};
}

}  // namespace analogon::ui
