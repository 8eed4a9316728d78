// Gives each test process a separate X display, so that tests of the real window can run side by side: each has its own
// pointer, keyboard and input focus. BRAITENLAB_TEST_DISPLAY=:N uses an existing display instead.
#include <cstdlib>
#include <optional>

#include <gtest/gtest.h>

#include "tests/x_server.h"

namespace braitenlab::tests {
namespace {

class PrivateDisplay : public testing::Environment {
public:
    void SetUp() override {
        const char* existing = std::getenv("BRAITENLAB_TEST_DISPLAY");
        if (!existing) server_.emplace();
        setenv("DISPLAY", existing ? existing : server_->display().c_str(), 1);
    }
    void TearDown() override { server_.reset(); }

private:
    std::optional<XServer> server_;
};

[[maybe_unused]] testing::Environment* const display = testing::AddGlobalTestEnvironment(new PrivateDisplay);

}  // namespace
}  // namespace braitenlab::tests
