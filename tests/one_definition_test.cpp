#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tests/cpp_tokens.hpp"

/// One name, one definition. Two different types of one qualified name in two files are no fault for the compiler, and
/// the linker keeps the constructor, the destructor or the inline function of one of them for both: a crash far from
/// its cause. What belongs to one file stands in an unnamed namespace; this test reads all sources and names the rest.
namespace {

namespace fs = std::filesystem;
using namespace analogon;

/// What stands before a brace or a semicolon, without the heads of templates.
struct Statement {
    explicit Statement(const Tokens& all) {
        for (auto at = all.begin(); at != all.end();) {
            if (at->text == "template" && at + 1 != all.end() && (at + 1)->text == "<") {
                const auto end = pastBracket(at + 1, all.end());
                templates += joined(at, end);
                at = end;
            } else {
                tokens.push_back(*at++);
            }
        }
    }
    bool has(const char* text) const { return find(text) != tokens.end(); }
    Tokens::const_iterator find(const char* text) const {
        return std::find_if(tokens.begin(), tokens.end(), [&](const Token& t) { return t.text == text; });
    }

    Tokens tokens;
    std::string templates;
};

/// The name at `at` with its qualifiers and template arguments; `at` is then behind it.
std::string nameAt(Tokens::const_iterator& at, Tokens::const_iterator end) {
    const auto begin = at;
    while (at != end && (isNameStart(at->text.front()) || at->text == "::")) {
        const bool isQualifier = at->text == "::";
        if (!isQualifier && at != begin && (at - 1)->text != "::") break;
        ++at;
        if (!isQualifier && at != end && at->text == "<") at = pastBracket(at, end);
    }
    return joined(begin, at);
}

/// The name of the type that begins with the brace behind a statement; empty for one without a name, nothing: it is
/// something else.
std::optional<std::string> typeIn(const Statement& s) {
    int depth = 0;
    for (auto at = s.tokens.begin(); at != s.tokens.end(); ++at) {
        if (isOneOf(at->text, {"(", "<", "["})) ++depth;
        if (isOneOf(at->text, {")", ">", "]"})) --depth;
        if (depth != 0 || !isOneOf(at->text, {"struct", "class", "union", "enum"})) continue;
        const auto rest = std::find_if(at, s.tokens.end(), [](const Token& t) { return isOneOf(t.text, {"(", "="}); });
        if (rest != s.tokens.end()) return std::nullopt;  // a function or an initial value
        for (++at; at != s.tokens.end() && isOneOf(at->text, {"struct", "class"});) ++at;
        while (at != s.tokens.end() && at->text == "[") at = pastBracket(at, s.tokens.end());
        std::string name = nameAt(at, s.tokens.end());
        if (at != s.tokens.end() && !isOneOf(at->text, {"final", ":"})) return std::nullopt;  // a variable
        return name;
    }
    return std::nullopt;
}

struct Definition {
    std::string name;  // in full; of a function with its parameters
    std::string file;
    int line{};
};

/// The definitions of a source that more than one file may hold: types, templates, inline functions and variables.
class Reader {
public:
    Reader(std::string file, const std::string& text) : file_(std::move(file)), tokens_(Lexer(text).tokens()) {}

    std::vector<Definition> definitions() {
        Tokens statement;
        for (auto at = tokens_.cbegin(); at != tokens_.cend();) {
            if (at->text == "{" && isBracketOpen(statement)) {
                const auto end = pastBracket(at, tokens_.cend());  // an argument
                statement.insert(statement.end(), at, end);
                at = end;
            } else if (at->text == "{") {
                at = brace(Statement(statement), at);
                statement.clear();
            } else if (at->text == "}" || at->text == ";") {
                if (at->text == "}" && !scopes_.empty()) scopes_.pop_back();
                if (at->text == ";") variable(Statement(statement), at);
                statement.clear();
                ++at;
            } else {
                statement.push_back(*at++);
            }
        }
        return std::move(found_);
    }

private:
    struct Scope {
        std::string name;
        bool isSeenOutside{};  // nothing in an unnamed namespace is
    };

    static bool isBracketOpen(const Tokens& statement) {
        int depth = 0;
        for (const Token& t : statement) depth += t.text == "(" ? 1 : t.text == ")" ? -1 : 0;
        return depth > 0;
    }
    bool isSeenOutside() const { return scopes_.empty() || scopes_.back().isSeenOutside; }
    void open(const std::string& name, bool isNamed) { scopes_.push_back({name, isNamed && isSeenOutside()}); }
    void add(const std::string& name, Tokens::const_iterator at) {
        if (!isSeenOutside()) return;
        std::string full;
        for (const Scope& scope : scopes_)
            if (!scope.name.empty()) full += scope.name + "::";
        found_.push_back({full + name, file_, at->line});
    }

    Tokens::const_iterator brace(const Statement& s, Tokens::const_iterator at) {
        if (const auto found = s.find("namespace"); found != s.tokens.end()) {
            const std::string name = joined(found + 1, s.tokens.end());
            open(name, !name.empty());
            return at + 1;
        }
        if (!s.tokens.empty() && s.tokens.front().text == "extern" && s.tokens.size() == 2) {
            open("", true);
            return at + 1;
        }
        if (const std::optional<std::string> type = typeIn(s)) {
            if (!type->empty()) add(*type, at);
            open(*type, !type->empty());
            return at + 1;
        }
        function(s, at);
        variable(s, at);
        return pastBracket(at, tokens_.cend());  // a body or a value: nothing in it is seen outside
    }

    /// One that each file may define for itself. What is no function changes nothing.
    void function(const Statement& s, Tokens::const_iterator at) {
        const bool isShared = s.has("inline") || s.has("constexpr") || !s.templates.empty();
        const auto begin = s.tokens.begin(), end = s.tokens.end(), sign = s.find("operator");
        if (!isShared || s.has("static")) return;
        const auto parameters = std::find_if(sign == end ? begin : std::min(sign + 2, end), end,
                                             [](const Token& t) { return t.text == "("; });
        if (parameters == begin || parameters == end) return;
        auto name = sign;
        if (sign == end) {
            if (std::find_if(begin, parameters, [](const Token& t) { return t.text == "="; }) != parameters) return;
            for (name = parameters - 1; name != begin && ((name - 1)->text == "::" || name->text == "::");) --name;
        }
        add(s.templates + joined(name, pastBracket(parameters, end)), at);
    }

    void variable(const Statement& s, Tokens::const_iterator at) {
        if (!s.has("inline") || s.has("(") || s.has("using") || s.has("namespace")) return;
        const auto value = std::find_if(s.tokens.begin(), s.tokens.end(), [](const Token& t) {
            return isOneOf(t.text, {"=", "["});
        });
        if (value != s.tokens.begin()) add((value - 1)->text, at);
    }

    std::string file_;
    Tokens tokens_;
    std::vector<Scope> scopes_;
    std::vector<Definition> found_;
};

std::vector<Definition> definitionsIn(const std::string& file, const std::string& text) {
    return Reader(file, text).definitions();
}

/// One message for each name that is defined in more than one file.
std::vector<std::string> repeated(const std::vector<Definition>& definitions) {
    std::map<std::string, std::vector<Definition>> byName;
    for (const Definition& d : definitions) byName[d.name].push_back(d);
    std::vector<std::string> messages;
    for (const auto& [name, places] : byName) {
        std::set<std::string> files;
        std::string message = name + " is defined in";
        for (const Definition& place : places)
            if (files.insert(place.file).second) message += " " + place.file + ":" + std::to_string(place.line);
        if (files.size() > 1) messages.push_back(message);
    }
    return messages;
}

std::vector<Definition> definitionsBelow(std::initializer_list<const char*> folders) {
    const fs::path root = ANALOGON_ROOT;
    std::vector<Definition> all;
    for (const char* const folder : folders) {
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            if (!isOneOf(entry.path().extension().string(), {".hpp", ".cpp"})) continue;
            std::ifstream stream(entry.path(), std::ios::binary);
            const std::string text{std::istreambuf_iterator<char>(stream), {}};
            const auto found = definitionsIn(entry.path().lexically_relative(root).generic_string(), text);
            all.insert(all.end(), found.begin(), found.end());
        }
    }
    return all;
}

TEST(OneDefinition, OfEachNameInAllSourcesAndTests) {
    const std::vector<Definition> all = definitionsBelow({"core", "ui", "app", "tests"});
    EXPECT_GT(all.size(), 500u) << "the sources were not read";
    const auto isKnown = [&](const char* name) {
        return std::any_of(all.begin(), all.end(), [&](const Definition& d) { return d.name == name; });
    };
    for (const char* name : {"analogon::Recording", "analogon::Outcome", "analogon::cli::Interrupt::LastWords"})
        EXPECT_TRUE(isKnown(name)) << name;
    for (const std::string& message : repeated(all)) ADD_FAILURE() << message;
}

std::vector<std::string> namesIn(const std::string& text) {
    std::vector<std::string> names;
    for (const Definition& d : definitionsIn("x.cpp", text)) names.push_back(d.name);
    return names;
}

using Names = std::vector<std::string>;

TEST(OneDefinition, IsReadWithItsScope) {
    EXPECT_EQ(
        namesIn("namespace a::b {\nstruct X : Y<int> { struct Z { int z{1}; }; enum class E : int { one }; };\n}\n"
                "class Y final {};"),
        (Names{"a::b::X", "a::b::X::Z", "a::b::X::E", "Y"}));
    EXPECT_EQ(namesIn("namespace a {\nnamespace {\nstruct X {};\nnamespace n { struct Z {}; }\n}\nstruct Y {}; }"),
              Names{"a::Y"});
    EXPECT_EQ(namesIn("template <class T> struct hash {}; template <> struct hash<A<int>> {};"),
              (Names{"hash", "hash<A<int>>"}));
    EXPECT_EQ(namesIn("extern \"C\" {\nstruct X {};\n}"), Names{"X"});
}

TEST(OneDefinition, IsNoneWhereATypeIsOnlyNamed) {
    EXPECT_TRUE(namesIn("struct X; friend class Y; struct stat status {}; struct stat of(int a) { struct Z {}; }\n"
                        "const struct X x = {1}; enum class Kind : int; void f(struct X* x) { class Y {}; }")
                    .empty());
    EXPECT_TRUE(
        namesIn("// struct A {};\n/* struct B {}; */\n#define C struct C {\\\n};\n"
                "const char* d = \"struct D {\"; const char* e = R\"x(struct E {)x\"; int f = 1'000'000; char g = '{';")
            .empty());
}

TEST(OneDefinition, IsAlsoThatOfAnInlineFunctionATemplateOrAConstant) {
    EXPECT_EQ(namesIn("namespace a { inline int f(int x) { return x; } template <class T> T g(T x = {}) { return x; }\n"
                      "int h() { return 1; } static inline int i() { return 1; } inline constexpr int j = 3;\n"
                      "inline bool operator==(A x, A y) { return true; } inline const S k{1}; constexpr int l = 4; }"),
              (Names{"a::f(int x)", "a::template<class T>g(T x={})", "a::j", "a::operator==(A x,A y)", "a::k"}));
}

TEST(OneDefinition, ThatStandsTwiceIsNamedWithBothPlaces) {
    std::vector<Definition> all = definitionsIn("core/a.cpp", "namespace n {\nstruct Recording { double x; };\n}");
    const auto add = [&](const char* file, const char* text) {
        const auto more = definitionsIn(file, text);
        all.insert(all.end(), more.begin(), more.end());
    };
    add("core/b.cpp", "namespace n { namespace { struct Recording { int y; }; } }");
    add("core/c.cpp", "namespace m { struct Recording {}; }");
    add("core/a.cpp", "struct Alternative {}; struct Alternative {};");
    EXPECT_TRUE(repeated(all).empty());
    add("core/d.cpp", "\n\nnamespace n { struct Recording { int y; }; }");
    EXPECT_EQ(repeated(all), Names{"n::Recording is defined in core/a.cpp:2 core/d.cpp:3"});
}

}  // namespace
