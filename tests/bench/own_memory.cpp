#include "tests/bench/own_memory.h"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

#if __has_include("app/platform/memory.h")  // older revisions have none, see ./dev bench --against
#include "app/platform/memory.h"
#endif

namespace {

#if __has_include("app/platform/memory.h")
// As in the programs.
[[maybe_unused]] const bool keeps_memory = (braitenlab::keep_freed_memory(), true);
#endif

// Every block carries its size before it.
constexpr std::size_t header = alignof(std::max_align_t);
std::atomic<std::int64_t> in_use{0}, asked{0};

void* take(std::size_t size) {
    void* block = std::malloc(size + header);
    if (!block) throw std::bad_alloc();
    *static_cast<std::size_t*>(block) = size;
    in_use += static_cast<std::int64_t>(size);
    ++asked;
    return static_cast<char*>(block) + header;
}

void give_back(void* memory) noexcept {
    if (!memory) return;
    void* block = static_cast<char*>(memory) - header;
    in_use -= static_cast<std::int64_t>(*static_cast<std::size_t*>(block));
    std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return take(size); }
void* operator new[](std::size_t size) { return take(size); }
void operator delete(void* memory) noexcept { give_back(memory); }
void operator delete[](void* memory) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t) noexcept { give_back(memory); }
void operator delete[](void* memory, std::size_t) noexcept { give_back(memory); }

std::int64_t braitenlab::bench::bytes_in_use() { return in_use; }
std::int64_t braitenlab::bench::allocations() { return asked; }
