// Errors as values.
//
// Functions that depend on input from outside (files, arguments, graphics driver) return Result<T>. A bug in the
// program's own code is an assertion.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace braitenlab {

// A part of a message: the id of its text in core/messages.h and the values of its {}. Without an id the first value is
// an English text that has no translation.
struct Phrase {
    std::string_view id;
    std::vector<std::string> values{};
    friend bool operator==(const Phrase&, const Phrase&) = default;
};

// An error message: file, line, what is wrong and what to do.
struct Error {
    std::string what;               // what is wrong and what to do, one sentence without a full stop, in English
    std::string file{};             // empty when the error is in no file
    int line = 0;                   // 1-based; 0: unknown
    std::vector<Phrase> phrases{};  // the parts of `what`, for its translation; empty: it has none
    friend bool operator==(const Error&, const Error&) = default;

    // "file:line: what", without the parts that are unknown.
    std::string text() const {
        std::string where = file;
        if (!where.empty() && line > 0) where += ":" + std::to_string(line);
        return where.empty() ? what : where + ": " + what;
    }
};

// A value of type T, or an Error.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::move(value)) {}
    Result(Error error) : content_(std::move(error)) {}

    explicit operator bool() const { return std::holds_alternative<T>(content_); }

    // Precondition of the first four: *this holds a value; of error(): it does not. Otherwise std::bad_variant_access.
    T& operator*() { return std::get<T>(content_); }
    const T& operator*() const { return std::get<T>(content_); }
    T* operator->() { return &**this; }
    const T* operator->() const { return &**this; }
    const Error& error() const { return std::get<Error>(content_); }

private:
    std::variant<T, Error> content_;
};

}  // namespace braitenlab
