#include "ui/measurement/mapping.hpp"

#include <QPushButton>
#include <QTreeWidget>

#include "tests/ui/panels_fixture.hpp"
#include "ui/measurement/import_panel.hpp"
#include "ui/measurement/measurement_panel.hpp"

namespace analogon::ui {
namespace {

Table tableOf(const std::vector<std::pair<std::string, std::vector<double>>>& columns) {
    Table table;
    for (const auto& [name, values] : columns) {
        Column column;
        column.name = name;
        column.unit = "V";
        column.values = values;
        table.columns.push_back(column);
    }
    return table;
}

ModelFacts factsOf(std::vector<SignalFact> inputs) {
    ModelFacts facts;
    facts.inputs = std::move(inputs);
    return facts;
}

std::string columnOf(const Table& table, const ModelFacts& facts, const std::string& input) {
    StudyExperiment experiment;
    proposeMapping(experiment, table, facts, {});
    const auto found = experiment.inputs.find(input);
    return found == experiment.inputs.end() ? std::string() : found->second.column;
}

TEST(Mapping, TakesWhatDrivesBeforeWhatSuppliesTheBench) {
    const ModelFacts facts = factsOf({{"u", "V", ""}});
    EXPECT_EQ(columnOf(tableOf({{"U_bat", {0, 14}}, {"U_M", {0, 12}}}), facts, "u"), "U_M") << "by its name";
    EXPECT_EQ(columnOf(tableOf({{"U_1", {13.5, 13.6}}, {"U_2", {0, 12}}}), facts, "u"), "U_2") << "by what it does";
    EXPECT_EQ(columnOf(tableOf({{"U_bat", {13.5, 13.6}}}), facts, "u"), "U_bat") << "there is no other";
    EXPECT_EQ(columnOf(tableOf({{"U_bat", {13.5, 13.6}}, {"U_M", {0, 12}}}), factsOf({{"U_bat", "V", ""}}), "U_bat"),
              "U_bat")
        << "of that name";
}

TEST(Mapping, TakesNoneOfTwoThatFitAlikeAndNamesThem) {
    const SignalFact input{"u", "V", ""};
    const Table table = tableOf({{"U_1", {0, 5}}, {"U_2", {1, 12}}, {"U_bat", {13, 14}}});
    EXPECT_EQ(columnOf(table, factsOf({input}), "u"), "");
    EXPECT_EQ(rivalColumns({}, input, true, table), (std::vector<std::string>{"U_1", "U_2"}));
    StudyExperiment mapped;
    mapped.outputs["y"].column = "U_1";
    EXPECT_TRUE(rivalColumns(mapped, input, true, table).empty()) << "the other is used";
}

class MappingInTheWindow : public Panels {};

TEST_F(MappingInTheWindow, AsksWhichOfTwoColumnsIsMeant) {
    window.startNew();
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen(); }, 20000));
    ASSERT_EQ(document().study().className, "Model");
    document().typeText(
        "model Model\n  Analogon.Interfaces.RealInput u(unit=\"V\");\n  Analogon.Interfaces.RealOutput y(unit=\"A\");\n"
        "equation\n  y = u/2;\nend Model;\n");
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().facts().inputs.empty(); }, 20000));
    QFile file(directory.filePath("two.csv"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("t [s],U_1 [V],U_2 [V],I [A]\n0,0,5,1\n1,3,1,2\n2,9,7,3\n");
    file.close();
    window.open(file.fileName());
    auto* import = panel<ImportPanel>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return import->acceptButton()->isEnabled(); }, 10000));
    QTest::mouseClick(import->acceptButton(), Qt::LeftButton);
    const auto textOf = [&](const QString& signal) {
        const auto found = panel<MeasurementPanel>()->tree()->findItems(signal, Qt::MatchExactly | Qt::MatchRecursive);
        return found.isEmpty() ? QString() : found.front()->text(1);
    };
    ASSERT_TRUE(QTest::qWaitFor([&] { return textOf("u") == "U_1 or U_2?"; }, 10000)) << textOf("u").toStdString();
    EXPECT_TRUE(textOf("y").startsWith("I")) << textOf("y").toStdString();
}

}  // namespace
}  // namespace analogon::ui
