#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace analogon {

/// Where the bytes of a long text come from while it is read from its front to its end. Its place in memory is there
/// from the beginning; what was not loaded, and what was let go, must not be looked at.
class TextSupply {
public:
    virtual ~TextSupply() = default;
    /// Up to where the text is loaded.
    virtual const char* loaded() const = 0;
    /// Loads more of it; there is more.
    virtual void loadMore() = 0;
    /// The memory of this part is given back.
    virtual void letGo(const char* begin, const char* end) = 0;
    /// From here on, and for what is loaded already, whole lines are changed by `change` before anybody sees them;
    /// their length stays.
    virtual void changeLines(std::function<void(char* begin, char* end)> change) = 0;
};

/// A text that may be loaded while it is read; without a supply it is all there.
struct TextView {
    std::string_view text;
    TextSupply* supply{};

    TextView(std::string_view whole, TextSupply* from = nullptr) : text(whole), supply(from) {}
    TextView(const char* whole) : text(whole) {}
    template <class String>
    requires std::convertible_to<const String&, std::string_view> TextView(const String& whole) : text(whole) {}

    TextView from(std::size_t offset) const { return {text.substr(offset), supply}; }
    /// The front of it, loaded.
    std::string_view front(std::size_t most) const {
        const std::string_view wanted = text.substr(0, most);
        while (supply && supply->loaded() < wanted.data() + wanted.size()) supply->loadMore();
        return wanted;
    }
    /// With its lines changed, their length stays: one with a supply where it is, as it is loaded; of another one
    /// `store` holds the changed copy.
    TextView withLines(std::function<void(char* begin, char* end)> change, std::string& store) const {
        if (supply) {
            supply->changeLines(std::move(change));
            return *this;
        }
        store = text;
        change(store.data(), store.data() + store.size());
        return std::string_view(store);
    }
};

}  // namespace analogon
