#include "core/diagram/experiment_edit.hpp"

#include <gtest/gtest.h>

#include "core/syntax/parser.hpp"

namespace analogon {
namespace {

std::string with(const std::string& text, double stop) {
    const auto parsed = syntax::parse(std::make_shared<const Source>("m.mo", text));
    const Outcome<syntax::TextEdit> edit = stopTimeEdit(*parsed.definition.classes.front(), stop, "stop");
    return edit ? syntax::apply(text, *edit).text : format(edit.diagnostics());
}

TEST(ExperimentEdit, WritesAnAnnotationWhereThereIsNone) {
    EXPECT_EQ(with("model M\n  Real x;\nequation\n  x = 1;\nend M;\n", 2.5),
              "model M\n  Real x;\nequation\n  x = 1;\n  annotation (experiment(StopTime=2.5));\nend M;\n");
}

TEST(ExperimentEdit, KeepsTheOtherAnnotations) {
    EXPECT_EQ(with("model M\n  annotation (Icon(), uses(A(version=\"1\")));\nend M;\n", 10),
              "model M\n  annotation (Icon(), uses(A(version=\"1\")), experiment(StopTime=10));\nend M;\n");
    EXPECT_EQ(with("model M\n  annotation (experiment(StartTime=1, Interval = 0.1));\nend M;\n", 10),
              "model M\n  annotation (experiment(StopTime=10, StartTime=1, Interval = 0.1));\nend M;\n");
}

TEST(ExperimentEdit, ChangesTheStopTimeThatIsThere) {
    EXPECT_EQ(with("model M\n  annotation (experiment(StopTime = 3, Tolerance=1e-6));\nend M;\n", 0.01),
              "model M\n  annotation (experiment(StopTime=0.01, Tolerance=1e-6));\nend M;\n");
}

TEST(ExperimentEdit, RefusesAClassWithoutABody) {
    EXPECT_NE(with("model M = N;\n", 1).find("has no place for a stop time"), std::string::npos);
}

}  // namespace
}  // namespace analogon
