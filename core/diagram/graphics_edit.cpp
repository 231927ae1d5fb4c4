#include "core/diagram/graphics_edit.hpp"

#include <algorithm>

#include "core/diagram/annotation.hpp"
#include "core/diagram/edit_text.hpp"
#include "core/syntax/printer.hpp"

namespace analogon {

namespace {

using syntax::Expression;

std::string pairText(Point p) { return "{" + syntax::printNumber(p.x) + "," + syntax::printNumber(p.y) + "}"; }

std::string cornersText(const Extent& e) { return "{" + pairText(e.p1) + "," + pairText(e.p2) + "}"; }

/// The list `graphics = {…}`; null: there is none yet.
const Expression* graphicsOf(const syntax::ClassDefinition& definition) {
    const syntax::Modification* layer = definition.annotation ? definition.annotation->find("Diagram") : nullptr;
    if (layer)
        for (const syntax::Modification& member : layer->arguments)
            if (member.name.text() == "graphics" && member.value) return &*member.value;
    return nullptr;
}

const syntax::NamedArgument* memberOf(const Expression& record, std::string_view name) {
    const auto found = std::find_if(record.named.begin(), record.named.end(),
                                    [&](const syntax::NamedArgument& a) { return a.name == name; });
    return found == record.named.end() ? nullptr : &*found;
}

Diagnostic notThere(const syntax::ClassDefinition& definition) {
    return error(phrase("the diagram of '{}' has no such text or picture any more", definition.name), definition.span,
                 phrase("Choose it again: the text of the model has changed since."));
}

/// Its place in the list.
std::optional<std::size_t> placeIn(const Expression* list, std::uint32_t begin) {
    if (!list || list->kind != Expression::Kind::Array) return std::nullopt;
    for (std::size_t i = 0; i < list->operands.size(); ++i)
        if (list->operands[i].span.begin == begin && list->operands[i].kind == Expression::Kind::Call) return i;
    return std::nullopt;
}

syntax::TextEdit editCalled(std::string what) {
    syntax::TextEdit edit;
    edit.what = std::move(what);
    return edit;
}

}  // namespace

std::vector<OwnGraphic> ownGraphics(const syntax::ClassDefinition& definition) {
    std::vector<OwnGraphic> own;
    const auto layer = annotation::find(definition.annotation, "Diagram");
    if (!layer) return own;
    std::vector<std::uint32_t> begins;
    std::vector<Primitive> primitives = annotation::primitives(*layer, &begins);
    for (std::size_t i = 0; i < primitives.size(); ++i) own.push_back({std::move(primitives[i]), begins[i]});
    return own;
}

std::string textRecord(const Extent& extent, const std::string& text) {
    return "Text(extent=" + cornersText(extent) + ", textString=" + syntax::printString(text) +
           ", horizontalAlignment=TextAlignment.Left)";
}

std::string pictureRecord(const Extent& extent, const std::string& base64) {
    return "Bitmap(extent=" + cornersText(extent) + ", imageSource=" + syntax::printString(base64) + ")";
}

Outcome<syntax::TextEdit> addGraphic(const syntax::ClassDefinition& definition, const std::string& record,
                                     std::string what) {
    if (!definition.endSpan.valid())
        return error(phrase("'{}' has no place for a text or a picture", definition.name), definition.span,
                     phrase("Write it as 'model {} extends …; end {};'.", definition.name, definition.name));
    syntax::TextEdit edit = editCalled(std::move(what));
    const Expression* list = graphicsOf(definition);
    if (list && list->kind != Expression::Kind::Array)
        return error(phrase("what the diagram of '{}' shows is not written as a list", definition.name), list->span,
                     phrase("Write it as 'graphics={{…}}'."));
    if (!list) {
        edit.replacements.push_back(
            edit_text::setClassAnnotation(definition, "Diagram", "graphics", "graphics={" + record + "}"));
    } else if (list->operands.empty()) {
        edit.replacements.push_back({list->span.begin, list->span.end, "{" + record + "}"});
    } else {
        const std::uint32_t end = list->operands.back().span.end;
        edit.replacements.push_back({end, end, ", " + record});
    }
    return edit;
}

Outcome<syntax::TextEdit> changeGraphic(const syntax::ClassDefinition& definition, std::uint32_t begin,
                                        const GraphicChange& change, std::string what) {
    const Expression* list = graphicsOf(definition);
    const std::optional<std::size_t> place = placeIn(list, begin);
    if (!place) return notThere(definition);
    const Expression& record = list->operands[*place];
    syntax::TextEdit edit = editCalled(std::move(what));
    std::string added;
    const auto set = [&](const char* name, const std::string& value) {
        if (const syntax::NamedArgument* known = memberOf(record, name))
            edit.replacements.push_back({known->value.span.begin, known->value.span.end, value});
        else
            added += ", " + std::string(name) + "=" + value;
    };
    if (change.extent) set("extent", cornersText(*change.extent));
    if (change.origin) set("origin", pairText(*change.origin));
    if (change.text) set(memberOf(record, "string") ? "string" : "textString", syntax::printString(*change.text));
    if (!added.empty()) {
        const std::uint32_t end = record.named.empty() ? record.span.end - 1 : record.named.back().span.end;
        edit.replacements.push_back({end, end, record.named.empty() ? added.substr(2) : added});
    }
    edit.normalise();
    return edit;
}

GraphicChange moved(const Primitive& primitive, double dx, double dy) {
    GraphicChange change;
    const bool hasOrigin = primitive.origin.x != 0 || primitive.origin.y != 0 || primitive.rotation != 0;
    if (hasOrigin) {
        change.origin = Point{primitive.origin.x + dx, primitive.origin.y + dy};
    } else {
        const auto [p1, p2] = primitive.extent;
        change.extent = Extent{{p1.x + dx, p1.y + dy}, {p2.x + dx, p2.y + dy}};
    }
    return change;
}

Outcome<syntax::TextEdit> removeGraphic(const syntax::ClassDefinition& definition, std::uint32_t begin,
                                        std::string what) {
    const Expression* list = graphicsOf(definition);
    const std::optional<std::size_t> place = placeIn(list, begin);
    if (!place) return notThere(definition);
    const std::vector<Expression>& all = list->operands;
    syntax::TextEdit edit = editCalled(std::move(what));
    if (*place + 1 < all.size())
        edit.replacements.push_back({all[*place].span.begin, all[*place + 1].span.begin, ""});
    else
        edit.replacements.push_back(
            {*place > 0 ? all[*place - 1].span.end : all[*place].span.begin, all[*place].span.end, ""});
    return edit;
}

}  // namespace analogon
