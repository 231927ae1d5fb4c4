#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/diagram/edit.hpp"
#include "core/syntax/parser.hpp"

/// An edit of one place leaves every other byte of a file as it is, and its inverse brings the file back.
namespace analogon {
namespace {

namespace fs = std::filesystem;

struct Counts {
    int files{}, edits{};
};

/// Gives one component a value, and looks at the text around it.
void edit(const syntax::ClassDefinition& definition, const syntax::Component& component, Counts& counts) {
    const std::string& text = definition.source->text();
    const auto change = ModelEdit(definition).setBinding(component.name, "1.5").finish("value");
    ASSERT_TRUE(change) << format(change.diagnostics());
    const syntax::AppliedEdit applied = syntax::apply(text, *change);
    const std::string& after = applied.text;
    const std::size_t from = component.clauseSpan.begin, behind = text.size() - component.clauseSpan.end;
    EXPECT_EQ(after.substr(0, from), text.substr(0, from)) << component.name;
    EXPECT_EQ(after.substr(after.size() - behind), text.substr(text.size() - behind)) << component.name;
    EXPECT_NE(after, text) << component.name;
    EXPECT_EQ(syntax::apply(after, applied.inverse).text, text) << component.name;
    ++counts.edits;
}

void editAll(const syntax::ClassDefinition& definition, Counts& counts) {
    for (const syntax::Component& component : definition.components) edit(definition, component, counts);
    for (const syntax::ClassPtr& inner : definition.classes) editAll(*inner, counts);
}

TEST(RoundTrip, OnlyTheEditedPlaceOfEveryShippedFileChanges) {
    Counts counts;
    for (const char* folder : {"/resources/Analogon", "/examples", "/tests/models"})
        for (const auto& entry : fs::recursive_directory_iterator(std::string(ANALOGON_ROOT) + folder)) {
            if (entry.path().extension() != ".mo" || entry.path().parent_path().filename() == "faults") continue;
            SCOPED_TRACE(entry.path());
            std::ifstream stream(entry.path(), std::ios::binary);
            std::string text((std::istreambuf_iterator<char>(stream)), {});
            const auto source = std::make_shared<const Source>(entry.path().filename().string(), std::move(text));
            const syntax::ParseResult parsed = syntax::parse(source);
            ASSERT_FALSE(hasError(parsed.diagnostics)) << format(parsed.diagnostics);
            for (const syntax::ClassPtr& definition : parsed.definition.classes) editAll(*definition, counts);
            ++counts.files;
        }
    EXPECT_GT(counts.files, 50);
    EXPECT_GT(counts.edits, 300);
    std::printf("%d edits of %d files\n", counts.edits, counts.files);
}

}  // namespace
}  // namespace analogon
