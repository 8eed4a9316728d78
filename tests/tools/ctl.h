// Runs braitenctl: its output and exit code.
#pragma once

#include <cstdio>
#include <filesystem>
#include <set>
#include <string>

#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

namespace braitenlab::tests::ctl_runs {

using Json = nlohmann::json;

// A file name for this process: tests run in parallel.
inline std::string scratch(const std::string& name) {
    const std::string own = "braitenctl-test-" + std::to_string(getpid()) + "-" + name;
    return (std::filesystem::temp_directory_path() / own).string();
}

struct Ran {
    int code = -1;
    std::string out;
};
inline Ran shell(const std::string& command) {
    Ran ran;
    FILE* pipe = popen(("{ " + command + "; } 2>&1").c_str(), "r");
    char buffer[4096];
    for (std::size_t n = 0; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) ran.out.append(buffer, n);
    ran.code = WEXITSTATUS(pclose(pipe));
    return ran;
}
inline Ran ctl(const std::string& arguments) { return shell(BRAITENLAB_BINARY "/braitenctl " + arguments); }

inline std::set<std::string> keys(const Json& object) {
    std::set<std::string> all;
    for (const auto& item : object.items()) all.insert(item.key());
    return all;
}

}  // namespace braitenlab::tests::ctl_runs
