#include "ui/window/block_marks.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "ui/document/document.hpp"
#include "ui/style/number.hpp"
#include "ui/window/main_window.hpp"

namespace analogon::ui {

namespace {

constexpr int digits = 4;

QString html(const std::string& text) { return QString::fromStdString(text).toHtmlEscaped(); }

/// "R = 2.452 ± 0.012 Ohm": by the name within the block, before a fit with the value it starts from.
QString fittedText(const std::string& name, const std::string& unit, std::optional<double> value, double error) {
    if (!value) return html(name);
    QString text = html(name) + " = " + style::numberText(*value, digits);
    if (std::isfinite(error) && error > 0) text += QStringLiteral(" ± ") + style::numberText(error, 2);
    return unit.empty() || unit == "1" ? text : text + " " + html(unit);
}

/// What is fitted within one block.
struct Fitted {
    QStringList fitted, atBound;
};

class Fits {
public:
    explicit Fits(const Document& document) : document_(document), after_(document.after()) {
        for (const std::string& level : document.levels()) prefix_ += level + ".";
        for (const ParameterFact& fact : document.facts().parameters) facts_[fact.name] = &fact;
    }

    /// `recording`: of a start value that is estimated for it alone.
    void add(const std::string& parameter, const QString& recording = {}) {
        if (!parameter.starts_with(prefix_)) return;
        const std::size_t dot = parameter.find('.', prefix_.size());
        if (dot == std::string::npos) return;  // of the model itself
        const std::string block = parameter.substr(prefix_.size(), dot - prefix_.size());
        const std::string name = parameter.substr(dot + 1);
        if (!facts_.empty() && !facts_.contains(parameter)) return;
        const std::string unit = facts_.contains(parameter) ? facts_[parameter]->unit : std::string();
        const FitEstimate* const estimate = recording.isEmpty() ? find(parameter) : nullptr;
        const QString value =
            estimate ? fittedText(name, unit, estimate->value, estimate->atBound ? 0 : estimate->standardError)
                     : fittedText(name, unit, document_.parameterValue(parameter), 0);
        const QString text = recording.isEmpty()
                                 ? value
                                 : MainWindow::tr("%1 for the recording %2").arg(html(name), recording.toHtmlEscaped());
        (estimate && estimate->atBound ? found_[block].atBound : found_[block].fitted) << text;
    }
    const std::map<std::string, Fitted>& found() const { return found_; }
    bool isFitted() const { return after_ && !after_->parameters.empty(); }

private:
    const FitEstimate* find(const std::string& name) const {
        if (!after_) return nullptr;
        for (const FitEstimate& e : after_->parameters)
            if (e.name == name && e.experiment < 0) return &e;
        return nullptr;
    }

    const Document& document_;
    std::shared_ptr<const ModelState> after_;
    std::string prefix_;
    std::map<std::string, const ParameterFact*> facts_;
    std::map<std::string, Fitted> found_;
};

/// The first few, so that a tooltip stays one that is read.
QString listed(QStringList texts) {
    constexpr int most = 8;
    const auto more = texts.size() - most;
    if (more > 0) {
        texts = texts.mid(0, most);
        texts << MainWindow::tr("and %1 more").arg(more);
    }
    return texts.join("<br>");
}

QString effectTip(const Document& document, const Block& block) {
    if (const Finding* finding = document.finding())
        for (const AddedEffect& effect : finding->effects)
            if (effect.wired.instance == block.name)
                return (effect.wired.way == Way::Specialise ? MainWindow::tr("Changed by the effect %1")
                                                            : MainWindow::tr("Brought by the effect %1"))
                    .arg(html(effect.kind));
    return MainWindow::tr("An effect: %1").arg(html(block.className).section('.', -1));
}

}  // namespace

std::vector<BlockMark> blockMarks(const Document& document) {
    std::vector<BlockMark> marks;
    if (!document.isOpen()) return marks;
    Fits fits(document);
    for (const auto& [name, setting] : document.study().parameters)
        if (setting.fit) fits.add(name);
    const auto& experiments = document.study().experiments;
    for (const StudyExperiment& experiment : experiments)
        for (const auto& [name, start] : experiment.initial)
            if (experiment.isUsed && std::holds_alternative<FittedStart>(start))
                fits.add(name, QString::fromStdString(experiment.name));
    for (const Block& block : document.diagram().blocks) {
        if (block.isEffect) marks.push_back({block.name, MarkKind::Effect, effectTip(document, block)});
        const auto own = fits.found().find(block.name);
        if (own == fits.found().end()) continue;
        const auto& [fitted, atBound] = own->second;
        QStringList lines;
        if (!atBound.isEmpty()) lines << MainWindow::tr("At a bound after the fit:") + "<br>" + listed(atBound);
        if (!fitted.isEmpty())
            lines << (fits.isFitted() ? MainWindow::tr("Fitted:") : MainWindow::tr("To be fitted:")) + "<br>" +
                         listed(fitted);
        marks.push_back({block.name, atBound.isEmpty() ? MarkKind::Fitted : MarkKind::AtBound, lines.join("<br>")});
    }
    return marks;
}

}  // namespace analogon::ui
