#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace analogon {

/// A place in a text as a person counts it: both start at 1; a column counts bytes of UTF-8.
struct Position {
    int line{1};
    int column{1};
};

/// One text with the name it goes by in messages. Immutable; spans point into it.
class Source {
public:
    Source(std::string name, std::string text);

    const std::string& name() const { return name_; }
    const std::string& text() const { return text_; }
    Position position(std::uint32_t offset) const;
    /// The line (1-based) without its line end; empty outside the text.
    std::string_view line(int number) const;

private:
    std::string name_;
    std::string text_;
    std::vector<std::uint32_t> lineStarts_;
};

using SourcePtr = std::shared_ptr<const Source>;

/// A half-open range of bytes [begin, end) of a source. The tree that holds a span keeps its source alive.
struct Span {
    const Source* source{};
    std::uint32_t begin{};
    std::uint32_t end{};

    bool valid() const { return source != nullptr; }
    std::string_view text() const {
        return source ? std::string_view(source->text()).substr(begin, end - begin) : std::string_view{};
    }
};

/// The smallest span that covers both.
Span cover(const Span& a, const Span& b);

}  // namespace analogon
