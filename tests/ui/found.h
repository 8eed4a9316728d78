// What a test finds among requests.
#pragma once

#include <cstddef>
#include <vector>

namespace braitenlab::tests {

// A list whose missing elements fail the test: reading them throws std::out_of_range.
template <class T>
struct Found : std::vector<T> {
    using std::vector<T>::vector;
    const T& front() const { return this->at(0); }
    const T& back() const { return this->at(this->size() - 1); }
    const T& operator[](std::size_t i) const { return this->at(i); }
};

}  // namespace braitenlab::tests
