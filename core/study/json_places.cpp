#include "core/study/json_places.hpp"

#include <nlohmann/json.hpp>

namespace analogon {

namespace {

/// An object or array that is being read.
struct Level {
    std::string pointer;
    bool isArray{};
    int index{};
    std::string member;  // pointer of the value that comes next
};

class Scanner {
public:
    explicit Scanner(const Source& source) : source_(source), text_(source.text()) {}

    /// Calls found(pointer, name span, value span) for each value, inner before outer.
    template <class Found>
    void run(const Found& found) {
        std::vector<std::pair<Level, Begin>> stack;
        Begin pending;
        std::string pointer;
        while (skipBlanks()) {
            const char c = text_[at_];
            if (c == '{' || c == '[') {
                pending.value = at_++;
                stack.emplace_back(Level{pointer, c == '[', 0, pointer + "/0"}, pending);
                pointer = stack.back().first.member;
                pending = {};
            } else if (c == '}' || c == ']') {
                ++at_;
                if (stack.empty()) return;
                const auto [level, begin] = stack.back();
                stack.pop_back();
                found(level.pointer, span(begin.name, begin.nameEnd), span(begin.value, at_));
                pending = {};
            } else if (c == ',') {
                ++at_;
                if (!stack.empty() && stack.back().first.isArray)
                    pointer = stack.back().first.pointer + '/' + std::to_string(++stack.back().first.index);
            } else if (c == ':') {
                ++at_;
            } else {
                const std::uint32_t begin = at_;
                skipScalar();
                const bool isName = c == '"' && !stack.empty() && !stack.back().first.isArray && pending.nameEnd == 0;
                if (isName) {
                    pending = {begin, at_, 0};
                    pointer = stack.back().first.pointer + '/' + JsonPlaces::escape(unquoted(begin));
                } else {
                    found(pointer, span(pending.name, pending.nameEnd), span(begin, at_));
                    pending = {};
                }
            }
        }
    }

private:
    struct Begin {
        std::uint32_t name{}, nameEnd{}, value{};
    };

    Span span(std::uint32_t begin, std::uint32_t end) const { return end ? Span{&source_, begin, end} : Span{}; }

    bool skipBlanks() {
        while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos) ++at_;
        return at_ < text_.size();
    }

    void skipScalar() {
        if (text_[at_] == '"') {
            for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_)
                if (text_[at_] == '\\') ++at_;
            ++at_;
            return;
        }
        const std::uint32_t begin = at_;
        while (at_ < text_.size() && std::string_view(",:]} \t\r\n").find(text_[at_]) == std::string_view::npos) ++at_;
        if (at_ == begin) ++at_;
    }

    std::string unquoted(std::uint32_t begin) const {
        const auto value = nlohmann::json::parse(text_.substr(begin, at_ - begin), nullptr, false);
        return value.is_string() ? value.get<std::string>() : std::string();
    }

    const Source& source_;
    std::string_view text_;
    std::uint32_t at_{};
};

}  // namespace

JsonPlaces::JsonPlaces(SourcePtr source) : source_(std::move(source)) {
    Scanner(*source_).run([this](const std::string& pointer, Span name, Span value) {
        const auto [place, isNew] = places_.try_emplace(pointer, Place{name, value});
        if (!isNew && name.valid()) duplicates_.push_back(name);
    });
}

Span JsonPlaces::value(std::string_view pointer) const {
    while (true) {
        if (const auto place = places_.find(pointer); place != places_.end()) return place->second.value;
        if (pointer.empty()) return {};
        pointer = pointer.substr(0, pointer.rfind('/'));
    }
}

Span JsonPlaces::name(std::string_view pointer) const {
    const auto place = places_.find(pointer);
    return place == places_.end() ? Span{} : place->second.name;
}

std::string JsonPlaces::escape(std::string_view token) {
    std::string out;
    for (const char c : token) {
        if (c == '~') {
            out += "~0";
        } else if (c == '/') {
            out += "~1";
        } else {
            out += c;
        }
    }
    return out;
}

}  // namespace analogon
