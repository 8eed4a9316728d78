// A limit on the size of files, which simulates a full disk.
#pragma once

#if __has_include(<sys/resource.h>)
#include <csignal>

#include <sys/resource.h>
#endif

namespace braitenlab::tests {

#if __has_include(<sys/resource.h>)
inline constexpr bool can_limit_files = true;

// While it exists, a write beyond 1000 bytes of a file fails.
class FullDisk {
public:
    FullDisk() {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit small{1000, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, old_handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit before_{};
    void (*old_handler_)(int) = std::signal(SIGXFSZ, SIG_IGN);
};
#else
inline constexpr bool can_limit_files = false;  // tests skip

struct FullDisk {
    FullDisk() {}
};
#endif

}  // namespace braitenlab::tests
