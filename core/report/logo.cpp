#include "core/report/logo.hpp"

#include <string_view>

#include "core/base/regular_file.hpp"

namespace analogon {

namespace {

/// Media type; empty: none of those that every browser shows.
std::string_view mediaType(std::string_view bytes) {
    if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return "image/png";
    if (bytes.starts_with("\xff\xd8\xff")) return "image/jpeg";
    if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);  // mark of UTF-8
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    const bool isMarkup = first != std::string_view::npos && bytes[first] == '<';
    if (isMarkup && bytes.find("<svg") != std::string_view::npos) return "image/svg+xml";
    return {};
}

/// RFC 4648, section 4.
std::string base64(std::string_view bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) out += k <= count ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

}  // namespace

Outcome<std::string> logoUri(const std::filesystem::path& file, const std::string& shown) {
    const Outcome<std::string> bytes = readRegularFile(file);
    if (!bytes) {
        Diagnostic fault = bytes.diagnostics().front();
        fault.place.file = shown;
        return fault;
    }
    if (bytes->size() > largestLogo)
        return fileError(
            phrase("the logo has {} kB, and a report carries up to {}", bytes->size() / 1024, largestLogo / 1024),
            shown, 0, 0, phrase("Save it smaller: a logo is shown 64 pixels high."));
    const std::string_view type = mediaType(*bytes);
    if (type.empty())
        return fileError(phrase("the logo is neither PNG, JPEG nor SVG"), shown, 0, 0,
                         phrase("Save it in one of these formats."));
    return "data:" + std::string(type) + ";base64," + base64(*bytes);
}

}  // namespace analogon
