#pragma once

#include <cassert>
#include <optional>
#include <utility>

#include "core/base/diagnostic.hpp"

namespace analogon {

/// A value, or the reasons why there is none. Warnings may come along with a value.
template <class T>
class [[nodiscard]] Outcome {
public:
    Outcome(T value) : value_(std::move(value)) {}
    Outcome(T value, Diagnostics warnings) : value_(std::move(value)), diagnostics_(std::move(warnings)) {}
    Outcome(Diagnostic fault) { diagnostics_.push_back(std::move(fault)); }
    Outcome(Diagnostics faults) : diagnostics_(std::move(faults)) { assert(!diagnostics_.empty()); }

    bool hasValue() const { return value_.has_value(); }
    explicit operator bool() const { return hasValue(); }

    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(value()); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

    T& value() & {
        assert(value_);
        return *value_;
    }
    const T& value() const& {
        assert(value_);
        return *value_;
    }
    T&& value() && {
        assert(value_);
        return std::move(*value_);
    }

    /// The faults when there is no value, the warnings when there is one.
    const Diagnostics& diagnostics() const { return diagnostics_; }

private:
    std::optional<T> value_;
    Diagnostics diagnostics_;
};

/// For work that yields nothing but may fail.
struct Done {};

}  // namespace analogon
