#pragma once

#include "core/measure/byte_view.hpp"
#include "core/measure/mdf/conversion.hpp"

namespace analogon::mdf {

/// A block CC of format 2 or 3, given whole; `file` because texts of ranges lie elsewhere in it.
std::shared_ptr<const Conversion> readConversion3(ByteView file, ByteView block, bool isBigEndian, bool isInteger);

/// Text of these formats: Windows-1252, or UTF-8 where it can be nothing else.
std::string text3(ByteView bytes);

/// The text of a block TX. Empty: none.
std::string textBlock3(ByteView file, std::uint64_t address, bool isBigEndian);

}  // namespace analogon::mdf
