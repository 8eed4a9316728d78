// What tests of braitenctl share: file names, refusals, keys of JSON.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/io/checked_json.h"
#include "tests/shell.h"

namespace braitenlab::tests::ctl_runs {

using Json = nlohmann::json;

// A file name for this process: tests run in parallel.
inline std::string scratch(const std::string& name) {
    const std::string own = "braitenctl-test-" + std::to_string(getpid()) + "-" + name;
    return (std::filesystem::temp_directory_path() / own).string();
}

// Expects that braitenctl refuses these arguments with a message that contains `words`.
inline void expect_refused(const std::string& arguments, const std::string& words) {
    const Ran ran = ctl(arguments);
    EXPECT_EQ(ran.code, 2) << arguments;
    EXPECT_NE(ran.out.find(words), std::string::npos) << arguments << ": " << ran.out;
}

inline std::set<std::string> keys(const Json& object) {
    std::set<std::string> all;
    for (const auto& item : object.items()) all.insert(item.key());
    return all;
}

}  // namespace braitenlab::tests::ctl_runs
