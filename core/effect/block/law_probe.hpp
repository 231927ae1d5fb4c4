#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/effect/block/law_term.hpp"
#include "core/effect/block/screen.hpp"
#include "core/effect/model/place.hpp"

namespace analogon {

/// A law that the model lacks, written as a class with the description of an effect.
struct Law {
    Candidate candidate;
    std::string text;  // of the class
};

/// A place where a sum of terms may be missing, and how a class says so that stands there.
struct LawSite {
    EffectPlace place;
    std::string baseName;             // of its classes: "MissingTorque"
    std::string declaration;          // of its connectors: "Analogon.Interfaces.Flange_a port"
    std::string sum;                  // what the terms add up to, in the class: "port.tau ="
    std::string shown;                // and as people read it: "rotor.flange_a.tau ="
    std::optional<UnitFactors> unit;  // of the sum
    Way way{Way::Attach};
    std::vector<std::string> ports;
    std::string signalSide{};
};

/// At a node whose balance of flows may lack something.
LawSite siteOf(const ModelNodes::FlowNode& node);
/// What a sensor would show without the law, in an equation that people read: "w_true" of the output w.
std::string trueReading(const std::string& output);

/// At an output of the model, whose sensor may add something to what it reads.
LawSite siteOf(const std::string& output, const std::string& unit);

/// One site with the terms that a law there may have.
class LawProbe {
public:
    LawProbe(const NullModel& null, LawSite site) : null_(&null), site_(std::move(site)) {}

    const EffectPlace& place() const { return site_.place; }

    /// Adds a quantity of the class: one of the site's own, by its expression there, or one of the model.
    const LawQuantity& addOwn(LawQuantity quantity, std::string expression);
    const LawQuantity& addForeign(LawQuantity quantity);

    std::vector<Term>& terms() { return terms_; }
    const std::vector<Term>& terms() const { return terms_; }

    /// Traces of all terms at coefficients 0, in units of the noise.
    std::optional<Eigen::MatrixXd> traces(const SimulationOptions& simulation, const Progress& progress) const;

    /// The law of these terms; its class has this number among those of its kind.
    Law law(const std::vector<std::size_t>& chosen, int number) const;

private:
    struct Own {
        LawQuantity quantity;
        std::string expression;
    };

    std::optional<Eigen::MatrixXd> tracesOf(const std::vector<std::size_t>& some, const SimulationOptions& simulation,
                                            const Progress& progress) const;
    std::string className(int number) const;
    std::string unitOf(const Term& term) const;
    bool uses(const std::vector<std::size_t>& chosen, const std::string& name) const;
    EffectClass effect(const std::string& name, const std::vector<std::size_t>& chosen) const;
    std::string classText(const std::string& name, const std::vector<std::size_t>& chosen) const;

    const NullModel* null_;
    LawSite site_;
    std::vector<Own> own_;
    std::vector<LawQuantity> foreign_;
    std::vector<Term> terms_;
};

}  // namespace analogon
