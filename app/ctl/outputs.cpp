#include "app/ctl/outputs.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/ctl/ctl.h"
#include "app/files/data.h"

namespace braitenlab {

namespace {

namespace fs = std::filesystem;

// The options of all commands whose values are files.
constexpr std::array<std::string_view, 9> written_files{"--csv",  "--html", "--out",     "--paths", "--png",
                                                        "--save", "--svg",  "--vectors", "--wiring"};
constexpr std::array<std::string_view, 4> read_files{"--a", "--b", "--brain", "--compare"};

bool is_one_of(const CLI::Option& option, const auto& names) {
    return std::any_of(names.begin(), names.end(),
                       [&](std::string_view name) { return option.check_lname(std::string(name.substr(2))); });
}

std::vector<fs::path> files_read(const CLI::App& command) {
    std::vector<fs::path> files;
    for (const CLI::Option* option : command.get_options())
        if (option->get_positional() || is_one_of(*option, read_files))
            for (const std::string& value : option->results())
                if (const auto file = find_shipped(value)) files.push_back(*file);
    return files;
}

}  // namespace

std::optional<Error> output_over_input(const CLI::App& command) {
    const std::vector<fs::path> read = files_read(command);
    for (const CLI::Option* option : command.get_options()) {
        if (!is_one_of(*option, written_files)) continue;
        for (const std::string& value : option->results())
            for (const fs::path& input : read) {
                std::error_code none;
                if (fs::is_regular_file(input, none) && fs::equivalent(value, input, none))
                    return Error{option->get_name() + " names a file that this command reads; give another one", value};
            }
    }
    return std::nullopt;
}

int end_with(int code) {
    std::cout.flush();
    if (std::cout) return code;
    const int failed = complain({"standard output could not be written; check that it has room"});
    return code == exit_code::done ? failed : code;
}

}  // namespace braitenlab
