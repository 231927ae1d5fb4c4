#include "core/effect/finding.hpp"

namespace analogon {

const char* name(Way way) {
    switch (way) {
        case Way::Attach:
            return "attach";
        case Way::Insert:
            return "insert";
        case Way::Specialise:
            return "specialise";
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
    }
    return "";
}

}  // namespace analogon
