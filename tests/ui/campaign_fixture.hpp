#pragma once

#include <QLabel>
#include <QTableView>
#include <cmath>

#include "tests/core/campaign/campaign_folder.hpp"
#include "tests/ui/panels_fixture.hpp"
#include "ui/campaign/campaign_window.hpp"
#include "ui/campaign/units_model.hpp"

namespace analogon::ui {

/// Units of a small study that differ in its gain k.
class CampaignInTheWindow : public Panels, protected CampaignFiles {
protected:
    void SetUp() override {
        Panels::SetUp();
        writeStudy(directory.path().toStdString());
        campaign(R"({"unit": "serial", "files": {"step": "file"}, "attributes": ["supplier"]})");
    }
    QString path(const std::string& name) const { return QString::fromStdString(at(name).string()); }
    /// So many with a recording, and one whose recording is not there.
    void units(int count) const {
        std::string table = "serial,file,supplier\n";
        for (int i = 0; i < count; ++i) {
            const std::string name = "U" + std::to_string(i);
            record(name + ".csv", 1 + i, 0.4);
            table += name + "," + name + ".csv," + (i % 2 ? "B" : "A") + "\n";
        }
        write("units.csv", table + "broken,missing.csv,A\n");
    }
    CampaignWindow& openCampaign(const std::string& file = "campaign.json") {
        window.open(path(file));
        auto* campaign = window.findChild<CampaignWindow*>();
        EXPECT_TRUE(campaign && campaign->isVisible());
        campaign->process().setProgram(ANALOGON_CLI);
        EXPECT_TRUE(QTest::qWaitFor([&] { return campaign->model()->rowCount() > 0 || isTold(*campaign); }, 10000));
        return *campaign;
    }
    static bool isTold(const CampaignWindow& campaign) {
        return !campaign.told()->isHidden() && campaign.told()->text() != CampaignWindow::tr("Reading …");
    }
    static bool waitUntilEnded(CampaignWindow& campaign, int rowsDone) {
        return QTest::qWaitFor(
            [&] { return !campaign.process().isRunning() && rowsIn(campaign, UnitsModel::tr("done")) == rowsDone; },
            60000);
    }
    static QString cell(const CampaignWindow& campaign, int row, int column) {
        return campaign.model()->index(row, column).data().toString();
    }
    static int rowsIn(const CampaignWindow& campaign, const QString& state) {
        int count = 0;
        for (int row = 0; row < campaign.model()->rowCount(); ++row)
            count += cell(campaign, row, UnitsModel::State) == state;
        return count;
    }
};

}  // namespace analogon::ui
