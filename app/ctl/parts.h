// Long commands in parts that do not depend on each other. The threads of this process compute them or, in
// braitenctl-mpi under a launcher, those of all ranks: no command knows which, and the numbers are the same.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace braitenlab {

using Numbers = std::vector<double>;  // of one part

// Computes a part. Several threads call it at once.
using Part = std::function<Numbers(std::size_t part)>;

struct Parts {
    std::size_t count = 0;
    Part part;
    std::function<std::string()> text;  // of which part_of() makes the same Part in another process
    std::function<void()> meanwhile{};  // called once on the calling thread, while others compute
};

// The text begins with the name of the command and a line end.
Result<Part> part_of(std::string_view text);
Result<Part> part_of_breeding(std::string_view text);
Result<Part> part_of_map(std::string_view text);
Result<Part> part_of_study(std::string_view text);

class PartRunner {
public:
    // threads: of each process; 0: one per processor, or per processor that a rank may use.
    explicit PartRunner(int threads);
    ~PartRunner();
    PartRunner(const PartRunner&) = delete;
    PartRunner& operator=(const PartRunner&) = delete;

    int threads() const;  // of all processes

    // The numbers of all parts in their order. Empty when the user has interrupted the program.
    Result<std::vector<Numbers>> run(const Parts&);

private:
    struct Running;
    std::unique_ptr<Running> running_;
};

}  // namespace braitenlab
