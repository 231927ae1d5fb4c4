#include "ui/document/model_facts.hpp"

#include <QLabel>
#include <QTableView>
#include <algorithm>

#include "tests/ui/panels_fixture.hpp"
#include "ui/inspector/parameter_model.hpp"
#include "ui/inspector/parameter_panel.hpp"

namespace analogon::ui {
namespace {

Study studyOf(const std::string& text) {
    Study study;
    study.className = "M";
    study.models[study.modelFile] = text;
    return study;
}

std::vector<std::string> namesOf(const std::vector<SignalFact>& facts) {
    std::vector<std::string> names;
    for (const SignalFact& fact : facts) names.push_back(fact.name);
    return names;
}

const ParameterFact* parameterOf(const ModelFacts& facts, const std::string& name) {
    const auto found = std::find_if(facts.parameters.begin(), facts.parameters.end(),
                                    [&](const ParameterFact& fact) { return fact.name == name; });
    return found == facts.parameters.end() ? nullptr : &*found;
}

TEST(ModelFacts, InputsAreThoseThatAreDeclaredAndNotWhatEventsBringAlong) {
    const ModelFacts facts = modelFacts(
        studyOf("model M\n  input Real u;\n  output Real y;\n  Real v(start = 1, fixed = true);\n"
                "  discrete Real held(start = 0, fixed = true);\nequation\n  der(v) = if initial() then 0 else u - v;\n"
                "  when sample(0, 0.1) then\n    held = pre(held) + v;\n  end when;\n"
                "  when v > 2 then\n    reinit(v, 0.5 * pre(v));\n  end when;\n  y = held;\nend M;\n"));
    ASSERT_TRUE(facts.messages.empty()) << facts.messages.front().message.english();
    EXPECT_EQ(namesOf(facts.inputs), std::vector<std::string>{"u"});
    EXPECT_EQ(namesOf(facts.outputs), std::vector<std::string>{"y"});
    for (const std::string& name : namesOf(facts.variables)) {
        EXPECT_FALSE(name.starts_with("pre(")) << name;
        EXPECT_FALSE(name.starts_with("initial(")) << name;
        EXPECT_FALSE(name.starts_with("$")) << name;
    }
}

TEST(ModelFacts, TellsWhatIsDeclaredOfAModelWhoseEquationsAreWrong) {
    const ModelFacts facts =
        modelFacts(studyOf("model Part\n  parameter Real C(unit = \"J/K\", min = 0) = 2 \"Heat capacity\";\n  Real T;\n"
                           "equation\n  C * der(T) = unheard;\nend Part;\n"
                           "model M\n  parameter Real k = 3;\n  input Real u;\n  output Real y;\n  Part a(C = 2 * k);\n"
                           "  Part b;\n  Nowhere c;\nequation\n  connect(a.x, b.x);\n  y = lost;\nend M;\n"));
    EXPECT_FALSE(facts.messages.empty()) << "it is told what is wrong";
    const ParameterFact* const capacity = parameterOf(facts, "a.C");
    ASSERT_TRUE(capacity);
    EXPECT_EQ(capacity->value, 6);
    EXPECT_EQ(capacity->unit, "J/K");
    EXPECT_EQ(capacity->min, 0);
    EXPECT_EQ(capacity->description, "Heat capacity");
    ASSERT_TRUE(parameterOf(facts, "b.C"));
    EXPECT_EQ(parameterOf(facts, "b.C")->value, 2);
    ASSERT_TRUE(parameterOf(facts, "k"));
    EXPECT_EQ(namesOf(facts.inputs), std::vector<std::string>{"u"});
    EXPECT_EQ(namesOf(facts.outputs), std::vector<std::string>{"y"});
    EXPECT_TRUE(facts.variables.empty()) << "nothing simulates them";
}

class FaultyModel : public Panels {
protected:
    ParameterPanel* parameters() const { return panel<ParameterPanel>(); }
    QModelIndex value(const char* name) const {
        return parameters()->model()->index(parameters()->model()->rowOf(name), ParameterModel::Value);
    }
    void edit(const char* name, double to) {
        ASSERT_TRUE(value(name).isValid()) << name;
        EXPECT_TRUE(parameters()->model()->setData(value(name), QString::number(to), Qt::EditRole));
        EXPECT_TRUE(QTest::qWaitFor([&] { return document().parameterValue(name) == to; }, 5000));
    }
    void replace(const char* from, const char* by) {
        QString text = document().modelText();
        ASSERT_TRUE(text.contains(from));
        document().typeText(text.replace(from, by));
    }
    void TearDown() override { document().undoStack().setClean(); }
};

TEST_F(FaultyModel, ShowsAndTakesItsParametersAndSaysThatItIs) {
    openLambda();
    ASSERT_TRUE(QTest::qWaitFor([&] { return value("heater.R").isValid(); }, 5000));
    const int rows = parameters()->model()->rowCount();
    EXPECT_FALSE(parameters()->fault()->isVisible());
    replace("connect(heater.i", "connect(heater.current");
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().modelError() != nullptr; }, 5000));
    EXPECT_EQ(parameters()->model()->rowCount(), rows);
    EXPECT_TRUE(parameters()->table()->isVisible());
    EXPECT_TRUE(parameters()->fault()->isVisible());
    edit("heater.R", 4.5);
    EXPECT_TRUE(document().modelText().contains("4.5"));
    document().undoStack().undo();
    document().undoStack().undo();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !parameters()->fault()->isVisible(); }, 5000)) << "with its cause";
}

TEST_F(FaultyModel, ShowsThemWhenItIsOpenedLikeThat) {
    Outcome<Study> study = readStudy(ANALOGON_ROOT "/examples/lambda-sensor-heating");
    ASSERT_TRUE(study);
    std::string& text = study->models[study->modelFile];
    const std::size_t at = text.find("connect(heater.i");
    ASSERT_NE(at, std::string::npos);
    text.replace(at, 16, "connect(heater.current");
    document().startWith(*study);
    ASSERT_TRUE(QTest::qWaitFor([&] { return value("heater.R").isValid(); }, 20000));
    EXPECT_TRUE(parameters()->fault()->isVisible());
}

TEST_F(FaultyModel, KeepsWhatItToldLastWhileItsTextCannotBeRead) {
    openLambda();
    ASSERT_TRUE(QTest::qWaitFor([&] { return value("heater.R").isValid(); }, 5000));
    const auto settings = document().study().parameters;
    const QString before = document().modelText();
    replace("equation", "equation (");
    ASSERT_TRUE(QTest::qWaitFor([&] { return parameters()->fault()->isVisible(); }, 5000));
    ASSERT_FALSE(document().definition());
    edit("element.A", 7.5);
    ASSERT_TRUE(document().study().parameters.contains("element.A"));
    EXPECT_EQ(document().study().parameters.at("element.A").fit,
              settings.contains("element.A") && settings.at("element.A").fit)
        << "a value alone is no wish to fit it";
    document().undoStack().undo();
    document().undoStack().undo();
    EXPECT_EQ(document().modelText(), before);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !parameters()->fault()->isVisible(); }, 5000));
}

}  // namespace
}  // namespace analogon::ui
