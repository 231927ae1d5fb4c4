#pragma once

#include <array>
#include <set>
#include <string>

namespace analogon {

/// A part of the page that may be left out. What was found and how large the error is stands on every page.
enum class ReportSection { Errors, Effects, Diagram, Unexplained, Plots, Parameters, Residuals, Tried, Remarks };
inline constexpr std::array reportSections{
    ReportSection::Errors,      ReportSection::Effects, ReportSection::Diagram,
    ReportSection::Unexplained, ReportSection::Plots,   ReportSection::Parameters,
    ReportSection::Residuals,   ReportSection::Tried,   ReportSection::Remarks};
const char* name(ReportSection section);  // as study.json calls it: "errors"

/// What a report says of itself, in the words of who signs it. Everything may be empty.
struct ReportHead {
    std::string title;       // in place of the study's name
    std::string testObject;  // what was on the test bench
    std::string author;
    std::string date;  // as it is to be read
    std::string logo;  // file, relative to the study's directory
    std::set<ReportSection> leftOut;

    bool shows(ReportSection section) const { return !leftOut.contains(section); }
    friend bool operator==(const ReportHead&, const ReportHead&) = default;
};

/// The facts and the logo, above the title; empty where there are none. `logoUri`: of the picture (core/report/logo).
std::string headHtml(const ReportHead& head, const std::string& study, const std::string& logoUri);

/// What the page must know of styles to show it; empty where it is.
std::string headStyle(const ReportHead& head);

}  // namespace analogon
