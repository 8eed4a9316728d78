// What tests of braitenctl share: file names, keys of JSON.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include "tests/shell.h"

namespace braitenlab::tests::ctl_runs {

using Json = nlohmann::json;

// A file name for this process: tests run in parallel.
inline std::string scratch(const std::string& name) {
    const std::string own = "braitenctl-test-" + std::to_string(getpid()) + "-" + name;
    return (std::filesystem::temp_directory_path() / own).string();
}

inline std::set<std::string> keys(const Json& object) {
    std::set<std::string> all;
    for (const auto& item : object.items()) all.insert(item.key());
    return all;
}

}  // namespace braitenlab::tests::ctl_runs
