#pragma once

#include <map>
#include <string>

#include "core/archive/archive.hpp"
#include "core/base/unit.hpp"
#include "core/campaign/campaign.hpp"

namespace analogon {

/// The study of a campaign, from which that of each unit is made.
class CampaignTemplate {
public:
    /// Reads and examines the study as `check` does. Faults: those of the study, experiments and parameters of the
    /// campaign that it lacks, units that do not fit those of the model.
    static Outcome<CampaignTemplate> open(const Campaign& campaign);

    /// The study with the unit's recordings in place of the template's and what is known of it held at its value (an
    /// own value of the unit is not fitted, whatever the template says). Faults name row and recording.
    Outcome<Study> studyOf(const Campaign& campaign, const CampaignUnit& unit) const;

    /// Tells the study, its models, and the recordings that units do not replace from changed ones.
    const std::string& fingerprint() const { return fingerprint_; }
    const Study& study() const { return opened_.study; }

private:
    OpenedStudy opened_;
    std::map<std::string, UnitConversion> conversions_;  // of known values
    std::string fingerprint_;
};

/// Where a recording of a unit lies.
std::filesystem::path recordingOf(const Campaign& campaign, const std::string& path);

/// Tells a unit and its recordings (by path, size and time of the last change) from changed ones. Faults: a recording
/// that is no file.
Outcome<std::string> fingerprintOf(const Campaign& campaign, const CampaignTemplate& study, const CampaignUnit& unit);

}  // namespace analogon
