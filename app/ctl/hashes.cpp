// braitenctl hashes: the hashes of the shipped scenes and exercises, to compare platforms and compilers.
#include <algorithm>
#include <iostream>

#include <fmt/format.h>

#include "app/ctl/ctl.h"
#include "app/files/data.h"
#include "app/terminal.h"
#include "core/lesson/shipped_hashes.h"

namespace braitenlab {

int print_hashes(const HashOptions& options) {
    const auto data = data_folder();
    if (!data) return complain(data.error());
    const auto computed = hashes_of_shipped(*data / "exercises", options.seconds);
    if (!computed) return complain(computed.error());
    if (options.compared.empty()) {
        std::cout << write_hashes(*computed);
        return exit_code::done;
    }
    const auto expected = read_hashes(options.compared);
    if (!expected) return complain(expected.error());
    const auto different = differences(*computed, *expected);
    for (const std::string& line : different) std::cout << format_lines("{}\n", line);
    std::cout << fmt::format("{} of {} hashes are the same\n",
                             computed->size() - std::min(computed->size(), different.size()), computed->size());
    return different.empty() ? exit_code::done : exit_code::failed;
}

}  // namespace braitenlab
