// A lab with a shipped scene or exercise, for tests.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "app/files/data.h"
#include "app/lab.h"

namespace braitenlab::tests {

inline Lab opened_lab(const std::string& name) {
    const auto path = find_shipped(name);
    EXPECT_TRUE(path) << name;
    auto lab = open_lab(*path, std::nullopt, {});
    EXPECT_TRUE(lab) << lab.error().text();
    return std::move(*lab);
}

}  // namespace braitenlab::tests
