#pragma once

#include <optional>
#include <string>

#include "core/diagram/diagram.hpp"
#include "core/syntax/text_edit.hpp"

/// What a diagram shows beside its blocks and wires: the texts and pictures of the annotation Diagram, and edits of
/// them. One that is there is meant by the place where its record begins in the text.
namespace analogon {

struct OwnGraphic {
    Primitive primitive;
    std::uint32_t begin{};
};
/// Of the class itself, without those of its bases, which come before them in Diagram::graphics.
std::vector<OwnGraphic> ownGraphics(const syntax::ClassDefinition& definition);

/// A line of text, which fills its extent from the left.
std::string textRecord(const Extent& extent, const std::string& text);
/// A picture: the bytes of its file in base64, so that it goes with the model wherever that goes.
std::string pictureRecord(const Extent& extent, const std::string& base64);

/// In front of all that is drawn already.
Outcome<syntax::TextEdit> addGraphic(const syntax::ClassDefinition& definition, const std::string& record,
                                     std::string what);

struct GraphicChange {
    std::optional<Extent> extent{};
    std::optional<Point> origin{};
    std::optional<std::string> text{};
};
Outcome<syntax::TextEdit> changeGraphic(const syntax::ClassDefinition& definition, std::uint32_t begin,
                                        const GraphicChange& change, std::string what);
/// How a primitive comes to lie elsewhere.
GraphicChange moved(const Primitive& primitive, double dx, double dy);

Outcome<syntax::TextEdit> removeGraphic(const syntax::ClassDefinition& definition, std::uint32_t begin,
                                        std::string what);

}  // namespace analogon
