#pragma once

#include <map>

#include "core/measure/mdf/conversion.hpp"
#include "core/measure/mdf/mdf4_blocks.hpp"

namespace analogon::mdf {

/// Reads the conversions of a file, each once however many channels share it.
class Conversions4 {
public:
    explicit Conversions4(Blocks4& blocks) : blocks_(blocks) {}

    /// Null: none. `isInteger`: of the numbers in the record.
    std::shared_ptr<const Conversion> read(std::uint64_t address, bool isInteger) {
        return read(address, isInteger, 0);
    }

private:
    using Pointer = std::shared_ptr<const Conversion>;
    Pointer read(std::uint64_t address, bool isInteger, int depth);
    void readTexts(const Block4& block, Conversion& conversion, bool isInteger, int depth);
    void readFromText(const Block4& block, Conversion& conversion);

    Blocks4& blocks_;
    std::map<std::pair<std::uint64_t, bool>, Pointer> known_;
};

}  // namespace analogon::mdf
