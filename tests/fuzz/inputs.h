// The inputs of a target in the source tree.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/fuzz/targets.h"

namespace braitenlab::fuzz {

// Relative to the source tree: that of the shipped files of its kind, and its own in tests/corpus, where it has one.
inline std::vector<std::string> folders_of(const Target& target) {
    std::vector<std::string> folders;
    if (!target.shipped.empty()) folders.emplace_back(target.shipped);
    const std::string own = "tests/corpus/" + std::string(target.name);
    if (std::filesystem::exists(std::filesystem::path(BRAITENLAB_SOURCE) / own)) folders.push_back(own);
    return folders;
}

// The texts of the files in these folders, by their paths.
inline std::vector<std::string> inputs_of(const Target& target) {
    std::vector<std::filesystem::path> files;
    for (const std::string& folder : folders_of(target))
        for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(BRAITENLAB_SOURCE) / folder))
            if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<std::string> texts;
    for (const auto& path : files) {
        std::ifstream file(path, std::ios::binary);
        texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    return texts;
}

}  // namespace braitenlab::fuzz
