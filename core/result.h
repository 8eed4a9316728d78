// What can go wrong outside our control, as a value.
//
// Anything that comes from outside (files, arguments, a graphics driver) returns Result<T>; a bug in our own code asserts.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace braitenlab {

// One problem, told to a person: where it is, what is wrong, and what to do about it.
struct Error {
    std::string what;    // what is wrong and what to do, one sentence without a full stop
    std::string file{};  // empty when the problem is in no file
    int line = 0;        // 1-based; 0 when no line is to blame

    // "file:line: what", leaving out the parts that are not known.
    std::string text() const {
        std::string where = file;
        if (!where.empty() && line > 0) where += ":" + std::to_string(line);
        return where.empty() ? what : where + ": " + what;
    }
};

// A T, or the Error that kept us from making one.
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
