#include "core/measure/mdf/mdf4_blocks.hpp"

#include <QXmlStreamReader>

#include "core/measure/encoding.hpp"

namespace analogon::mdf {

namespace {

constexpr std::uint64_t headBytes = 24;  // id, length, number of links
constexpr std::size_t textLimit = 1 << 20;

std::string trimmed(std::string text) {
    const auto first = text.find_first_not_of(" \t\r\n");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

}  // namespace

std::string_view Blocks4::idAt(std::uint64_t address) const {
    if (address == 0 || !file_.has(address, headBytes)) return {};
    const std::string_view head = file_.part(address, 4).text();
    return head.substr(0, 2) == "##" ? head.substr(2) : std::string_view();
}

std::optional<Block4> Blocks4::block(std::uint64_t address, std::string_view id) {
    if (idAt(address) != id) return std::nullopt;
    const auto length = file_.little<std::uint64_t>(address + 8);
    const auto links = file_.little<std::uint64_t>(address + 16);
    const ByteView body = file_.part(address + headBytes, std::max(length, headBytes) - headBytes);
    if (links > body.size() / 8) return std::nullopt;
    known_.insert(address);
    Block4 found{body.part(0, links * 8), body.part(links * 8)};
    found.isCut = length > file_.size() - address;
    return found;
}

std::string Blocks4::text(std::uint64_t address) {
    const bool isXml = idAt(address) == "MD";
    const std::optional<Block4> found = block(address, isXml ? "MD" : "TX");
    if (!found) {
        hasLostText_ = hasLostText_ || address != 0;
        return {};
    }
    const std::string_view raw = found->data.part(0, textLimit).terminatedText();
    std::string text = inUtf8(raw);
    return isXml ? commentText(text) : text;
}

std::string Blocks4::unit(std::uint64_t address) { return trimmed(text(address)); }

std::uint64_t Blocks4::nextBehind(std::uint64_t address) const {
    const auto next = known_.upper_bound(address);
    return next == known_.end() ? file_.size() : *next;
}

std::string commentText(std::string_view xml) {
    QXmlStreamReader reader(QByteArray(xml.data(), static_cast<qsizetype>(xml.size())));
    while (!reader.atEnd())
        if (reader.readNext() == QXmlStreamReader::StartElement && reader.name() == QLatin1String("TX"))
            return trimmed(reader.readElementText(QXmlStreamReader::IncludeChildElements).toStdString());
    return {};
}

}  // namespace analogon::mdf
