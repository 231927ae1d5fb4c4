#include "core/measure/mdf/mdf3_conversion.hpp"

#include "core/measure/encoding.hpp"
#include "core/measure/mdf/value_layout.hpp"

namespace analogon::mdf {

namespace {

constexpr std::uint64_t firstValue = 46;

class ConversionReader {
public:
    ConversionReader(ByteView file, ByteView block, bool isBigEndian, bool isInteger)
        : file_(file), block_(block), isBigEndian_(isBigEndian), isInteger_(isInteger) {}

    std::shared_ptr<const Conversion> read() {
        using Kind = Conversion::Kind;
        conversion_.unit = text3(block_.part(22, 20));
        const auto type = number<std::uint16_t>(42);
        count_ = number<std::uint16_t>(44);
        switch (type) {
            case 0:
                values(Kind::Linear, 2);
                break;
            case 1:
                values(Kind::Interpolated, 2 * count_);
                break;
            case 2:
                values(Kind::Nearest, 2 * count_);
                break;
            case 6:
                values(Kind::Polynomial, 6);
                break;
            case 7:
                values(Kind::Exponential, 7);
                break;
            case 8:
                values(Kind::Logarithmic, 7);
                break;
            case 9:
                values(Kind::Rational, 6);
                break;
            case 10:
                formula();
                break;
            case 11:
                texts();
                break;
            case 12:
                ranges();
                break;
            case 65535:
                break;
            default:
                unreadable("conversion type " + std::to_string(type));
        }
        return std::make_shared<Conversion>(std::move(conversion_));
    }

private:
    template <class T>
    T number(std::uint64_t offset) const {
        return block_.number<T>(offset, isBigEndian_ == (std::endian::native == std::endian::little));
    }
    void unreadable(std::string what) {
        conversion_.kind = Conversion::Kind::Unreadable;
        conversion_.unreadable = std::move(what);
    }
    void values(Conversion::Kind kind, std::size_t count) {
        if (count == 0 || !block_.has(firstValue, 8 * std::uint64_t{count})) return unreadable("?");
        conversion_.kind = kind;
        for (std::size_t i = 0; i < count; ++i) conversion_.numbers.push_back(number<double>(firstValue + 8 * i));
    }
    void formula() {
        const std::string text = text3(block_.part(firstValue, 256));
        conversion_.formula = Formula::parse(text);
        if (!conversion_.formula) return unreadable(text);
        conversion_.kind = Conversion::Kind::Formula;
    }
    void texts() {
        conversion_.kind = Conversion::Kind::Texts;
        for (std::uint64_t i = 0; i < count_ && block_.has(firstValue + 40 * i, 40); ++i) {
            const auto value = number<double>(firstValue + 40 * i);
            conversion_.entries.push_back({value, value, 0, text3(block_.part(firstValue + 40 * i + 8, 32)), {}});
        }
    }
    /// The first is for all values outside the others.
    void ranges() {
        conversion_.kind = Conversion::Kind::Texts;
        conversion_.includesUpper = isInteger_;
        for (std::uint64_t i = 0; i < count_ && block_.has(firstValue + 20 * i, 20); ++i) {
            const std::uint64_t at = firstValue + 20 * i;
            Conversion::Entry entry{number<double>(at), number<double>(at + 8), 0, {}, {}};
            entry.text = textBlock3(file_, number<std::uint32_t>(at + 16), isBigEndian_).substr(0, 1000);
            if (i == 0)
                conversion_.fallback = std::move(entry);
            else
                conversion_.entries.push_back(std::move(entry));
        }
    }

    ByteView file_, block_;
    bool isBigEndian_, isInteger_;
    std::size_t count_{};
    Conversion conversion_;
};

}  // namespace

std::string text3(ByteView bytes) {
    std::string_view text = bytes.terminatedText();
    while (!text.empty() && (text.back() == ' ' || text.back() == '\r' || text.back() == '\n')) text.remove_suffix(1);
    return isUtf8(text) ? std::string(text) : windows1252ToUtf8(text);
}

std::string textBlock3(ByteView file, std::uint64_t address, bool isBigEndian) {
    if (address == 0 || file.part(address, 2).text() != "TX") return {};
    const auto length =
        file.number<std::uint16_t>(address + 2, isBigEndian == (std::endian::native == std::endian::little));
    return length < 4 ? std::string() : text3(file.part(address + 4, length - 4));
}

std::shared_ptr<const Conversion> readConversion3(ByteView file, ByteView block, bool isBigEndian, bool isInteger) {
    return ConversionReader(file, block, isBigEndian, isInteger).read();
}

}  // namespace analogon::mdf
