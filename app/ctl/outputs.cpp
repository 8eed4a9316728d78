#include "app/ctl/outputs.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <string_view>

#include <CLI/CLI.hpp>

#include "app/ctl/class_files.h"
#include "app/ctl/ctl.h"
#include "app/files/breeding_files.h"
#include "app/files/outputs.h"

namespace braitenlab {

namespace {

namespace fs = std::filesystem;

struct OutputOption {
    std::string_view name;
    Written what;
};
constexpr std::array output_options{OutputOption{"--csv", Written::table},   OutputOption{"--html", Written::page},
                                    OutputOption{"--marks", Written::table}, OutputOption{"--paths", Written::page},
                                    OutputOption{"--png", Written::page},    OutputOption{"--save", Written::run},
                                    OutputOption{"--svg", Written::page},    OutputOption{"--vectors", Written::table},
                                    OutputOption{"--wiring", Written::page}, OutputOption{"--out", Written::scene}};
constexpr std::array<std::string_view, 5> read_files{"--a", "--b", "--brain", "--compare", "--list"};

bool is_named(const CLI::Option& option, std::string_view name) {
    return option.check_lname(std::string(name.substr(2)));
}

bool is_given(const CLI::App& command, const char* option) {
    const CLI::Option* found = command.get_option_no_throw(option);
    return found && found->count() > 0;
}

// The files that this command writes, but for those of an export and of a breeding, whose folders are looked at when
// they are written.
std::vector<Output> outputs_of(const CLI::App& command) {
    std::vector<Output> outputs;
    const bool is_study = command.get_name() == "study";
    const bool has_folder =
        command.get_name() == "export" ||
        (command.get_name() == "breed" && !is_given(command, "--champion") && !is_given(command, "--match"));
    for (const CLI::Option* option : command.get_options())
        for (const OutputOption& each : output_options) {
            if (!is_named(*option, each.name) || (each.what == Written::scene && has_folder)) continue;
            for (const std::string& value : option->results()) {
                // The marks are written as a whole, and a study writes beside its table first.
                const bool may_be_device = each.what == Written::table && each.name != "--marks" && !is_study;
                outputs.push_back({option->get_name(), value, each.what, may_be_device});
                if (is_study && each.what == Written::table && value != standard_output)
                    outputs.push_back({option->get_name(), value + ".part", each.what, false});
            }
        }
    if (is_given(command, "--report"))
        for (const char* name : breeding_report_files)
            outputs.push_back(
                {"--report", fs::path(command.get_option("--report")->as<std::string>()) / name, Written::report});
    return outputs;
}

std::optional<Error> empty_name_fault(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        const bool is_output = is_named(*option, "--report") ||
                               std::any_of(output_options.begin(), output_options.end(),
                                           [&](const OutputOption& each) { return is_named(*option, each.name); });
        const std::vector<std::string>& names = option->results();
        if (is_output && std::find(names.begin(), names.end(), "") != names.end())
            return Error{"has an empty name; give the name of a file or a folder", option->get_name()};
    }
    return std::nullopt;
}

std::vector<fs::path> files_read(const CLI::App& command) {
    std::vector<fs::path> files;
    const auto add = [&](const std::string& value) {
        std::error_code none;
        const bool is_folder = fs::is_directory(value, none);
        add_with_named_files(is_folder ? breeding_in(value).string() : value, files);
        if (is_folder) files.push_back(state_in(value));
        if (!is_folder || command.get_name() != "grade") return;
        if (const auto of_class = class_files({value}))
            for (const ClassFile& file : of_class->files) files.push_back(file.path);
    };
    for (const CLI::Option* option : command.get_options())
        if (option->get_positional() || std::any_of(read_files.begin(), read_files.end(),
                                                    [&](std::string_view name) { return is_named(*option, name); }))
            for (const std::string& value : option->results()) add(value);
    return files;
}

}  // namespace

std::optional<Error> output_fault(const std::string& read, const std::vector<fs::path>& written) {
    std::vector<fs::path> files{standard_output_file};
    add_with_named_files(read, files);
    for (const fs::path& path : written) {
        const auto is_same = [&](const fs::path& file) { return is_same_file(path, file); };
        if (std::any_of(files.begin(), files.end(), is_same))
            return Error{"would be replaced, and is read or standard output; give another folder", path.string()};
        if (loses_work(path, Written::page))
            return Error{"is a scene, another file of the lab, or an archive; give another folder", path.string()};
    }
    return std::nullopt;
}

std::optional<Error> output_fault(const CLI::App& command) {
    if (auto fault = empty_name_fault(command)) return fault;
    const std::vector<fs::path> read = files_read(command);
    if (std::any_of(read.begin(), read.end(),
                    [](const auto& file) { return is_same_file(standard_output_file, file); }))
        return Error{"standard output goes to a file that this command reads; send it to another one"};
    const std::vector<Output> outputs = outputs_of(command);
    for (const Output& output : outputs)
        if (output.path == standard_output && output.what != Written::table)
            return Error{output.option + " writes no standard output; give the name of a file", output.path.string()};
    return output_fault(read, outputs);
}

int end_with(int code) {
    std::cout.flush();
    if (std::cout) return code;
    const int failed = complain({"standard output could not be written; check that it has room"});
    return code == exit_code::interrupted ? code : failed;
}

}  // namespace braitenlab
