#include "core/diagram/graphics_edit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/diagram/annotation.hpp"
#include "core/syntax/parser.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;

struct Written {
    std::string text;
    syntax::ParseResult parsed = syntax::parse(std::make_shared<const Source>("m.mo", text));

    const syntax::ClassDefinition& definition() const { return *parsed.definition.classes.front(); }
    std::uint32_t begin(const char* record) const { return static_cast<std::uint32_t>(text.find(record)); }
};

std::string after(const Written& model, const Outcome<syntax::TextEdit>& edit) {
    return edit ? syntax::apply(model.text, *edit).text : format(edit.diagnostics());
}

const Extent at{{-50, 40}, {50, 48}};
const std::string record =
    "Text(extent={{-50,40},{50,48}}, textString=\"the \\\"cold\\\" side\", "
    "horizontalAlignment=TextAlignment.Left)";

TEST(GraphicsEdit, AddsATextWhereverTheAnnotationIsYet) {
    const std::string text = textRecord(at, "the \"cold\" side");
    EXPECT_EQ(text, record);
    const auto with = [&](const std::string& annotation) {
        const Written model{"model M\n  Real x;\n" + annotation + "end M;\n"};
        return after(model, addGraphic(model.definition(), text, "add"));
    };
    EXPECT_EQ(with(""), "model M\n  Real x;\n  annotation (Diagram(graphics={" + record + "}));\nend M;\n");
    EXPECT_EQ(
        with("  annotation (experiment(StopTime=3));\n"),
        "model M\n  Real x;\n  annotation (experiment(StopTime=3), Diagram(graphics={" + record + "}));\nend M;\n");
    EXPECT_EQ(with("  annotation (Diagram(graphics={}));\n"),
              "model M\n  Real x;\n  annotation (Diagram(graphics={" + record + "}));\nend M;\n");
    EXPECT_EQ(
        with("  annotation (Diagram(graphics={Line(points={{0,0},{1,1}})}));\n"),
        "model M\n  Real x;\n  annotation (Diagram(graphics={Line(points={{0,0},{1,1}}), " + record + "}));\nend M;\n");
}

const Written drawn{
    "model M\n  annotation (Diagram(graphics={Text(extent={{0,0},{20,8}}, textString=\"one\"),\n    "
    "Bitmap(origin={5,5}, imageSource=\"AAAA\"),\n    Text(textString=\"three\")}));\nend M;\n"};

TEST(GraphicsEdit, ChangesTheOneThatIsMeantAlone) {
    GraphicChange change;
    change.text = "two";
    change.extent = Extent{{1, 2}, {3, 4}};
    EXPECT_THAT(after(drawn, changeGraphic(drawn.definition(), drawn.begin("Text(extent"), change, "")),
                HasSubstr("{Text(extent={{1,2},{3,4}}, textString=\"two\"),\n    Bitmap("));
    EXPECT_THAT(after(drawn, changeGraphic(drawn.definition(), drawn.begin("Text(textString"), change, "")),
                HasSubstr("Text(textString=\"two\", extent={{1,2},{3,4}})}"));
}

TEST(GraphicsEdit, MovesByItsOriginWhereItHasOne) {
    Primitive plain;
    plain.extent = {{0, 0}, {20, 8}};
    ASSERT_TRUE(moved(plain, 10, -5).extent);
    EXPECT_EQ(moved(plain, 10, -5).extent->p2.x, 30);
    Primitive turned = plain;
    turned.rotation = 90;
    ASSERT_TRUE(moved(turned, 10, -5).origin);
    EXPECT_THAT(after(drawn, changeGraphic(drawn.definition(), drawn.begin("Bitmap"), moved(turned, 10, -5), "")),
                HasSubstr("Bitmap(origin={10,-5}, imageSource"));
}

TEST(GraphicsEdit, RemovesWithTheCommaAndLeavesAListThatIsRead) {
    const auto without = [&](const char* which) {
        return after(drawn, removeGraphic(drawn.definition(), drawn.begin(which), ""));
    };
    EXPECT_THAT(without("Text(extent"), HasSubstr("graphics={Bitmap("));
    EXPECT_THAT(without("Bitmap"), HasSubstr("\"one\"),\n    Text(textString=\"three\")}"));
    EXPECT_THAT(without("Text(textString"), HasSubstr("imageSource=\"AAAA\")}));"));
    const Written single{"model M\n  annotation (Diagram(graphics={Text(textString=\"one\")}));\nend M;\n"};
    EXPECT_THAT(after(single, removeGraphic(single.definition(), single.begin("Text"), "")),
                HasSubstr("Diagram(graphics={})"));
}

TEST(GraphicsEdit, SaysWhatIsNotThereAnyMore) {
    EXPECT_THAT(after(drawn, removeGraphic(drawn.definition(), 3, "")), HasSubstr("no such text or picture"));
    const Written alias{"model M = N;\n"};
    EXPECT_THAT(after(alias, addGraphic(alias.definition(), record, "")), HasSubstr("no place for a text"));
}

/// The directory in which a test works, and back.
struct InDirectory {
    std::filesystem::path before = std::filesystem::current_path();

    explicit InDirectory(const std::filesystem::path& directory) {
        std::filesystem::create_directories(directory);
        std::filesystem::current_path(directory);
    }
    ~InDirectory() { std::filesystem::current_path(before); }
};

TEST(OwnGraphics, APictureOfAPackageIsFoundFromATextWithoutADirectory) {
    const auto place = std::filesystem::temp_directory_path() / "analogon-picture-of-a-package";
    const InDirectory there(place / "Bench");
    std::ofstream(place / "Bench" / "package.mo") << "package Bench end Bench;";
    const Written model{
        "model M\n  annotation (Diagram(graphics={Bitmap(extent={{0,0},{9,9}}, "
        "fileName=\"modelica://Bench/Pictures/pump.png\")}));\nend M;\n"};
    const std::vector<OwnGraphic> own = ownGraphics(model.definition());
    ASSERT_EQ(own.size(), 1u);
    EXPECT_EQ(annotation::pictureFile(own[0].primitive), (place / "Bench" / "Pictures" / "pump.png").string());
    std::filesystem::remove_all(place);
}

}  // namespace
}  // namespace analogon
