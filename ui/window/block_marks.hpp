#pragma once

#include <vector>

#include "ui/canvas/diagram_scene.hpp"

namespace analogon::ui {

class Document;

/// What is to be said of the blocks of the diagram that is shown: which parameters of them are fitted and with what
/// result, which of those ended at a bound, and which effects brought or changed them. One of the first two a block.
std::vector<BlockMark> blockMarks(const Document& document);

}  // namespace analogon::ui
