#include "ui/effect/finding_words.hpp"

#include <QCoreApplication>
#include <QRegularExpression>

#include "ui/effect/result_panel.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

QString text(const std::string& s) { return QString::fromStdString(s); }

}  // namespace

QString joined(const std::vector<std::string>& names) {
    QStringList list;
    for (const std::string& n : names) list << text(n);
    return list.join(", ");
}

QString placeOf(const QString& at) {
    return at.startsWith("output ") || at.startsWith("input ") ? at.section(' ', 1) : at;
}

QString shortDescription(const QString& description) {
    const QString whole = QCoreApplication::translate("Library", description.toUtf8().constData());
    // German has a comma before a relative clause where English has none; it tells one effect from another
    static const QRegularExpression detail("[,;:.(]"), clause("[;:.(]");
    return whole.section(description.contains(',') ? detail : clause, 0, 0).trimmed();
}

QString placeText(const QString& at, const QString& channel) {
    if (channel.startsWith("input ")) return ResultPanel::tr("%1 by %2").arg(placeText(at), placeText(channel));
    if (!channel.isEmpty()) return ResultPanel::tr("%1 by channel %2").arg(placeText(at), channel);
    if (at.startsWith("output ")) return ResultPanel::tr("output %1").arg(placeOf(at));
    if (at.startsWith("input ")) return ResultPanel::tr("input %1").arg(placeOf(at));
    return at;
}

QString verdictText(Verdict verdict) {
    switch (verdict) {
        case Verdict::Chosen:
            return ResultPanel::tr("chosen");
        case Verdict::Equivalent:
            return ResultPanel::tr("equivalent");
        case Verdict::Weaker:
            return ResultPanel::tr("weaker");
        case Verdict::NotSignificant:
            return ResultPanel::tr("not significant");
        case Verdict::Absorbed:
            return ResultPanel::tr("absorbed");
        case Verdict::WrongSign:
            return ResultPanel::tr("wrong sign");
        case Verdict::FailsHeldOut:
            return ResultPanel::tr("fails on held-out data");
        case Verdict::Failed:
            break;
    }
    return ResultPanel::tr("failed");
}

QString effectName(const AddedEffect& effect) {
    return shortDescription(text(effect.description.empty() ? effect.kind : effect.description));
}

QString effectTitle(const AddedEffect& effect) {
    return ResultPanel::tr("%1 at %2").arg(effectName(effect), placeText(text(effect.at), text(effect.wired.channel)));
}

FindingWords findingWords(const Finding& finding, RunKind kind) {
    const auto tr = [](const char* s) { return ResultPanel::tr(s); };
    if (kind == RunKind::Fit) {
        const bool converged = finding.final.status == FitStatus::Converged;
        const QString message = converged ? tr("The error cannot be made smaller by changing the fitted parameters.")
                                          : inWords(finding.final.message);
        if (finding.end.interrupted || finding.final.status == FitStatus::Cancelled)
            return {tr("Fit stopped"), tr("The best parameters so far are shown."), false};
        std::vector<std::string> atBounds;
        for (const FitEstimate& e : finding.final.parameters)
            if (e.atBound) atBounds.push_back(e.name);
        if (converged && !atBounds.empty())
            return {tr("Fitted, with %1 at a bound").arg(joined(atBounds)),
                    tr("Within the bounds the error cannot be made smaller; beyond them it could be."), false};
        return {converged ? tr("Parameters fitted") : tr("Fit did not converge"), message, converged};
    }
    if (finding.end.interrupted && finding.end.isAtLimitOfWork && finding.effects.empty())
        return {tr("Search ended at its limit of work"), tr("What it has found is shown; the rest was not tried."),
                false};
    if (finding.end.interrupted && !finding.end.isAtLimitOfWork)
        return {tr("Search stopped"), tr("What was found until then is shown; the rest was not tried."), false};
    const bool isOne = finding.effects.size() == 1;
    const QString found = finding.effects.empty() ? QString()
                          : isOne                 ? effectTitle(finding.effects.front())
                                                  : tr("%1 effects").arg(finding.effects.size());
    switch (finding.kind) {
        case FindingKind::Adequate:
            return {tr("The model is adequate"),
                    tr("What is left between model and measurement is noise. Nothing was added."), true};
        case FindingKind::Effect:
            return {found,
                    isOne ? tr("With it, refitted, what is left is noise.")
                          : tr("With them, refitted, what is left is noise."),
                    true};
        case FindingKind::Partial:
            return {found,
                    isOne ? tr("With it, refitted, some structure remains that no candidate explains.")
                          : tr("With them, refitted, some structure remains that no candidate explains."),
                    false};
        case FindingKind::Unexplained:
        case FindingKind::Interrupted:  // told above
            break;
    }
    if (!finding.end.notSearched.empty() && finding.unexplained.remainders.empty())
        return {tr("No effect was looked for"), inWords(finding.end.notSearched), false};
    if (!finding.end.notSearched.empty())
        return {tr("A recording is not what it says"), inWords(finding.end.notSearched), false};
    return {tr("Unexplained structure"), tr("The residual is not noise, and no effect of the library explains it."),
            false};
}

QString equivalentWords(const AddedEffect& effect) {
    QStringList equivalent;
    for (const Alternative& a : effect.instead.effects)
        if (a.equivalent) equivalent << ResultPanel::tr("%1 at %2").arg(text(a.kind), placeText(text(a.at)));
    QStringList words;
    if (!equivalent.isEmpty())
        words << ResultPanel::tr("This data cannot tell it from: %1.").arg(equivalent.join("; "));
    QStringList values;
    for (const Text& value : effect.instead.values) values << inWords(value);
    if (!values.isEmpty()) words << ResultPanel::tr("Another value would explain as much: %1.").arg(values.join("; "));
    return words.join(' ');
}

RemainderWords remainderWords(const Remainder& r, const std::function<QString(const std::string&)>& named) {
    RemainderWords words;
    words.heading = ResultPanel::tr("What remains on %1").arg(text(r.output));
    words.where = ResultPanel::tr("Between %1 and %2 s").arg(style::numberText(r.from, 4), style::numberText(r.to, 4));
    if (!r.experiment.empty()) words.where += ResultPanel::tr(" of %1").arg(named(r.experiment));
    if (!r.node.empty()) words.where += ResultPanel::tr(", acting at %1").arg(named(r.node));
    QStringList others;
    for (const std::string& node : r.proposal.equalNodes) others << named(node);
    if (!others.isEmpty()) words.where += ResultPanel::tr(", or as well at %1").arg(others.join(", "));
    words.where += ".";
    QStringList moves;
    for (const Correlate& c : r.movesWith)
        if (c.isWorthAWord())
            moves << QStringLiteral("%1 (%2)").arg(text(c.variable), style::numberText(c.correlation, 2));
    if (!moves.isEmpty()) words.movesWith = ResultPanel::tr("It moves with %1.").arg(moves.join(", "));
    if (r.proposal.equation.empty()) return words;
    words.proposal = ResultPanel::tr("Proposed, not added: %1").arg(inWords(r.proposal.equation));
    QStringList facts;
    if (!r.proposal.className.empty()) facts << ResultPanel::tr("Block %1").arg(text(r.proposal.className));
    if (r.proposal.errors.fit >= 0)
        facts << ResultPanel::tr("with it the error would be %1 on fitted data")
                     .arg(style::percentText(r.proposal.errors.fit));
    if (r.proposal.errors.validate >= 0)
        facts << ResultPanel::tr("%1 on validation data").arg(style::percentText(r.proposal.errors.validate));
    if (r.proposal.worsensValidation())
        facts
            << ResultPanel::tr("worse than the %1 without it").arg(style::percentText(r.proposal.errorValidateWithout));
    if (!facts.isEmpty()) words.proposalFacts = facts.join(", ") + ".";
    return words;
}

}  // namespace analogon::ui
