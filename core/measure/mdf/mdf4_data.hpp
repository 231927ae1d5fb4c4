#pragma once

#include <vector>

#include "core/base/text.hpp"
#include "core/measure/mdf/data_stream.hpp"
#include "core/measure/mdf/mdf4_blocks.hpp"

namespace analogon::mdf {

/// The data behind a link: one block (DT, SD, DV, DZ) or a list of them (DL, HL, LD).
struct Data4 {
    DataStream records;
    DataStream invalidation;  // of a list LD
    bool hasInvalidationApart{};
    bool isCut{};      // the file ends within a block
    bool isDamaged{};  // a link or a packed block made no sense: what lies there is left out
    bool wasOpen{};    // the last block had no length yet: it goes on to the next block or the end of the file
};

/// `isUnfinished`: the recorder did not write the length of the last block.
Data4 readData4(Blocks4& blocks, std::uint64_t address, bool isUnfinished);

}  // namespace analogon::mdf
