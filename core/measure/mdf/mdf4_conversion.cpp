#include "core/measure/mdf/mdf4_conversion.hpp"

namespace analogon::mdf {

namespace {

constexpr int deepest = 8;
constexpr unsigned cutShort = 256;           // in place of a type: values or texts are missing
constexpr std::uint64_t firstReference = 4;  // behind name, unit, comment, inverse
constexpr std::uint64_t firstValue = 24;

std::uint64_t referenceCount(const Block4& block) {
    const std::uint64_t there = block.linkCount() - std::min(block.linkCount(), firstReference);
    return std::min<std::uint64_t>(block.data.little<std::uint16_t>(4), there);
}

std::vector<double> valuesOf(const Block4& block) {
    const std::uint64_t there = (block.data.size() - std::min<std::uint64_t>(block.data.size(), firstValue)) / 8;
    const std::uint64_t count = std::min<std::uint64_t>(block.data.little<std::uint16_t>(6), there);
    std::vector<double> values(count);
    for (std::uint64_t i = 0; i < count; ++i) values[i] = block.data.little<double>(firstValue + 8 * i);
    return values;
}

void setRanges(Conversion& conversion, bool isInteger) {
    const std::vector<double> values = std::move(conversion.numbers);
    conversion.numbers.clear();
    conversion.includesUpper = isInteger;
    for (std::size_t i = 0; i + 2 < values.size(); i += 3)
        conversion.entries.push_back({values[i], values[i + 1], values[i + 2], {}, {}});
    if (values.size() % 3 == 1) conversion.fallback = Conversion::Entry{0, 0, values.back(), {}, {}};
}

/// So many numbers a kind needs; without them it cannot be applied.
void requireNumbers(Conversion& conversion, std::size_t count) {
    if (conversion.numbers.size() >= count) return;
    conversion.kind = Conversion::Kind::Unreadable;
    conversion.unreadable = "?";
}

}  // namespace

Conversions4::Pointer Conversions4::read(std::uint64_t address, bool isInteger, int depth) {
    if (address == 0) return nullptr;
    const auto [entry, isNew] = known_.try_emplace({address, isInteger});
    if (!isNew) return entry->second;  // null while it is being read: a conversion that refers to itself
    auto conversion = std::make_shared<Conversion>();
    const std::optional<Block4> block = depth < deepest ? blocks_.block(address, "CC") : std::nullopt;
    if (!block) {
        conversion->kind = Conversion::Kind::Unreadable;
        conversion->unreadable = "?";
    } else {
        conversion->unit = blocks_.unit(block->link(1));
        conversion->numbers = valuesOf(*block);
        const bool isWhole = conversion->numbers.size() == block->data.little<std::uint16_t>(6) &&
                             referenceCount(*block) == block->data.little<std::uint16_t>(4);
        switch (const unsigned type = isWhole ? block->data.little<std::uint8_t>(0) : cutShort) {
            case cutShort:
                conversion->kind = Conversion::Kind::Unreadable;
                conversion->unreadable = "?";
                break;
            case 0:
                break;
            case 1:
                conversion->kind = Conversion::Kind::Linear;
                requireNumbers(*conversion, 2);
                break;
            case 2:
                conversion->kind = Conversion::Kind::Rational;
                requireNumbers(*conversion, 6);
                break;
            case 3: {
                const std::string text = blocks_.text(block->link(firstReference));
                conversion->formula = Formula::parse(text);
                conversion->kind = conversion->formula ? Conversion::Kind::Formula : Conversion::Kind::Unreadable;
                conversion->unreadable = text;
                break;
            }
            case 4:
            case 5:
                conversion->kind = type == 4 ? Conversion::Kind::Interpolated : Conversion::Kind::Nearest;
                requireNumbers(*conversion, 2);
                break;
            case 6:
                conversion->kind = Conversion::Kind::Ranges;
                setRanges(*conversion, isInteger);
                break;
            case 7:
            case 8:
                readTexts(*block, *conversion, isInteger, depth);
                break;
            case 9:
                readFromText(*block, *conversion);
                break;
            default:
                conversion->kind = Conversion::Kind::Unreadable;
                conversion->unreadable = "cc_type " + std::to_string(type);
        }
    }
    return known_[{address, isInteger}] = conversion;
}

void Conversions4::readTexts(const Block4& block, Conversion& conversion, bool isInteger, int depth) {
    const std::vector<double> values = std::move(conversion.numbers);
    conversion.numbers.clear();
    conversion.kind = Conversion::Kind::Texts;
    conversion.includesUpper = isInteger;
    const bool isRange = block.data.little<std::uint8_t>(0) == 8;
    const std::uint64_t references = referenceCount(block);
    for (std::uint64_t i = 0; i < references; ++i) {
        Conversion::Entry entry;
        const std::uint64_t address = block.link(firstReference + i);
        if (blocks_.idAt(address) == "CC") {
            entry.nested = read(address, isInteger, depth + 1);
            if (!entry.nested) {  // it refers to itself
                conversion.kind = Conversion::Kind::Unreadable;
                conversion.unreadable = "?";
                return;
            }
        } else
            entry.text = blocks_.text(address).substr(0, 1000);
        const std::size_t at = isRange ? 2 * i : i;
        if (at + (isRange ? 1 : 0) < values.size()) {
            entry.lower = values[at];
            entry.upper = values[isRange ? at + 1 : at];
            conversion.entries.push_back(std::move(entry));
        } else {
            // the one behind the last value is for all others; a link of 0 there says nothing about them
            if (address != 0) conversion.fallback = std::move(entry);
            break;
        }
    }
}

void Conversions4::readFromText(const Block4& block, Conversion& conversion) {
    const std::vector<double> values = std::move(conversion.numbers);
    conversion.numbers.clear();
    conversion.kind = Conversion::Kind::FromText;
    const std::uint64_t references = std::min<std::uint64_t>(referenceCount(block), values.size());
    for (std::uint64_t i = 0; i < references; ++i)
        conversion.entries.push_back({0, 0, values[i], blocks_.text(block.link(firstReference + i)), {}});
    if (values.size() > references) conversion.fallback = Conversion::Entry{0, 0, values[references], {}, {}};
}

}  // namespace analogon::mdf
