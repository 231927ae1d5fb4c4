#pragma once

#include <deque>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/flat/external_functions.hpp"
#include "core/flat/instance.hpp"

/// The work on one class, shared by the steps of flatten():
///
///   ClassRules    what a class must not hold
///   Instantiator  class -> instances and scalar variables
///   Translator    expression of the text -> expression of the flat model
///   Binder        modifications -> attributes and values of variables
///   Equations     equation sections -> scalar equations
///   Connections   connect equations -> connection sets -> scalar equations
///   Balance       equations against unknowns
namespace analogon {

class ClassRules;
class Instantiator;
class Translator;
class Binder;
class Connections;
class Events;

struct Flattening {
    explicit Flattening(const Library& lib);
    ~Flattening();
    Flattening(const Flattening&) = delete;
    Flattening& operator=(const Flattening&) = delete;

    const Library& library;
    FlatModel model;
    ExpressionPool& pool;
    Messages messages;
    std::deque<Instance> instances;
    std::vector<Instance*> components;    // instances of models and blocks, the model itself first
    std::vector<VariableRecord> records;  // parallel to model.variables

    std::unique_ptr<ClassRules> rules;
    std::unique_ptr<Instantiator> instantiator;
    std::unique_ptr<Translator> translator;
    std::unique_ptr<Binder> binder;
    std::unique_ptr<Connections> connections;
    std::unique_ptr<Events> events;
    std::vector<ExternalTable> tables;    // the external objects
    std::set<std::string> free;           // parameters that stay themselves in the ordinates of tables
    std::set<std::string> instanceNames;  // that were asked for by getInstanceName()
    bool lacksClass{};                    // one was named that is not known

    /// Library lookup from a class outward, remembered.
    const LibraryClass* lookup(const syntax::Name& name, const LibraryClass* from);
    const LibraryClass* lookup(const std::string& name, const LibraryClass* from);
    /// Says once that a name is an old one of what was found.
    void tellNewName(const syntax::Name& name);
    /// Where a name leads into the Modelica Standard Library and there is none: says so, and ends the work.
    bool isOfMissingLibrary(const syntax::Name& name, const LibraryClass* from);
    /// A class that is not there: whose it is, or what may be meant.
    void reportUnknownClass(const syntax::Name& name, const LibraryClass* from);
    /// The text of the class must live as long as the result.
    void keepSource(const syntax::ClassDefinition& definition);

    Element& elementOf(VariableId id) { return records[id.value].owner->elements[records[id.value].element]; }
    const FlatVariable& variable(VariableId id) const { return model.variables[id.value]; }
    bool isContinuous(VariableId id) const { return variable(id).variability == FlatVariability::Continuous; }

private:
    std::unordered_map<const LibraryClass*, std::unordered_map<std::string, const LibraryClass*>> found_;
    std::unordered_set<const Source*> kept_;
    std::unordered_set<std::string_view> told_;  // old names
};

}  // namespace analogon
