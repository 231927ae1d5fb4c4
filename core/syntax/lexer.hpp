#pragma once

#include <cstdint>
#include <vector>

#include "core/base/diagnostic.hpp"
#include "core/base/source.hpp"

/// Words of a Modelica text (Modelica 3.6, chapter 2). Private to the parser.
namespace analogon::syntax {

struct Token {
    enum class Kind : std::uint8_t { Identifier, Keyword, Integer, Real, String, Symbol, End };

    Kind kind{Kind::End};
    std::uint32_t begin{};
    std::uint32_t end{};
};

struct LexedText {
    std::vector<Token> tokens;  // the last one is of kind End
    Diagnostics faults;
    bool isCutShort{};  // an open string or comment swallowed the rest: what lacks at the end follows from that
};

LexedText lex(const Source& source);

}  // namespace analogon::syntax
