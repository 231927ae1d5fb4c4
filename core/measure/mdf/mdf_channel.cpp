#include "core/measure/mdf/mdf_channel.hpp"

namespace analogon::mdf {

namespace {

std::string otherwise(const Conversion& conversion) { return conversion.fallback ? conversion.fallback->text : ""; }

}  // namespace

void describeByConversion(const StoredChannel& stored, RecordedChannel& channel, std::vector<Text>& notes) {
    const bool isNumber = stored.storage == StoredChannel::Storage::Counted ||
                          (stored.storage == StoredChannel::Storage::InRecord && stored.layout.isNumber());
    channel.kind = isNumber ? ChannelKind::Number : ChannelKind::Text;
    channel.isInteger = isNumber && (stored.storage == StoredChannel::Storage::Counted || stored.layout.isInteger());
    const Conversion* conversion = stored.conversion.get();
    if (!conversion) return;
    if (channel.unit.empty()) channel.unit = conversion->unit;
    using Kind = Conversion::Kind;
    if (conversion->kind == Kind::FromText && !isNumber) channel.kind = ChannelKind::Number;
    if (conversion->kind == Kind::Unreadable)
        notes.push_back(
            phrase("channel \"{}\": its conversion \"{}\" cannot be read, its values are those of the record",
                   channel.name, conversion->unreadable));
    if (!isNumber) return;
    if (conversion->kind != Kind::Identity && conversion->kind != Kind::Texts) channel.isInteger = false;
    if (conversion->kind != Kind::Texts) return;
    for (const Conversion::Entry& entry : conversion->entries)
        if (!entry.nested) channel.statusTexts.push_back({entry.lower, entry.upper, entry.text});
    channel.otherStatus = otherwise(*conversion);
    if (conversion->givesTextsOnly()) {
        channel.kind = ChannelKind::Status;
        return;
    }
    channel.isInteger = false;
    if (channel.unit.empty() && conversion->fallback && conversion->fallback->nested)
        channel.unit = conversion->fallback->nested->unit;
    if (!channel.statusTexts.empty())
        notes.push_back(phrase("channel \"{}\": values that have a text in place of a number (such as \"{}\") are gaps",
                               channel.name, channel.statusTexts.front().text));
}

bool fitsItsRecord(const StoredChannel& stored, const RecordGroup& group, const std::string& name,
                   std::vector<Text>& notes) {
    if (stored.storage == StoredChannel::Storage::Counted) return true;
    if (!stored.layout.isPossible()) {
        notes.push_back(
            phrase("channel \"{}\" is left out: {} bits cannot be a value of its type", name, stored.layout.bits));
        return false;
    }
    const std::uint64_t needed = stored.layout.bytes();
    const bool isWithin = needed <= group.dataBytes && stored.layout.byteOffset <= group.dataBytes - needed;
    const bool hasBit = !stored.invalidationBit || *stored.invalidationBit / 8 < group.invalidationBytes;
    if (isWithin && hasBit) return true;
    notes.push_back(phrase("channel \"{}\" is left out: it lies outside its record", name));
    return false;
}

}  // namespace analogon::mdf
