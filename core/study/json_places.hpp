#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/source.hpp"

namespace analogon {

/// Where the members of a JSON text stand, by JSON pointer (RFC 6901): "/experiments/0/file". The text must be
/// valid JSON.
class JsonPlaces {
public:
    explicit JsonPlaces(SourcePtr source);

    /// The value; of the nearest enclosing one when there is none at this pointer.
    Span value(std::string_view pointer) const;
    /// The name of a member; invalid for elements of arrays and unknown pointers.
    Span name(std::string_view pointer) const;
    /// Names that stand twice in their object.
    const std::vector<Span>& duplicates() const { return duplicates_; }
    const SourcePtr& source() const { return source_; }

    /// One reference token with ~ and / escaped.
    static std::string escape(std::string_view token);

private:
    struct Place {
        Span name, value;
    };

    SourcePtr source_;
    std::map<std::string, Place, std::less<>> places_;
    std::vector<Span> duplicates_;
};

}  // namespace analogon
