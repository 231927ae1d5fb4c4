#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/cpp_tokens.hpp"

/// A record that is passed on whole is understood whole: in the search, none has more than ten data members.
namespace analogon {
namespace {

namespace fs = std::filesystem;
using At = Tokens::const_iterator;

struct Record {
    std::string name;
    int members{};
};

/// How many variables a statement of a record declares: "int a, b{2}" two; a function, a type or an alias none.
int declaredIn(At begin, At end) {
    while (begin != end && isOneOf(begin->text, {"public", "private", "protected", ":", "mutable", "const"})) ++begin;
    if (begin == end || isOneOf(begin->text, {"using", "friend", "static", "enum", "template", "explicit", "virtual",
                                              "typedef", "struct", "class", "operator", "~"}))
        return 0;
    int count = 1;
    for (At at = begin; at != end;) {
        if (at->text == "(" || at->text == "operator") return 0;
        if (at->text == "=") {  // up to a comma that separates variables
            while (at != end && at->text != ",") at = isOneOf(at->text, {"(", "{"}) ? pastBracket(at, end) : at + 1;
            continue;
        }
        if (isOneOf(at->text, {"<", "{", "["})) {
            at = pastBracket(at, end);
            continue;
        }
        count += at->text == ",";
        ++at;
    }
    return count;
}

/// The members of a record whose body begins at `at`, and the records within it.
At readBody(At at, At end, const std::string& name, std::vector<Record>& records);

/// Every record from `at` on, to the end of a scope.
At readRecord(At at, At end, std::vector<Record>& records) {
    const std::string name = (at + 1)->text;
    for (++at; at != end && at->text != "{"; ++at)
        if (isOneOf(at->text, {";", "(", ")", ">", ",", "="})) return at;  // no definition: a declaration, an argument
    return at == end ? end : readBody(at + 1, end, name, records);
}

At readBody(At at, At end, const std::string& name, std::vector<Record>& records) {
    Record record{name};
    At begin = at;
    while (at != end && at->text != "}") {
        if (isOneOf(at->text, {"struct", "class"}) && at == begin && at + 1 != end) {
            at = begin = readRecord(at, end, records);
        } else if (at->text == ";") {
            record.members += declaredIn(begin, at);
            begin = ++at;
        } else if (at->text == "{") {
            const bool isFunction = declaredIn(begin, at) == 0;
            at = pastBracket(at, end);
            if (isFunction && at != end && at->text != ";") begin = at;
        } else if (at->text == ":" && begin != at && isOneOf((at - 1)->text, {"public", "private", "protected"})) {
            begin = ++at;
        } else {
            at = at->text == "(" ? pastBracket(at, end) : at + 1;
        }
    }
    records.push_back(record);
    return at == end ? end : at + 1;
}

std::vector<Record> recordsIn(const std::string& text) {
    const Tokens tokens = Lexer(text).tokens();
    std::vector<Record> records;
    for (At at = tokens.begin(); at != tokens.end();) {
        const bool isRecord = isOneOf(at->text, {"struct", "class"}) && at + 1 != tokens.end() &&
                              (at == tokens.begin() || !isOneOf((at - 1)->text, {"enum", "<", ",", "friend"}));
        at = isRecord ? readRecord(at, tokens.end(), records) : at + 1;
    }
    return records;
}

TEST(DataMembers, AreCountedWithoutFunctionsAndTypes) {
    const std::vector<Record> records = recordsIn(R"(
        struct Plain { int a, b{2}; std::map<int, int> c{}; double d = f(1, 2), e[2]; };
        class Guarded : public Plain {
        public:
            explicit Guarded(int x) : x_(x) { int local; }
            enum class Kind { One, Two };
            using Alias = int;
            struct Inner { int one; };
            int get() const { return x_; }
            static constexpr int most = 3;
            bool operator==(const Guarded&) const = default;
        private:
            const int x_;  // no comment counts; int y;
            std::function<void(int, int)> call_;
            Inner inner_{};
        };
        struct Declared;
        void f(struct Plain p);
    )");
    ASSERT_EQ(records.size(), 3u);
    EXPECT_EQ(records[0].name, "Plain");
    EXPECT_EQ(records[0].members, 5);
    EXPECT_EQ(records[1].name, "Inner");
    EXPECT_EQ(records[1].members, 1);
    EXPECT_EQ(records[2].name, "Guarded");
    EXPECT_EQ(records[2].members, 3);
}

TEST(DataMembers, OfTheSearchAreAtMostTenInARecord) {
    int records = 0;
    for (const auto& file : fs::recursive_directory_iterator(fs::path(ANALOGON_ROOT) / "core/effect")) {
        if (file.path().extension() != ".cpp" && file.path().extension() != ".hpp") continue;
        std::ifstream source(file.path());
        for (const Record& record : recordsIn(std::string(std::istreambuf_iterator<char>(source), {}))) {
            ++records;
            EXPECT_LE(record.members, 10) << record.name << " in " << file.path();
        }
    }
    EXPECT_GT(records, 100);
}

}  // namespace
}  // namespace analogon
