/// A campaign that is started on a cluster from its window: against programs that act as Slurm's, and against a real
/// one where tests/slurm/start.sh has started it (ANALOGON_SLURM).
#include <QCheckBox>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>

#include "tests/ui/campaign_fixture.hpp"
#include "ui/style/translator.hpp"

namespace analogon::ui {
namespace {

class CampaignOnACluster : public CampaignInTheWindow {
protected:
    /// Chooses the cluster and starts, by the mouse.
    static void start(CampaignWindow& campaign, const QString& options = {}) {
        if (!campaign.clusterBox()->isChecked()) {
            const QPoint box(8, campaign.clusterBox()->height() / 2);
            QTest::mouseClick(campaign.clusterBox(), Qt::LeftButton, Qt::NoModifier, box);
        }
        ASSERT_TRUE(campaign.clusterBox()->isChecked() && campaign.clusterOptionsField()->isEnabled());
        EXPECT_FALSE(campaign.jobsField()->isEnabled()) << "how many at once is for the cluster to say";
        if (!options.isEmpty()) QTest::keyClicks(campaign.clusterOptionsField(), options);
        QTest::mouseClick(campaign.startButton(), Qt::LeftButton);
        ASSERT_TRUE(campaign.process().isRunning());
    }
    static bool waitUntilTold(CampaignWindow& campaign, const QString& words) {
        return QTest::qWaitFor([&] { return campaign.told()->text().contains(words); }, 20000);
    }
    void openStudyOf(CampaignWindow& campaign, const QString& unit) {
        campaign.chooseUnit(unit);
        QTest::mouseClick(campaign.openStudyButton(), Qt::LeftButton);
        ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen() && document().before(); }, 20000));
        EXPECT_EQ(document().title(), unit);
    }
};

/// Slurm's programs are those of tests/slurm/pretended; tests/app/campaign_slurm_test.cpp says what they can be told.
class CampaignOnAPretendedCluster : public CampaignOnACluster {
protected:
    void SetUp() override {
        CampaignOnACluster::SetUp();
        std::filesystem::copy(ANALOGON_ROOT "/tests/slurm/pretended", at("bin"));
        qputenv("PATH", (at("bin").string() + ":/usr/bin:/bin").c_str());
        write("bin/array", "1001");
    }
    void TearDown() override {
        write("bin/cancelled", "");  // tasks that are still to come
        qputenv("PATH", path_);
        CampaignOnACluster::TearDown();
    }

private:
    const QByteArray path_ = qgetenv("PATH");
};

TEST_F(CampaignOnAPretendedCluster, TellsWhatSlurmDoesWithItWhileItIsWatched) {
    units(3);
    write("bin/delay", "0.5");
    write("bin/held", "PENDING|PartitionDown");
    CampaignWindow& campaign = openCampaign();
    start(campaign);
    EXPECT_TRUE(waitUntilTold(campaign, "Slurm job 100: 3 units in 3 tasks")) << campaign.told()->text().toStdString();
    EXPECT_TRUE(waitUntilTold(campaign, "Slurm job 100 waits: PartitionDown")) << campaign.told()->text().toStdString();
    ASSERT_TRUE(waitUntilEnded(campaign, 3)) << campaign.told()->text().toStdString();
    EXPECT_FALSE(isTold(campaign)) << "what was told of the way there is over";
    EXPECT_EQ(rowsIn(campaign, "failed"), 1);
}

TEST_F(CampaignOnAPretendedCluster, WorksOnWhereItIsStoppedAndIsFollowedAgain) {
    units(5);
    write("bin/delay", "0.7");
    CampaignWindow& campaign = openCampaign();
    start(campaign);
    ASSERT_TRUE(QTest::qWaitFor([&] { return campaign.bar()->value() > 1; }, 30000));
    QTest::mouseClick(campaign.startButton(), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !campaign.process().isRunning(); }, 10000));
    EXPECT_EQ(campaign.told()->text(), "Slurm job 100 works on; \"scancel 100\" ends it. Start goes on where it was.");
    start(campaign);
    EXPECT_TRUE(waitUntilTold(campaign, "Slurm job 100 of an earlier run is followed"));
    ASSERT_TRUE(waitUntilEnded(campaign, 5)) << campaign.told()->text().toStdString();
}

TEST_F(CampaignOnAPretendedCluster, IsToldInTheLanguageOfTheWindow) {
    units(2);
    write("bin/delay", "0.5");
    Translator german;
    ASSERT_TRUE(german.loadLanguage("de"));
    QCoreApplication::installTranslator(&german);
    CampaignWindow& campaign = openCampaign();
    start(campaign);
    EXPECT_TRUE(waitUntilTold(campaign, "Slurm-Job 100: 2 Exemplare in 2 Aufgaben"))
        << campaign.told()->text().toStdString();
    EXPECT_TRUE(waitUntilEnded(campaign, 2));
    campaign.close();
    QTest::qWait(1);
    QCoreApplication::removeTranslator(&german);
}

TEST_F(CampaignOnAPretendedCluster, ThatIsNotThereSaysSo) {
    units(1);
    CampaignWindow& campaign = openCampaign();
    std::filesystem::remove(at("bin/sbatch"));
    qputenv("PATH", at("bin").string().c_str());
    start(campaign);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !campaign.process().isRunning(); }, 10000));
    EXPECT_TRUE(waitUntilTold(campaign, "sbatch")) << campaign.told()->text().toStdString();
}

/// Slurm of one controller and two nodes on this machine.
TEST_F(CampaignOnACluster, OfSlurmIsWatchedToItsEndAndTheStudyOfAUnitOpenedFromItsRow) {
    if (!qEnvironmentVariableIsSet("ANALOGON_SLURM"))
        GTEST_SKIP() << "no Slurm here: tests/slurm/start.sh starts one and this test with it";
    units(8);
    CampaignWindow& campaign = openCampaign();
    start(campaign, "--time=10 --nice=1");
    EXPECT_TRUE(waitUntilTold(campaign, "8 units in 8 tasks")) << campaign.told()->text().toStdString();
    EXPECT_TRUE(QTest::qWaitFor([&] { return rowsIn(campaign, "done") > 0; }, 60000));
    EXPECT_TRUE(campaign.process().isRunning()) << "rows are seen to end one after the other";
    ASSERT_TRUE(waitUntilEnded(campaign, 8)) << campaign.told()->text().toStdString();
    EXPECT_EQ(rowsIn(campaign, "failed"), 1);
    EXPECT_TRUE(campaign.pageButton()->isEnabled());
    openStudyOf(campaign, "U6");
    ASSERT_TRUE(document().parameterValue("k"));
    EXPECT_NEAR(*document().parameterValue("k"), 7, 0.01);
}

}  // namespace
}  // namespace analogon::ui
