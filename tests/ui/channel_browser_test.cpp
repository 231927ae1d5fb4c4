#include "ui/measurement/channel_browser.hpp"

#include <gtest/gtest.h>

#include <QDir>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>
#include <cmath>

#include "ui/measurement/channel_sketch.hpp"

namespace analogon::ui {
namespace {

/// A ramp over a time, whatever is asked for; it counts what is read.
class Ramp final : public RecordingReader {
public:
    Outcome<std::vector<ChannelValues>> read(std::size_t, std::span<const std::size_t> channels,
                                             const Progress&) const override {
        std::vector<ChannelValues> values;
        for (const std::size_t channel : channels) {
            std::vector<double> numbers(1000);
            for (std::size_t i = 0; i < numbers.size(); ++i)
                numbers[i] = channel == 0 ? 0.01 * static_cast<double>(i) : std::sin(0.02 * static_cast<double>(i));
            values.push_back({std::move(numbers), {}});
        }
        return values;
    }
};

std::shared_ptr<const MeasurementFile> fileOf(std::size_t groups, std::size_t channels) {
    auto file = std::make_shared<MeasurementFile>();
    for (std::size_t g = 0; g < groups; ++g) {
        RecordedGroup group;
        group.name = "raster " + std::to_string(g);
        group.master = MasterKind::Time;
        group.masterChannel = 0;
        group.samples = 1000;
        group.channels.push_back({"t", "s", "", ""});
        for (std::size_t c = 0; c < channels; ++c)
            group.channels.push_back({"signal_" + std::to_string(g) + "_" + std::to_string(c),
                                      c % 2 == 0 ? "V" : "degC", c == 3 ? "coolant behind the pump" : "", ""});
        file->groups.push_back(std::move(group));
    }
    file->reader = std::make_shared<Ramp>();
    return file;
}

std::size_t shown(const ChannelBrowser& browser) {
    std::size_t count = 0;
    for (int g = 0; g < browser.tree()->topLevelItemCount(); ++g)
        for (int c = 0; c < browser.tree()->topLevelItem(g)->childCount(); ++c)
            count +=
                browser.tree()->topLevelItem(g)->isHidden() || browser.tree()->topLevelItem(g)->child(c)->isHidden()
                    ? 0
                    : 1;
    return count;
}

TEST(ChannelBrowser, FindsChannelsByNameUnitAndComment) {
    ChannelBrowser browser;
    browser.show(fileOf(3, 10));
    EXPECT_EQ(shown(browser), 30u);
    browser.searchField()->setText("signal_1");
    EXPECT_EQ(shown(browser), 10u);
    browser.searchField()->setText("degc pump");
    EXPECT_EQ(shown(browser), 3u);
    browser.searchField()->setText("nothing of that name");
    EXPECT_EQ(shown(browser), 0u);
}

TEST(ChannelBrowser, ReadsWhatIsTickedAndNothingElse) {
    ChannelBrowser browser;
    browser.show(fileOf(3, 10));
    EXPECT_FALSE(browser.readButton()->isEnabled());
    browser.searchField()->setText("pump");
    browser.tickButton()->click();
    browser.searchField()->clear();
    EXPECT_EQ(browser.chosen(), (std::set<std::string>{"signal_0_3", "signal_1_3", "signal_2_3"}));
    EXPECT_TRUE(browser.readButton()->isEnabled());
    browser.tree()->topLevelItem(0)->setCheckState(0, Qt::Checked);  // a group ticks all of its channels
    EXPECT_EQ(browser.chosen().size(), 12u);
    int wanted = 0;
    QObject::connect(&browser, &ChannelBrowser::readWanted, [&] { ++wanted; });
    browser.readButton()->click();
    EXPECT_EQ(wanted, 1);
}

TEST(ChannelBrowser, DrawsTheMarkedChannel) {
    ChannelBrowser browser;
    browser.resize(900, 420);
    browser.show(fileOf(2, 20));
    static_cast<QWidget&>(browser).show();
    browser.tree()->setCurrentItem(browser.tree()->topLevelItem(0)->child(3));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !browser.sketch()->course().least.empty(); }, 10000));
    EXPECT_NEAR(browser.sketch()->course().to, 9.99, 1e-9);
    EXPECT_EQ(browser.sketch()->course().unit, "s");
    double largest = -1;
    for (const double value : browser.sketch()->course().largest) largest = std::max(largest, value);
    EXPECT_NEAR(largest, 1, 1e-3);
    QDir().mkpath(ANALOGON_PICTURES);
    EXPECT_TRUE(browser.grab().save(QStringLiteral(ANALOGON_PICTURES "/channel-browser.png")));
}

TEST(ChannelBrowser, IsThereAtOnceForThousands) {
    ChannelBrowser browser;
    browser.show(fileOf(20, 100));
    EXPECT_EQ(shown(browser), 2000u);
    browser.tickButton()->click();
    EXPECT_EQ(browser.chosen().size(), 2000u);
}

}  // namespace
}  // namespace analogon::ui
