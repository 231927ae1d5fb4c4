#include "core/effect/catalogue/finding.hpp"

#include <cctype>

#include "core/base/unit.hpp"

namespace analogon {

const char* name(Way way) {
    switch (way) {
        case Way::Attach:
            return "attach";
        case Way::Insert:
            return "insert";
        case Way::Specialise:
            return "specialise";
        case Way::Bridge:
            return "bridge";
    }
    return "";
}

const char* name(Verdict verdict) {
    switch (verdict) {
        case Verdict::Chosen:
            return "chosen";
        case Verdict::Equivalent:
            return "equivalent";
        case Verdict::Weaker:
            return "weaker";
        case Verdict::NotSignificant:
            return "not significant";
        case Verdict::Absorbed:
            return "absorbed";
        case Verdict::WrongSign:
            return "wrong sign";
        case Verdict::FailsHeldOut:
            return "fails held-out blocks";
        case Verdict::Failed:
            return "failed";
    }
    return "";
}

const char* name(Confidence confidence) { return confidence == Confidence::Established ? "established" : "indicated"; }

const char* name(FindingKind kind) {
    switch (kind) {
        case FindingKind::Adequate:
            return "adequate";
        case FindingKind::Effect:
            return "effect";
        case FindingKind::Partial:
            return "partial";
        case FindingKind::Unexplained:
            return "unexplained";
        case FindingKind::Interrupted:
            return "interrupted";
    }
    return "";
}

/// An equation with the values of what it names: "y = min(u, y_max) with y_max = 4.2".
Text withValues(const std::string& equation, const std::vector<EffectValue>& values) {
    const auto isPart = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; };
    const auto names = [&](const std::string& name) {
        for (std::size_t at = equation.find(name); at != std::string::npos; at = equation.find(name, at + 1)) {
            const std::size_t end = at + name.size();
            if ((at == 0 || !isPart(equation[at - 1])) && (end == equation.size() || !isPart(equation[end])))
                return true;
        }
        return false;
    };
    Text list;
    for (const EffectValue& v : values) {
        if (!names(v.name)) continue;
        if (!list.empty()) list += ", ";
        list += phrase("{} = {:.4g}{}", v.name, v.value, behindNumber(v.unit));
    }
    return list.empty() ? Text(equation) : phrase("{} with {}", equation, list);
}

}  // namespace analogon
