#pragma once

#include <ostream>
#include <streambuf>
#include <string>

#include "core/base/visible.hpp"

namespace analogon::cli {

/// Passes what is written on to another stream, line by line, with all that a terminal would obey escaped: names of
/// models and columns come from files of others.
class VisibleStream : public std::ostream {
public:
    explicit VisibleStream(std::ostream& to) : std::ostream(nullptr), buffer_(to) { rdbuf(&buffer_); }
    ~VisibleStream() override { flush(); }

private:
    class Buffer : public std::streambuf {
    public:
        explicit Buffer(std::ostream& to) : to_(to) {}

    private:
        int_type overflow(int_type c) override {
            if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
            line_ += traits_type::to_char_type(c);
            if (line_.back() == '\n') pass();
            return c;
        }
        int sync() override {
            pass();
            to_.flush();
            return 0;
        }
        void pass() {
            to_ << visible(line_);
            line_.clear();
        }

        std::ostream& to_;
        std::string line_;
    };

    Buffer buffer_;
};

}  // namespace analogon::cli
