// Gives each test process a separate X display (Xvfb), so that tests of the real window can run side by side: each
// has its own pointer, keyboard and input focus. BRAITENLAB_TEST_DISPLAY=:N uses an existing display instead.
#include <csignal>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace braitenlab::tests {
namespace {

class PrivateDisplay : public testing::Environment {
public:
    void SetUp() override {
        if (const char* display = std::getenv("BRAITENLAB_TEST_DISPLAY")) {
            setenv("DISPLAY", display, 1);
            return;
        }
        int ends[2];
        ASSERT_EQ(pipe(ends), 0);
        server_ = fork();
        if (server_ == 0) run_server(ends);
        close(ends[1]);
        // The display's number, once the server accepts clients. The server writes the newline separately and ends if
        // it cannot, so read up to it.
        std::string number;
        for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
        close(ends[0]);
        ASSERT_FALSE(number.empty()) << "Xvfb does not start; install the package xvfb";
        setenv("DISPLAY", (":" + number).c_str(), 1);
    }

    void TearDown() override {
        if (server_ <= 0) return;
        kill(server_, SIGTERM);
        waitpid(server_, nullptr, 0);
    }

private:
    [[noreturn]] static void run_server(const int (&ends)[2]) {
        prctl(PR_SET_PDEATHSIG, SIGTERM);  // the server ends with a test that crashes
        close(ends[0]);
        const std::string descriptor = std::to_string(ends[1]);
        execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", "1920x1200x24", "-nolisten", "tcp",
               "-noreset", "-audit", "0", static_cast<char*>(nullptr));
        _exit(127);
    }

    pid_t server_ = -1;
};

[[maybe_unused]] testing::Environment* const display = testing::AddGlobalTestEnvironment(new PrivateDisplay);

}  // namespace
}  // namespace braitenlab::tests
