// The subcommands of braitenctl. Each prints what it found and returns the exit code.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"

namespace braitenlab {

namespace exit_code {
inline constexpr int done = 0, failed = 1, bad_input = 2;
}

// Says what is wrong on stderr.
int complain(const Error&);

struct RunOptions {
    std::string file;  // a scene or a saved run
    double seconds = 10;
    std::optional<std::uint64_t> seed;
    std::vector<std::string> settings;
    std::string csv, save;  // files; empty: none
    bool json = false, hash = false;
};
int run(const RunOptions&);

int check(const std::string& exercise, const std::string& brain_file);
int check_all();

// A class's brains, one row each, to the file or where it is empty to stdout. A file that holds no brain gets a row
// that says so, and the others are graded all the same.
int grade_all(const std::string& exercise, const std::vector<std::string>& brain_files, const std::string& csv);

// What a scene, an exercise, a saved run or a brain contains, and what the recogniser calls its brains.
int show(const std::string& file);

}  // namespace braitenlab
