// An X display of its own (Xvfb), from construction to destruction. It ends with the process that has started it.
#pragma once

#include <csignal>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace braitenlab::tests {

class XServer {
public:
    explicit XServer(const std::string& size = "1920x1200") {
        int ends[2];
        if (pipe(ends) != 0) return;
        server_ = fork();
        if (server_ == 0) run(ends, size + "x24");
        close(ends[1]);
        // The display's number, once the server accepts clients. The server writes the newline separately and ends if
        // it cannot, so read up to it.
        for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) display_ += c;
        close(ends[0]);
        EXPECT_NE(display_, ":") << "Xvfb does not start; install the package xvfb";
    }
    ~XServer() { end(); }
    XServer(const XServer&) = delete;
    XServer& operator=(const XServer&) = delete;

    const std::string& display() const { return display_; }  // ":7"

    void end() {
        if (server_ <= 0) return;
        kill(server_, SIGTERM);
        waitpid(server_, nullptr, 0);
        server_ = -1;
    }

private:
    [[noreturn]] static void run(const int (&ends)[2], const std::string& screen) {
        prctl(PR_SET_PDEATHSIG, SIGTERM);
        close(ends[0]);
        const std::string descriptor = std::to_string(ends[1]);
        execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", screen.c_str(), "-nolisten", "tcp",
               "-noreset", "-audit", "0", static_cast<char*>(nullptr));
        _exit(127);
    }

    pid_t server_ = -1;
    std::string display_ = ":";
};

}  // namespace braitenlab::tests
