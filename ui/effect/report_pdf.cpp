#include "ui/effect/report_pdf.hpp"

#include <QBuffer>
#include <QFile>
#include <QPageSize>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>
#include <cmath>

#include "core/base/number_text.hpp"
#include "core/base/whole_file.hpp"
#include "core/report/words.hpp"
#include "ui/effect/finding_words.hpp"
#include "ui/effect/report_diagrams.hpp"
#include "ui/effect/report_top.hpp"
#include "ui/effect/result_panel.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

QString text(const std::string& s) { return QString::fromStdString(s).toHtmlEscaped(); }
QString tr(const char* s) { return ResultPanel::tr(s); }
QString number(double v, int digits = 4) { return style::numberText(v, digits); }

/// What a candidate came to, and below it why it was not taken.
QString verdictCell(const CandidateResult& candidate) {
    const QString verdict = verdictText(candidate.verdict).toHtmlEscaped();
    if (candidate.verdict == Verdict::Chosen || candidate.reason.empty()) return verdict;
    return verdict + "<br><span style='font-size: 7.5pt; color: #555'>" + inWords(candidate.reason).toHtmlEscaped() +
           "</span>";
}

/// A table of cells; all but the first column are set to the right.
class HtmlTable {
public:
    explicit HtmlTable(const QStringList& header) {
        html_ = "<table width='100%' cellspacing='0' cellpadding='3'><tr>";
        for (int i = 0; i < header.size(); ++i) html_ += cell(header[i].toHtmlEscaped(), i, "th");
        html_ += "</tr>";
    }
    void add(const QStringList& cells) {
        html_ += "<tr>";
        for (int i = 0; i < cells.size(); ++i) html_ += cell(cells[i], i, "td");
        html_ += "</tr>";
    }
    QString html() const { return html_ + "</table>"; }

private:
    static QString cell(const QString& content, int column, const char* tag) {
        return QStringLiteral("<%1 align='%2' style='border-bottom: 1px solid #ccc'>%3</%1>")
            .arg(tag, column == 0 ? "left" : "right", content);
    }
    QString html_;
};

QString verdictPart(const Finding& finding, RunKind kind) {
    const FindingWords verdict = findingWords(finding, kind);
    QString html = "<h2>" + verdict.title.toHtmlEscaped() + "</h2><p>";
    if (finding.effects.size() > 1)
        for (const AddedEffect& e : finding.effects) html += effectTitle(e).toHtmlEscaped() + "<br>";
    html += verdict.sentence.toHtmlEscaped() + "</p>";
    return html;
}

QString errorsPart(const Finding& finding) {
    HtmlTable errors({tr("Error"), tr("Role"), tr("Before"), tr("After")});
    for (const ExperimentState& after : finding.final.experiments) {
        double was = std::nan("");
        for (const ExperimentState& b : finding.baseline.experiments)
            if (b.name == after.name) was = b.errorPercent;
        errors.add({text(after.name), after.role == Role::Fit ? tr("fit") : tr("validate"), number(was, 3) + " %",
                    number(after.errorPercent, 3) + " %"});
    }
    return errors.html();
}

QString cautionsPart(const Finding& finding) {
    if (finding.warnings.empty()) return {};
    QString html = "<h2>" + tr("Caution") + "</h2><ul>";
    for (const Text& warning : finding.warnings) html += "<li>" + inWords(warning).toHtmlEscaped() + "</li>";
    return html + "</ul>";
}

QString parametersPart(const Finding& finding) {
    HtmlTable parameters({tr("Parameter"), tr("Value"), tr("Unit")});
    for (const auto& [e, experiment] : estimatesOf(finding.final))
        parameters.add({text(experiment.empty() ? e->name : e->name + " (" + experiment + ")"),
                        style::withDecimalSign(valueText(e->value, e->standardError)), text(e->unit)});
    return "<h2>" + tr("Parameters") + "</h2>" + parameters.html();
}

QString effectsPart(const Finding& finding) {
    QString html;
    for (const AddedEffect& e : finding.effects) {
        html += "<h2>" + effectTitle(e).toHtmlEscaped() + "</h2>";
        HtmlTable evidence({text(e.kind), QString()});
        for (const EffectValue& p : e.parameters)
            evidence.add(
                {text(p.name), style::withDecimalSign(valueText(p.value, p.standardError)) + " " + text(p.unit)});
        evidence.add({tr("Confidence"), inWords(confidenceWords(e))});
        evidence.add({tr("Score"), number(e.evidence.score)});
        evidence.add({tr("ΔBIC"), number(e.evidence.deltaBic)});
        evidence.add({tr("Held out"), number(e.evidence.heldOut, 2)});
        html += evidence.html();
        html += "<p>" + equivalentWords(e).toHtmlEscaped() + "</p>";
    }
    return html;
}

QString unexplainedPart(const Finding& finding) {
    QString html;
    for (const Remainder& r : finding.unexplained.remainders) {
        const RemainderWords words =
            remainderWords(r, [](const std::string& name) { return placeOf(QString::fromStdString(name)); });
        html += "<h2>" + words.heading.toHtmlEscaped() + "</h2>";
        for (const QString& sentence : {words.where, words.movesWith, words.proposal, words.proposalFacts})
            if (!sentence.isEmpty()) html += "<p>" + sentence.toHtmlEscaped() + "</p>";
    }
    if (finding.unexplained.disturbance)
        html += "<p>" + inWords(disturbanceWords(*finding.unexplained.disturbance)).toHtmlEscaped() + "</p>";
    if (!finding.nextExperiment.empty())
        html += "<h2>" + tr("Next experiment") + "</h2><p>" + inWords(finding.nextExperiment).toHtmlEscaped() + "</p>";
    return html;
}

QString triedPart(const Finding& finding) {
    if (finding.candidates.empty()) return {};
    HtmlTable tried({tr("Effect"), tr("At"), tr("Screening"), tr("ΔBIC"), tr("Verdict")});
    for (const CandidateResult& c : finding.candidates)
        tried.add({text(c.kind), placeText(text(c.at), text(c.channel)), number(c.screening.score, 3),
                   c.deltaBic ? number(*c.deltaBic, 3) : QString(), verdictCell(c)});
    return "<h2>" + tr("What was tried") + "</h2>" + tried.html();
}

}  // namespace

QString reportBody(const QString& title, RunKind kind, const Finding& finding, const ReportPictures& pictures,
                   const ReportHead& head) {
    QString html = reportTop(title, head, !pictures.logo.isNull()) + verdictPart(finding, kind);
    if (head.shows(ReportSection::Errors)) html += errorsPart(finding);
    if (head.shows(ReportSection::Remarks)) html += cautionsPart(finding);
    if (pictures.diagrams && head.shows(ReportSection::Diagram)) html += diagramsOnPaper(*pictures.diagrams);
    for (std::size_t i = 0; i < pictures.plots.size() && head.shows(ReportSection::Plots); ++i)
        html += QStringLiteral("<p><img src='picture:%1' width='640'></p>").arg(i);
    if (head.shows(ReportSection::Parameters)) html += parametersPart(finding);
    if (head.shows(ReportSection::Effects)) html += effectsPart(finding);
    if (head.shows(ReportSection::Unexplained)) html += unexplainedPart(finding);
    if (head.shows(ReportSection::Tried)) html += triedPart(finding);
    return html;
}

QString writeReportPdf(const QString& file, const QString& title, RunKind kind, const Finding& finding,
                       const ReportPictures& pictures, const ReportHead& head) {
    QBuffer bytes;
    bytes.open(QIODevice::WriteOnly);
    QPdfWriter writer(&bytes);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(18, 18, 18, 18), QPageLayout::Millimeter);
    writer.setTitle(head.title.empty() ? title : QString::fromStdString(head.title));
    writer.setResolution(96);
    QTextDocument document;
    for (std::size_t i = 0; i < pictures.plots.size(); ++i)
        document.addResource(QTextDocument::ImageResource, QUrl(QStringLiteral("picture:%1").arg(i)),
                             pictures.plots[i]);
    document.setDefaultStyleSheet(
        "h1 {font-size: 18pt} h2 {font-size: 12pt} body, td, th {font-size: 9pt; color: black}");
    document.addResource(QTextDocument::ImageResource, QUrl(logoResource), pictures.logo);
    if (pictures.diagrams && head.shows(ReportSection::Diagram)) addDiagrams(document, *pictures.diagrams);
    document.setHtml("<body>" + reportBody(title, kind, finding, pictures, head) + "</body>");
    document.setPageSize(QSizeF(writer.width(), writer.height()));
    document.print(&writer);
    if (!bytes.data().startsWith("%PDF")) return ResultPanel::tr("%1 cannot be written.").arg(file);
    const Outcome<Done> written = writeWhole(QFile::encodeName(file).toStdString(), bytes.data().toStdString());
    return written ? QString() : file + ": " + inWords(written.diagnostics().front().message);
}

}  // namespace analogon::ui
