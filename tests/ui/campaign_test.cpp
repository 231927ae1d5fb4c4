#include <QAction>
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QSpinBox>
#include <QTableView>

#include "tests/ui/campaign_fixture.hpp"
#include "ui/style/style.hpp"
#include "ui/style/translator.hpp"

namespace analogon::ui {
namespace {

TEST_F(CampaignInTheWindow, IsStartedWatchedAndTheStudyOfAUnitOpenedFromItsRow) {
    units(3);
    CampaignWindow& campaign = openCampaign();
    EXPECT_EQ(campaign.outField()->text(), path("results"));
    EXPECT_EQ(rowsIn(campaign, "waiting"), 4);
    EXPECT_FALSE(campaign.pageButton()->isEnabled());
    QTest::mouseClick(campaign.startButton(), Qt::LeftButton);
    EXPECT_TRUE(campaign.process().isRunning());
    EXPECT_EQ(campaign.startButton()->text(), "Stop");
    EXPECT_FALSE(campaign.outField()->isEnabled());
    ASSERT_TRUE(waitUntilEnded(campaign, 3)) << campaign.told()->text().toStdString();
    EXPECT_EQ(rowsIn(campaign, "failed"), 1);
    EXPECT_TRUE(cell(campaign, 3, campaign.model()->faultColumn()).contains("missing.csv"));
    EXPECT_LT(cell(campaign, 1, UnitsModel::ErrorAfter).toDouble(), 1);
    EXPECT_EQ(cell(campaign, 1, UnitsModel::FirstAttribute), "B");
    EXPECT_EQ(campaign.bar()->value(), 4);
    EXPECT_TRUE(campaign.pageButton()->isEnabled());
    EXPECT_TRUE(QFileInfo::exists(path("results/results.csv")));

    campaign.chooseUnit("U2");
    EXPECT_TRUE(campaign.openReportButton()->isEnabled());
    QTest::mouseClick(campaign.openStudyButton(), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen() && document().before(); }, 20000));
    EXPECT_EQ(document().title(), "U2");
    ASSERT_TRUE(document().parameterValue("k"));
    EXPECT_NEAR(*document().parameterValue("k"), 3, 0.01) << "it begins where the run of the unit ended";
    EXPECT_TRUE(document().path().isEmpty()) << "nothing in the directory of results is overwritten";
}

TEST_F(CampaignInTheWindow, IsStoppedAndGoesOnWhereItWas) {
    units(60);
    CampaignWindow& campaign = openCampaign();
    campaign.jobsField()->setValue(1);
    campaign.startButton()->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return campaign.bar()->value() > 4; }, 30000));
    campaign.startButton()->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !campaign.process().isRunning(); }, 30000));
    EXPECT_TRUE(campaign.told()->text().contains("stopped")) << campaign.told()->text().toStdString();
    ASSERT_TRUE(QTest::qWaitFor([&] { return rowsIn(campaign, "done") > 2; }, 10000));
    EXPECT_LT(rowsIn(campaign, "done"), 60);
    campaign.startButton()->click();
    ASSERT_TRUE(waitUntilEnded(campaign, 60));
    EXPECT_FALSE(isTold(campaign));
}

TEST_F(CampaignInTheWindow, ThatIsFaultySaysWhyAndCannotBeStarted) {
    units(1);
    campaign(R"({"unit": "serial", "files": {"stop": "file"}})");
    CampaignWindow& campaign = openCampaign();
    EXPECT_TRUE(campaign.told()->text().contains("\"stop\"")) << campaign.told()->text().toStdString();
    EXPECT_TRUE(campaign.told()->text().contains("Did you mean \"step\"?"));
    EXPECT_FALSE(campaign.startButton()->isEnabled());
    campaign.fileField()->setFocus();
    campaign.outField()->setFocus();
    EXPECT_TRUE(isTold(campaign)) << "it is not read again because its field is left";
}

TEST_F(CampaignInTheWindow, FitsASmallScreenInBothThemesAndLanguages) {
    units(12);
    QDir().mkpath(ANALOGON_PICTURES);
    auto& application = *qobject_cast<QApplication*>(QApplication::instance());
    for (const bool isGerman : {false, true}) {
        Translator german;
        if (isGerman && german.loadLanguage("de")) QCoreApplication::installTranslator(&german);
        CampaignWindow& campaign = openCampaign();
        if (!isGerman) campaign.startButton()->click();
        ASSERT_TRUE(waitUntilEnded(campaign, 12)) << campaign.told()->text().toStdString();
        campaign.resize(1000, 560);
        campaign.chooseUnit("U3");
        for (const bool isDark : {false, true}) {
            style::apply(application, isDark ? style::Theme::Dark : style::Theme::Light);
            QTest::qWait(1);
            EXPECT_LE(campaign.minimumSizeHint().width(), 1000);
            EXPECT_TRUE(campaign.grab().save(QStringLiteral(ANALOGON_PICTURES "/campaign%1%2.png")
                                                 .arg(isGerman ? "-de" : "", isDark ? "-dark" : "")));
        }
        style::apply(application, style::Theme::Light);
        campaign.close();
        QTest::qWait(1);
        QCoreApplication::removeTranslator(&german);
    }
}

TEST_F(CampaignInTheWindow, IsFoundFromTheDirectoryOfItsResults) {
    units(2);
    {
        CampaignWindow& campaign = openCampaign();
        campaign.startButton()->click();
        ASSERT_TRUE(waitUntilEnded(campaign, 2));
        campaign.close();
        QTest::qWait(1);
    }
    CampaignWindow& again = openCampaign("results/campaign.json");
    EXPECT_EQ(again.fileField()->text(), path("campaign.json"));
    EXPECT_EQ(again.outField()->text(), path("results"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return rowsIn(again, "done") == 2; }, 10000));
}

TEST_F(CampaignInTheWindow, ShowsTheDirectoryThatWasNamedLast) {
    units(2);
    CampaignWindow& campaign = openCampaign();
    campaign.startButton()->click();
    ASSERT_TRUE(waitUntilEnded(campaign, 2));
    for (const char* place : {"nowhere", "results"}) {  // the second while the first is looked at
        campaign.outField()->setText(path(place));
        Q_EMIT campaign.outField()->editingFinished();
    }
    QTest::qWait(500);
    EXPECT_EQ(rowsIn(campaign, "done"), 2);
}

TEST_F(CampaignInTheWindow, IsNotStartedByEnterInAField) {
    units(1);
    CampaignWindow& campaign = openCampaign();
    for (QLineEdit* field : {campaign.filterField(), campaign.outField(), campaign.fileField()}) {
        field->setFocus();
        QTest::keyClick(field, Qt::Key_Return);
        EXPECT_FALSE(campaign.process().isRunning()) << field->accessibleName().toStdString();
    }
}

TEST_F(CampaignInTheWindow, AtWorkAsksBeforeItsWindowIsClosed) {
    units(60);
    CampaignWindow& campaign = openCampaign();
    campaign.jobsField()->setValue(1);
    campaign.startButton()->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return campaign.bar()->value() > 0; }, 30000));
    campaign.close();
    auto* box = campaign.findChild<QMessageBox*>();
    ASSERT_TRUE(box);
    EXPECT_TRUE(campaign.isVisible());
    box->button(QMessageBox::Cancel)->click();
    EXPECT_TRUE(campaign.isVisible() && campaign.process().isRunning());
    campaign.startButton()->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !campaign.process().isRunning(); }, 30000));
    campaign.close();
    EXPECT_FALSE(campaign.isVisible());
}

TEST_F(CampaignInTheWindow, WithoutItsProgramSaysWhatIsMissing) {
    units(1);
    CampaignWindow& campaign = openCampaign();
    campaign.process().setProgram(path("nothing-there"));
    campaign.startButton()->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return isTold(campaign); }, 10000));
    EXPECT_EQ(campaign.startButton()->text(), "Start");
    EXPECT_TRUE(campaign.startButton()->isEnabled());
}

TEST(CampaignOrders, AreTheArgumentsOfTheCommandLine) {
    EXPECT_EQ(CampaignProcess::arguments({"c.json", "out", 4, true}),
              (QStringList{"campaign", "c.json", "--out", "out", "--progress", "json", "--jobs", "4", "--retry"}));
    EXPECT_EQ(CampaignProcess::arguments({"c.json", "out", 4, false, true, "--time=60"}),
              (QStringList{"campaign", "c.json", "--out", "out", "--progress", "json", "--slurm=--time=60"}));
}

TEST(UnitsModel, SortsFiguresByTheirSizeAndFiltersByName) {
    auto campaign = std::make_shared<Campaign>();
    auto look = std::make_shared<CampaignLook>();
    for (int i = 0; i < 10000; ++i) {
        CampaignUnit unit;
        unit.name = "unit " + std::to_string(i);
        UnitRecord record;
        record.errorBefore = i;
        record.errorAfter = 10000 - i;
        look->units[unit.name] = {UnitState::Done, record, {}, {}};
        campaign->units.push_back(std::move(unit));
    }
    UnitsModel model;
    model.setCampaign(campaign);
    model.setLook(look);
    QSortFilterProxyModel sorted;
    sorted.setSourceModel(&model);
    sorted.setSortRole(UnitsModel::SortRole);
    sorted.setFilterKeyColumn(-1);
    sorted.sort(UnitsModel::ErrorAfter);
    EXPECT_EQ(sorted.index(0, UnitsModel::Unit).data().toString(), "unit 9999");
    sorted.setFilterFixedString("unit 999");
    EXPECT_EQ(sorted.rowCount(), 11);
}

}  // namespace
}  // namespace analogon::ui
