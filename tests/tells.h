// Errors compared by their messages, whatever the words.
#pragma once

#include <algorithm>

#include <gtest/gtest.h>

#include "core/messages.h"

namespace braitenlab::tests {

// True if the message, with these values, is one of the error's parts.
inline testing::AssertionResult tells(const Error& error, const Message& message) {
    const auto& parts = error.phrases;
    if (std::find(parts.begin(), parts.end(), message.phrases.front()) != parts.end())
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << "not “" << message.text << "” but: " << error.text();
}

}  // namespace braitenlab::tests
