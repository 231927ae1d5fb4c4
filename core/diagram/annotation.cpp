#include "core/diagram/annotation.hpp"

#include <filesystem>

namespace analogon::annotation {

using syntax::Expression;
using syntax::Modification;

namespace {

/// `DynamicSelect(static, dynamic)` shows its static value in an editor.
const Expression& staticValue(const Expression& expression) {
    if (expression.kind == Expression::Kind::Call && expression.name.text() == "DynamicSelect" &&
        !expression.operands.empty())
        return staticValue(expression.operands.front());
    return expression;
}

const Modification* argument(const Modification& modification, std::string_view name) {
    for (const Modification& a : modification.arguments)
        if (a.name.parts.size() == 1 && a.name.parts.front().identifier == name) return &a;
    return nullptr;
}

}  // namespace

std::optional<double> number(const Expression& raw) {
    const Expression& expression = staticValue(raw);
    if (expression.kind == Expression::Kind::Number) return expression.number;
    if (expression.kind == Expression::Kind::Unary && expression.operands.size() == 1)
        if (const auto value = number(expression.operands.front())) {
            if (expression.text == "-") return -*value;
            if (expression.text == "+") return *value;
        }
    return std::nullopt;
}

std::optional<Point> point(const Expression& raw) {
    const Expression& expression = staticValue(raw);
    if (expression.kind != Expression::Kind::Array || expression.operands.size() != 2) return std::nullopt;
    const auto x = number(expression.operands[0]);
    const auto y = number(expression.operands[1]);
    if (!x || !y) return std::nullopt;
    return Point{*x, *y};
}

std::string_view literal(const Expression& raw) {
    const Expression& expression = staticValue(raw);
    if (expression.kind != Expression::Kind::Reference || expression.name.parts.empty()) return {};
    return expression.name.parts.back().identifier;
}

std::string_view Record::name() const {
    const auto& parts = modification_ ? modification_->name.parts : call_->name.parts;
    return parts.empty() ? std::string_view{} : std::string_view(parts.back().identifier);
}

const Expression* Record::value(std::string_view member) const {
    if (modification_) {
        const Modification* a = argument(*modification_, member);
        return a && a->value ? &staticValue(*a->value) : nullptr;
    }
    for (const syntax::NamedArgument& a : call_->named)
        if (a.name == member) return &staticValue(a.value);
    return nullptr;
}

std::optional<Record> Record::record(std::string_view member) const {
    if (modification_) {
        if (const Modification* a = argument(*modification_, member)) return Record(*a);
        return std::nullopt;
    }
    for (const Expression& operand : call_->operands)
        if (operand.kind == Expression::Kind::Call && Record(operand).name() == member) return Record(operand);
    return std::nullopt;
}

std::optional<double> Record::number(std::string_view member) const {
    const Expression* e = value(member);
    return e ? annotation::number(*e) : std::nullopt;
}

std::optional<bool> Record::boolean(std::string_view member) const {
    const Expression* e = value(member);
    if (!e || e->kind != Expression::Kind::Boolean) return std::nullopt;
    return e->number != 0;
}

std::optional<std::string> Record::string(std::string_view member) const {
    const Expression* e = value(member);
    if (!e || e->kind != Expression::Kind::String) return std::nullopt;
    return e->text;
}

std::optional<Point> Record::point(std::string_view member) const {
    const Expression* e = value(member);
    return e ? annotation::point(*e) : std::nullopt;
}

std::optional<Extent> Record::extent(std::string_view member) const {
    const std::vector<Point> corners = points(member);
    if (corners.size() != 2) return std::nullopt;
    return Extent{corners[0], corners[1]};
}

std::optional<Colour> Record::colour(std::string_view member) const {
    const Expression* e = value(member);
    if (!e || e->kind != Expression::Kind::Array || e->operands.size() != 3) return std::nullopt;
    const auto r = annotation::number(e->operands[0]);
    const auto g = annotation::number(e->operands[1]);
    const auto b = annotation::number(e->operands[2]);
    if (!r || !g || !b) return std::nullopt;
    return Colour{static_cast<int>(*r), static_cast<int>(*g), static_cast<int>(*b)};
}

std::vector<Point> Record::points(std::string_view member) const {
    std::vector<Point> result;
    const Expression* e = value(member);
    if (!e || e->kind != Expression::Kind::Array) return result;
    for (const Expression& operand : e->operands)
        if (const auto p = annotation::point(operand)) result.push_back(*p);
    return result;
}

std::string_view Record::literal(std::string_view member) const {
    const Expression* e = value(member);
    return e ? annotation::literal(*e) : std::string_view{};
}

std::optional<Record> find(const std::optional<syntax::Annotation>& annotation, std::string_view name) {
    if (!annotation) return std::nullopt;
    const Modification* found = annotation->find(name);
    if (!found) return std::nullopt;
    return Record(*found);
}

std::optional<Placement> placement(const std::optional<syntax::Annotation>& annotation, bool asIcon) {
    const auto record = find(annotation, "Placement");
    if (!record) return std::nullopt;
    std::optional<Record> transformation;
    if (asIcon) transformation = record->record("iconTransformation");
    if (!transformation) transformation = record->record("transformation");
    if (!transformation) return std::nullopt;
    Placement result;
    if (const auto extent = transformation->extent("extent")) result.extent = *extent;
    if (const auto origin = transformation->point("origin")) result.origin = *origin;
    if (const auto rotation = transformation->number("rotation")) result.rotation = *rotation;
    return result;
}

namespace {

std::optional<Primitive::Kind> kindOf(std::string_view name) {
    using Kind = Primitive::Kind;
    if (name == "Line") return Kind::Line;
    if (name == "Rectangle") return Kind::Rectangle;
    if (name == "Polygon") return Kind::Polygon;
    if (name == "Ellipse") return Kind::Ellipse;
    if (name == "Text") return Kind::Text;
    if (name == "Bitmap") return Kind::Bitmap;
    return std::nullopt;
}

void readFill(const Record& record, Primitive& p) {
    const std::string_view pattern = record.literal("fillPattern");
    p.filled = !pattern.empty() && pattern != "None";
    if (pattern == "HorizontalCylinder") p.gradient = Gradient::HorizontalCylinder;
    if (pattern == "VerticalCylinder") p.gradient = Gradient::VerticalCylinder;
    if (pattern == "Sphere") p.gradient = Gradient::Sphere;
    p.fill = record.colour("fillColor").value_or(Colour{0, 0, 0});
}

void readPen(const Record& record, Primitive& p) {
    const std::string_view pattern = record.literal("pattern");
    p.outlined = pattern != "None";
    p.dashed = !pattern.empty() && pattern != "None" && pattern != "Solid";
    const bool isLine = p.kind == Primitive::Kind::Line;
    p.line = record.colour(isLine ? "color" : "lineColor").value_or(Colour{0, 0, 0});
    p.thickness = record.number(isLine ? "thickness" : "lineThickness").value_or(0.25);
    p.smooth = record.literal("smooth") == "Bezier";
}

void readText(const Record& record, Primitive& p) {
    p.text = record.string("textString").value_or(record.string("string").value_or(""));
    p.line = record.colour("textColor").value_or(p.line);
    p.fontSize = record.number("fontSize").value_or(0);
    const std::string_view alignment = record.literal("horizontalAlignment");
    p.alignment = alignment == "Left" ? -1 : alignment == "Right" ? 1 : 0;
    if (const Expression* style = record.value("textStyle"))
        for (const Expression& one : style->operands)
            if (literal(one) == "Bold") p.bold = true;
}

const std::string pictureInText = "data:";  // no name of a file begins so: those are whole paths

/// A picture file of the package that the text belongs to, or beside a text that is in none; empty: it lies elsewhere.
std::string pictureFile(std::string name, const Span& span) {
    namespace fs = std::filesystem;
    constexpr std::string_view scheme = "modelica://";
    if (name.empty() || !span.source) return {};
    std::error_code none;
    fs::path root = fs::absolute(span.source->name(), none).lexically_normal().parent_path();
    if (name.starts_with(scheme)) {
        while (root.has_relative_path() && fs::exists(root.parent_path() / "package.mo", none))
            root = root.parent_path();
        const auto end = name.find('/', scheme.size());
        if (end == std::string::npos) return {};
        name = name.substr(end + 1);
    }
    const fs::path inside = fs::path(name).lexically_normal();
    if (inside.is_absolute() || *inside.begin() == "..") return {};
    return (root / inside).string();
}

void readArrows(const Record& record, Primitive& p) {
    const Expression* arrows = record.value("arrow");
    if (!arrows || arrows->operands.size() != 2) return;
    const auto isDrawn = [](std::string_view name) { return !name.empty() && name != "None"; };
    p.arrowAtStart = isDrawn(literal(arrows->operands[0]));
    p.arrowAtEnd = isDrawn(literal(arrows->operands[1]));
}

Primitive readPrimitive(const Record& record, Primitive::Kind kind) {
    Primitive p;
    p.kind = kind;
    p.origin = record.point("origin").value_or(Point{});
    p.rotation = record.number("rotation").value_or(0);
    p.points = record.points("points");
    p.extent = record.extent("extent").value_or(Extent{});
    p.radius = record.number("radius").value_or(0);
    p.startAngle = record.number("startAngle").value_or(0);
    p.endAngle = record.number("endAngle").value_or(360);
    readPen(record, p);
    readFill(record, p);
    if (kind == Primitive::Kind::Line) readArrows(record, p);
    if (kind == Primitive::Kind::Text) readText(record, p);
    return p;
}

}  // namespace

std::string_view pictureBytes(const Primitive& picture) {
    const std::string_view text = picture.text;
    return text.starts_with(pictureInText) ? text.substr(pictureInText.size()) : std::string_view();
}

std::string pictureFile(const Primitive& picture) {
    return pictureBytes(picture).empty() ? picture.text : std::string();
}

std::vector<Primitive> primitives(const Record& layer, std::vector<std::uint32_t>* begins) {
    std::vector<Primitive> result;
    const Expression* graphics = layer.value("graphics");
    if (!graphics || graphics->kind != Expression::Kind::Array) return result;
    for (const Expression& item : graphics->operands) {
        if (item.kind != Expression::Kind::Call) continue;
        const Record record(item);
        const auto kind = kindOf(record.name());
        if (!kind || record.boolean("visible") == false) continue;
        result.push_back(readPrimitive(record, *kind));
        if (begins) begins->push_back(item.span.begin);
        if (kind != Primitive::Kind::Bitmap) continue;
        const std::string bytes = record.string("imageSource").value_or("");
        result.back().text =
            bytes.empty() ? pictureFile(record.string("fileName").value_or(""), item.span) : pictureInText + bytes;
    }
    return result;
}

}  // namespace analogon::annotation
