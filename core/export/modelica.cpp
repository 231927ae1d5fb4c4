#include "core/export/modelica.hpp"

#include <fmt/format.h>

#include <deque>
#include <map>
#include <set>

#include "core/study/present_values.hpp"

namespace analogon {

namespace {

using syntax::ClassDefinition;
using syntax::Component;
using syntax::Equation;
using syntax::Expression;
using syntax::Modification;
using syntax::Name;

/// Every name in a class that may mean another class: of types, bases, functions, constants.
class UsedNames {
public:
    explicit UsedNames(const ClassDefinition& definition) { visit(definition); }
    const std::vector<Name>& names() const { return names_; }

private:
    void visit(const ClassDefinition& c) {
        for (const syntax::Import& i : c.imports) names_.push_back(i.name);
        for (const syntax::Extends& e : c.bases) {
            names_.push_back(e.base);
            for (const Modification& m : e.modifications) visit(m);
        }
        for (const Component& component : c.components) visit(component);
        for (const auto* sections : {&c.equationSections, &c.algorithmSections})
            for (const syntax::EquationSection& s : *sections)
                for (const Equation& e : s.equations) visit(e);
        if (c.isShort) names_.push_back(c.shortBase);
        for (const Modification& m : c.shortModifications) visit(m);
        if (c.constrainedBy) names_.push_back(*c.constrainedBy);
        for (const syntax::ClassPtr& inner : c.classes) visit(*inner);
    }
    void visit(const Component& c) {
        names_.push_back(c.type);
        for (const Expression& e : c.dimensions) visit(e);
        for (const Modification& m : c.modifications) visit(m);
        if (c.binding) visit(*c.binding);
        if (c.condition) visit(*c.condition);
        if (c.constrainedBy) names_.push_back(*c.constrainedBy);
    }
    void visit(const Modification& m) {
        if (m.value) visit(*m.value);
        for (const Modification& a : m.arguments) visit(a);
        if (m.redeclaredComponent) visit(*m.redeclaredComponent);
        if (m.redeclaredClass) visit(*m.redeclaredClass);
    }
    void visit(const Expression& e) {
        if (!e.name.parts.empty()) names_.push_back(e.name);
        for (const Expression& o : e.operands) visit(o);
        for (const syntax::NamedArgument& a : e.named) visit(a.value);
    }
    void visit(const Equation& e) {
        visit(e.left);
        visit(e.right);
        for (const Equation::Branch& b : e.branches) {
            if (b.condition) visit(*b.condition);
            for (const Equation& inner : b.body) visit(inner);
        }
        for (const Equation& inner : e.body) visit(inner);
    }

    std::vector<Name> names_;
};

/// The class a dotted name means, or the one that holds the constant or function it ends in.
const LibraryClass* resolve(const Library& library, const Name& name, const std::string& scope) {
    if (const LibraryClass* found = library.lookup(name, scope)) return found;
    Name shorter = name;
    while (shorter.parts.size() > 1) {
        shorter.parts.pop_back();
        if (const LibraryClass* found = library.lookup(shorter, scope)) return found;
    }
    return nullptr;
}

/// Full names of the classes that `start` needs, directly or through others.
std::set<std::string> neededBy(const Library& library, const std::vector<std::string>& start) {
    std::set<std::string> needed(start.begin(), start.end());
    std::deque<std::string> open(start.begin(), start.end());
    while (!open.empty()) {
        const LibraryClass* cls = library.find(open.front());
        open.pop_front();
        if (!cls || !cls->definition) continue;
        const UsedNames used(*cls->definition);
        for (const Name& name : used.names()) {
            const LibraryClass* found = resolve(library, name, cls->qualifiedName);
            if (found && needed.insert(found->qualifiedName).second) open.push_back(found->qualifiedName);
        }
    }
    return needed;
}

std::string indented(std::string_view text, const std::string& indent) {
    std::string result = indent;
    for (const char c : text) {
        result += c;
        if (c == '\n') result += indent;
    }
    return result;
}

/// Prints the packages of a library reduced to the classes that are needed.
class Reduced {
public:
    Reduced(const Library& library, const std::set<std::string>& needed) : library_(library), needed_(needed) {}

    std::string print(const LibraryClass& cls, const std::string& indent) const {
        const ClassDefinition& d = *cls.definition;
        const bool isPackage = d.restriction == ClassDefinition::Restriction::Package && !d.isShort;
        if (!isPackage || holdsMore(d)) return indented(d.span.text(), indent) + ";\n";
        std::string text = indent + "package " + d.name;
        if (!d.description.empty()) text += " " + quoted(d.description);
        text += "\n";
        for (const LibraryClass* inner : library_.classes())
            if (inner->scope == cls.qualifiedName && isUsed(inner->qualifiedName)) text += print(*inner, indent + "  ");
        return text + indent + "end " + d.name + ";\n";
    }

    bool isUsed(const std::string& name) const {
        if (needed_.contains(name)) return true;
        const auto next = needed_.lower_bound(name + ".");
        return next != needed_.end() && next->starts_with(name + ".");
    }

private:
    /// Constants and the like: such a package is taken as a whole, if its text holds all of it.
    static bool holdsMore(const ClassDefinition& d) { return !d.components.empty() || !d.bases.empty(); }
    static std::string quoted(const std::string& text) {
        std::string result = "\"";
        for (const char c : text) {
            if (c == '"' || c == '\\') result += '\\';
            result += c;
        }
        return result + "\"";
    }

    const Library& library_;
    const std::set<std::string>& needed_;
};

/// Name of a class's outermost package, or of itself.
std::string topOf(const std::string& qualifiedName) { return qualifiedName.substr(0, qualifiedName.find('.')); }

}  // namespace

Outcome<std::string> modelicaText(const Study& given) {
    const Outcome<Study> study = withPresentValues(given);
    if (!study) return study.diagnostics();
    const Outcome<Library> library = studyLibrary(*study);
    if (!library) return library.diagnostics();
    if (!library->find(study->className))
        return fileError(phrase("the study's class {} is in none of its files", study->className), study->modelFile);
    const std::set<std::string> needed = neededBy(*library, {study->className});
    const Reduced reduced(*library, needed);

    std::string text =
        fmt::format("// {}: the model of the study \"{}\" with all classes it uses.\n", study->className, study->name);
    const std::string last = topOf(study->className);
    for (const LibraryClass* cls : library->classes())
        if (cls->scope.empty() && cls->qualifiedName != last && reduced.isUsed(cls->qualifiedName))
            text += "\n" + reduced.print(*cls, "");
    text += "\n" + reduced.print(*library->find(last), "");
    return text;
}

}  // namespace analogon
