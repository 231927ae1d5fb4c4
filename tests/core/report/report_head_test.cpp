#include "core/report/report_head.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/report/report.hpp"
#include "sample_finding.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

ReportContext context() { return {"study", "discover", "1"}; }

TEST(ReportHead, IsOfNoByteWhereNothingIsTold) {
    EXPECT_EQ(headHtml({}, "study", {}), "");
    EXPECT_EQ(headStyle({}), "");
    const std::string page = reportHtml(analogon::test::sampleFinding(), context());
    for (const char* part : {"class=\"head\"", ".head ", "class=\"logo\"", "class=\"diagrams\"", ".diagram"})
        EXPECT_THAT(page, Not(HasSubstr(part)));
}

TEST(ReportHead, TellsTitleTestObjectAuthorDateAndLogo) {
    ReportContext told = context();
    told.head = {"Pump <A>", "Sample \"7\" & 8", "E. Noether", "12 March 2026", "logo.svg", {}};
    told.logoUri = "data:image/svg+xml;base64,PHN2Zy8+";
    const std::string page = reportHtml(analogon::test::sampleFinding(), told);
    EXPECT_THAT(page, HasSubstr("<title>Pump &lt;A&gt; – Analogon</title>"));
    EXPECT_THAT(page, HasSubstr("<h1>Pump &lt;A&gt;</h1>"));
    EXPECT_THAT(page, HasSubstr("<dt>Test object</dt><dd>Sample &quot;7&quot; &amp; 8</dd>"));
    EXPECT_THAT(page, HasSubstr("<dt>Study</dt><dd>study</dd>"));
    EXPECT_THAT(page, HasSubstr("<dt>Author</dt><dd>E. Noether</dd>"));
    EXPECT_THAT(page, HasSubstr("<dt>Date</dt><dd>12 March 2026</dd>"));
    EXPECT_THAT(page, HasSubstr("alt=\"Logo\" src=\"data:image/svg+xml;base64,PHN2Zy8+\""));
}

TEST(ReportHead, WithoutATitleLeavesTheStudysNameAndSaysItOnce) {
    ReportContext told = context();
    told.head.author = "E. Noether";
    const std::string page = reportHtml(analogon::test::sampleFinding(), told);
    EXPECT_THAT(page, HasSubstr("<h1>study</h1>"));
    EXPECT_THAT(page, Not(HasSubstr("<dt>Study</dt>")));
    EXPECT_THAT(page, Not(HasSubstr("<img")));
}

TEST(ReportHead, LeavesOutEachSectionThatIsNotWanted) {
    const Finding finding = analogon::test::sampleFinding();
    const std::string all = reportHtml(finding, context());
    const std::pair<ReportSection, const char*> heads[] = {
        {ReportSection::Errors, "How well the model follows"}, {ReportSection::Effects, "that was missing</h2>"},
        {ReportSection::Plots, "Measured and simulated</h2>"}, {ReportSection::Parameters, "<h2>Parameters"},
        {ReportSection::Residuals, "<h2>What is left"},        {ReportSection::Tried, "<h2>What was tried"}};
    for (const auto& [section, head] : heads) {
        ReportContext less = context();
        less.head.leftOut = {section};
        const std::string page = reportHtml(finding, less);
        EXPECT_THAT(all, HasSubstr(head));
        EXPECT_THAT(page, Not(HasSubstr(head)));
        for (const auto& [other, kept] : heads)
            EXPECT_EQ(page.find(kept) == std::string::npos, other == section) << name(section) << ", " << kept;
        EXPECT_THAT(page, HasSubstr("class=\"summary\""));
    }
}

TEST(ReportHead, LeavesOutTheDiagramsAsAnyOtherSection) {
    ReportContext told = context();
    told.diagrams = DiagramPair{};
    EXPECT_THAT(reportHtml(analogon::test::sampleFinding(), told), HasSubstr("The model before and after"));
    told.head.leftOut = {ReportSection::Diagram};
    EXPECT_EQ(reportHtml(analogon::test::sampleFinding(), told),
              reportHtml(analogon::test::sampleFinding(), context()));
}

}  // namespace
}  // namespace analogon
