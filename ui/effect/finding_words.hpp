#pragma once

#include <QString>
#include <functional>
#include <string>
#include <vector>

#include "ui/document/document.hpp"

/// What a finding says, in the language of the screen: for the panel and for paper.
namespace analogon::ui {

/// "Dry friction at rotor.flange_b", for headings, labels on the diagram and the undo list.
QString effectTitle(const AddedEffect& effect);

/// The first clause of a class's description, in the language of the screen.
QString shortDescription(const QString& description);

/// "Dry friction": the effect without its place.
QString effectName(const AddedEffect& effect);

/// "output T" in the language of the screen, with the recorded channel that drives an effect there.
QString placeText(const QString& at, const QString& channel = {});
QString verdictText(Verdict verdict);

/// "T" of "output T": what the diagram knows a place by.
QString placeOf(const QString& at);

/// "a, b"
QString joined(const std::vector<std::string>& names);

struct FindingWords {
    QString title, sentence;
    bool isGood{};  // nothing to mind
};
FindingWords findingWords(const Finding& finding, RunKind kind);

/// What the data cannot tell an effect from; empty: nothing.
QString equivalentWords(const AddedEffect& effect);

struct RemainderWords {
    QString heading, where, movesWith;  // movesWith: may be empty
    QString proposal, proposalFacts;    // an equation without a name; may be empty
};
/// `named` says a recording or a node, with a link to it say.
RemainderWords remainderWords(const Remainder& remainder, const std::function<QString(const std::string&)>& named);

}  // namespace analogon::ui
