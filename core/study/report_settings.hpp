#pragma once

#include <string>

#include "core/report/diagram_svg.hpp"
#include "core/report/report_head.hpp"
#include "core/study/run.hpp"

/// The member "report" of study.json: what its reports say of themselves (contract, section 4).
namespace analogon {

/// As Study::extraJson keeps it. What is of another type than it should be is not there.
ReportHead reportHeadOf(const std::string& extraJson);

/// The further members of a study with another head; all else of them stays, members of "report" that are not known
/// as well.
std::string withReportHead(const std::string& extraJson, const ReportHead& head);

/// What of it cannot be used, as warnings with their places in study.json: the report goes without it.
Diagnostics reportHeadFaults(const Study& study);

/// The diagrams of a run that added effects, read from its texts; nothing where there is none, or a text is not kept.
std::optional<DiagramPair> diagramsOf(const RunResult& result);

}  // namespace analogon
