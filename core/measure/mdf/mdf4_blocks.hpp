#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "core/measure/byte_view.hpp"

namespace analogon::mdf {

/// One block of format 4: links to others, then its own data.
struct Block4 {
    ByteView links;
    ByteView data;
    bool isCut{};  // its length goes beyond the file

    std::uint64_t linkCount() const { return links.size() / 8; }
    /// 0: none, or not there.
    std::uint64_t link(std::uint64_t index) const { return links.little<std::uint64_t>(index * 8); }
};

/// Finds blocks in a file whose links may lead anywhere.
class Blocks4 {
public:
    explicit Blocks4(ByteView file) : file_(file) {}

    ByteView file() const { return file_; }
    /// Nothing where the address holds no whole header of a block with this id ("CN", "TX" …).
    std::optional<Block4> block(std::uint64_t address, std::string_view id);
    /// The two letters of the block that lies there; empty: none.
    std::string_view idAt(std::uint64_t address) const;
    /// A text; of XML its <TX>. Empty: none.
    std::string text(std::uint64_t address);
    /// The same without blanks around it.
    std::string unit(std::uint64_t address);
    /// A link to a text led to none.
    bool hasLostText() const { return hasLostText_; }
    /// False where the block was entered before: the chain runs in a circle.
    bool enter(std::uint64_t address) { return entered_.insert(address).second; }
    /// Where the next block begins that any link was followed to; the end of the file behind the last.
    std::uint64_t nextBehind(std::uint64_t address) const;

private:
    ByteView file_;
    std::set<std::uint64_t> entered_, known_;
    bool hasLostText_{};
};

/// The text of <TX> (any depth) in a comment that is XML.
std::string commentText(std::string_view xml);

}  // namespace analogon::mdf
