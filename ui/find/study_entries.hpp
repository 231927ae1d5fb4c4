#pragma once

#include <QString>
#include <vector>

namespace analogon::ui {

class Document;

/// Something of the study that can be found, and what leads to it.
struct StudyEntry {
    enum class Kind { Component, Parameter, Signal, Recording, Tried, Run, Text };
    Kind kind{Kind::Component};
    QString name;    // as it is shown
    QString detail;  // value, description, place
    QString target;  // the whole name of a component, parameter, signal or recording; file of a text; kind of an effect
    QString place{};         // of an effect that was tried; the recording of a channel
    unsigned long number{};  // line of a text; number of a run
    QString words{};         // what is searched, in small letters
};

QString titleOf(StudyEntry::Kind kind);

/// All of them, kind by kind, in the order of the study.
std::vector<StudyEntry> studyEntries(const Document& document);

/// Fills in what is searched of an entry.
StudyEntry withWords(StudyEntry entry);

/// Indices of those that hold each word of a query, kind by kind: within a kind first those whose name begins with it.
/// Texts are sought only once something is asked for.
std::vector<int> matchingEntries(const std::vector<StudyEntry>& entries, const QString& query);

}  // namespace analogon::ui
