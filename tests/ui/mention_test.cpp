#include "ui/document/mention.hpp"

#include <gtest/gtest.h>

#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QTabBar>
#include <QTableView>
#include <QTest>
#include <QTreeWidget>

#include "tests/ui/sample_finding.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/document/document.hpp"
#include "ui/effect/result_panel.hpp"
#include "ui/inspector/parameter_model.hpp"
#include "ui/inspector/parameter_panel.hpp"
#include "ui/messages/message_panel.hpp"
#include "ui/plot/plot_panel.hpp"
#include "ui/window/main_window.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {
namespace {

/// What the window says leads to what it speaks of.
class Mentions : public testing::Test {
protected:
    void SetUp() override {
        window.resize(1440, 900);
        window.show();
        window.open(ANALOGON_ROOT "/examples/lambda-sensor-heating");
        ASSERT_TRUE(QTest::qWaitFor(
            [&] { return document().isOpen() && document().before() && !document().facts().parameters.empty(); },
            20000));
    }
    ~Mentions() override { QTest::qWait(1); }
    Document& document() { return window.document(); }
    template <class T>
    T* panel() const {
        return window.findChild<T*>();
    }
    void click(const Text& message) {
        document().setRunMessages({warning(message)});
        auto* list = panel<MessagePanel>()->list();
        ASSERT_EQ(list->count(), 1);
        window.findChild<QDockWidget*>("messages")->raise();
        QTest::qWait(20);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
    }

    MainWindow window;
};

TEST(LinkedWords, LinkNamesAndNothingElse) {
    const auto target = [](const QString& name) {
        return name.startsWith("heater.") ? "parameter:" + name : QString();
    };
    EXPECT_EQ(linkedWords(
                  phrase("{} cannot be told apart from these data: fix one", listed({"heater.R", "heater.alpha", "k"})),
                  target),
              "<a href=\"parameter:heater.R\">heater.R</a>, <a href=\"parameter:heater.alpha\">heater.alpha</a> and k "
              "cannot be told apart from these data: fix one");
    EXPECT_EQ(linkedWords(phrase("{} < {:.2f}", "a&b", 1.0), target), "a&amp;b &lt; 1.00");
    EXPECT_EQ(namesIn(phrase("experiment '{}': {}", "run", phrase("{} rests", "R"))), (QStringList{"run", "R"}));
}

TEST_F(Mentions, OfAParameterLeadToItsRow) {
    panel<DiagramScene>()->select("element");  // its parameters alone are listed
    click(phrase("{} and {} can hardly be told apart (correlation {:.5f})", "heater.R", "heater.alpha", 0.99971));
    auto* parameters = panel<ParameterPanel>();
    EXPECT_EQ(parameters->table()->currentIndex().row(), parameters->model()->rowOf("heater.R"));
    EXPECT_TRUE(parameters->table()->hasFocus());
    EXPECT_TRUE(parameters->note()->text().contains("heater.R")) << parameters->note()->text().toStdString();
}

TEST_F(Mentions, OfARecordingOrABlockLeadThere) {
    click(phrase("experiment '{}': the integration is only accurate to {:.2g} % of the output's range", "drive cycle",
                 0.2));
    auto* tabs = panel<PlotPanel>()->findChild<QTabBar*>();
    EXPECT_EQ(tabs->tabText(tabs->currentIndex()), "drive cycle");
    click(phrase("No start value is given for {}; 0 is taken.", "exhaust.port.T"));
    EXPECT_EQ(panel<DiagramScene>()->pointedOut(), "exhaust.port.T");
    click(phrase("No start value is given for {}; 0 is taken.", "i_mod"));
    EXPECT_EQ(panel<DiagramScene>()->selectedBlock(), "i_mod");
    click(phrase("nothing of this study: {}", "nowhere"));  // leads nowhere, and does no harm
    EXPECT_FALSE(mentionOf(document(), "nowhere"));
}

TEST_F(Mentions, InTheResultAreLinks) {
    RunResult result = sampleFinding(document(), "thermal.radiation", "Analogon.Effects.Thermal.Radiation",
                                     "Radiation to constant surroundings", "heater.heatPort", "port", "k_r");
    result.finding.warnings = {phrase("experiment '{}': {}", "drive cycle", "x")};
    document().setResult(RunKind::Discover, std::move(result), document().study());
    QLabel* caution = nullptr;
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            for (QLabel* label : panel<ResultPanel>()->findChildren<QLabel*>())
                if (label->text().contains("experiment:drive cycle")) caution = label;
            return caution != nullptr;
        },
        5000));
    Q_EMIT caution->linkActivated("experiment:drive cycle");
    auto* tabs = panel<PlotPanel>()->findChild<QTabBar*>();
    EXPECT_EQ(tabs->tabText(tabs->currentIndex()), "drive cycle");
}

}  // namespace
}  // namespace analogon::ui
