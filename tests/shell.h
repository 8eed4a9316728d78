// Runs a command: its output and exit code.
#pragma once

#include <cstdio>
#include <string>

#include <sys/wait.h>

namespace braitenlab::tests {

struct Ran {
    int code = -1;
    std::string out;  // standard output and errors
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

}  // namespace braitenlab::tests
