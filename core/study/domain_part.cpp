#include "core/study/domain_part.hpp"

#include <fmt/format.h>

#include <cctype>
#include <utility>

#include "core/flat/flat_model.hpp"

namespace analogon {

namespace {

/// "electric-thermal" as "ElectricThermal"; the adjectives of mechanics and electricity are taken for one another.
std::string packageOf(const std::string& domain) {
    if (domain == "mechanical" || domain == "mechanic") return "Mechanics";
    std::string out, word;
    const auto close = [&] {
        if (word == "electrical" || word == "electro") word = "electric";
        if (word == "mechanical" && out.empty()) word = "mechanic";
        if (word == "mechanic" && !out.empty()) word = "mechanical";
        if (!word.empty()) word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
        out += std::exchange(word, {});
    };
    for (const char c : domain) {
        if (c == '-' || c == '_' || c == ' ') {
            close();
        } else {
            word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        }
    }
    close();
    return out;
}

std::string domainOf(const std::string& package) {
    std::string out;
    for (const char c : package) {
        if (std::isupper(static_cast<unsigned char>(c)) && !out.empty()) out += '-';
        out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return out;
}

/// What an instance of a basic class is called in a model.
std::string instanceName(const std::string& package) {
    if (package == "ElectricMechanical") return "motor";
    if (package == "ElectricThermal") return "heater";
    if (package == "ThermalFluid") return "body";
    if (package == "MechanicThermal") return "bearing";
    std::string name = package;
    name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
    return name;
}

Diagnostic unknownDomain(const Library& library, const std::string& domain) {
    const std::vector<std::string> known = knownDomains(library);
    const std::string alike = suggestion(domain, known);
    return fileError(phrase("the domain '{}' is not known", domain), "", 0, 0,
                     (alike.empty() ? Text() : phrase("Did you mean '{}'? ", alike)) +
                         phrase("Known are: {}.", fmt::join(known, ", ")));
}

}  // namespace

bool isOutgoing(const Port& port) { return port.className.ends_with("_b"); }

Outcome<DomainPart> readDomainPart(const Library& library, const std::string& domain) {
    DomainPart part;
    part.package = packageOf(domain);
    part.className = fmt::format("Analogon.{0}.Basic{0}", part.package);
    if (domain.empty() || !library.find(part.className)) return unknownDomain(library, domain);
    part.name = instanceName(part.package);

    const Outcome<FlatModel> flat = flatten(library, part.className);
    if (!flat) return flat.diagnostics();
    for (const FlatVariable& variable : flat->variables) {
        if (variable.causality == FlatCausality::Input) part.inputs.push_back({variable.name, variable.unit});
        if (variable.causality == FlatCausality::Output) part.outputs.push_back({variable.name, variable.unit});
    }
    // A model with one instance shows the connectors as a diagram does.
    const Outcome<Library> probe = library.withSource(std::make_shared<const Source>(
        "probe.mo", fmt::format("model AnalogonProbe\n  {} part;\nend AnalogonProbe;\n", part.className)));
    if (!probe) return probe.diagnostics();
    const Outcome<Diagram> diagram = readDiagram(*probe, "AnalogonProbe");
    if (!diagram) return diagram.diagnostics();
    for (const Block& block : diagram->blocks)
        for (const Port& port : block.ports)
            if (port.domain == Domain::Rotational || port.domain == Domain::Heat) part.ports.push_back(port);
    return part;
}

std::vector<std::string> knownDomains(const Library& library) {
    std::vector<std::string> domains;
    for (const LibraryClass* known : library.classes()) {
        const std::string package = known->scope.substr(known->scope.rfind('.') + 1);
        if (!known->scope.empty() && known->qualifiedName == known->scope + ".Basic" + package)
            domains.push_back(domainOf(package));
    }
    return domains;
}

}  // namespace analogon
