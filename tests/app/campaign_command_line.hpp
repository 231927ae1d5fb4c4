#pragma once

#include <map>

#include "tests/app/command_process.hpp"
#include "tests/core/campaign/campaign_folder.hpp"

namespace analogon::cli {

/// A campaign as its own process.
class CampaignCommandLine : public CampaignFolder {
protected:
    void SetUp() override {
        CampaignFolder::SetUp();
        campaign(R"({"unit": "serial", "files": {"step": "file"}, "attributes": ["supplier"]})");
    }
    void units(int count) {
        std::string table = "serial,file,supplier\n";
        for (int i = 0; i < count; ++i) {
            const std::string name = "U" + std::to_string(i);
            record(name + ".csv", 1 + 0.1 * i, 0.3 + 0.02 * i);
            table += name + "," + name + ".csv," + (i % 2 ? "A" : "B") + "\n";
        }
        write("units.csv", table);
    }
    std::vector<std::string> arguments(const std::string& out, int jobs = 2) const {
        return {"campaign", at("campaign.json").string(), "--out", at(out).string(), "--jobs", std::to_string(jobs)};
    }
    int run(const std::string& out, int jobs = 2) {
        Process process(arguments(out, jobs), folder_);
        const int status = process.wait();
        said_ = process.out() + process.err();
        return status;
    }
    /// When the record of each unit was written.
    std::map<std::string, fs::file_time_type> records(const std::string& out) const {
        std::map<std::string, fs::file_time_type> times;
        std::error_code code;
        for (fs::directory_iterator entry(at(out) / "units", code), end; !code && entry != end; entry.increment(code))
            if (fs::exists(entry->path() / "unit.json"))
                times[entry->path().filename()] = fs::last_write_time(entry->path() / "unit.json");
        return times;
    }

    std::string said_;
};

}  // namespace analogon::cli
