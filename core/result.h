// Errors as values.
//
// Functions that depend on input from outside (files, arguments, graphics driver) return Result<T>. A bug in the
// program's own code is an assertion.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace braitenlab {

// An error message: file, line, what is wrong and what to do.
struct Error {
    std::string what;    // what is wrong and what to do, one sentence without a full stop
    std::string file{};  // empty when the error is in no file
    int line = 0;        // 1-based; 0: unknown

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
