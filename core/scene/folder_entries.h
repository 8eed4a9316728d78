// The entries of a folder.
#pragma once

#include <filesystem>

namespace braitenlab {

// Calls visit(const std::filesystem::directory_entry&) for each entry, in no particular order. Does not throw on errors
// of the file system: a folder that cannot be read, or can no longer be read, ends the iteration.
template <class Visit>
void for_each_entry(const std::filesystem::path& folder, const Visit& visit) {
    std::error_code problem;
    std::filesystem::directory_iterator entry(folder, problem);
    for (; !problem && entry != std::filesystem::directory_iterator(); entry.increment(problem)) visit(*entry);
}

}  // namespace braitenlab
