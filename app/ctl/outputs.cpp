#include "app/ctl/outputs.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iostream>
#include <string_view>

#include <CLI/CLI.hpp>

#include "app/ctl/class_files.h"
#include "app/ctl/ctl.h"
#include "app/files/breeding_files.h"
#include "app/files/data.h"
#include "app/files/safe_file.h"
#include "core/io/run_file.h"
#include "core/lesson/hand_in.h"
#include "core/scene/file_kind.h"
#include "core/scene/schema.h"
#include "core/scene/toml_tree.h"

namespace braitenlab {

namespace {

namespace fs = std::filesystem;

// What an option writes decides what it may replace.
enum class Written { table, page, run, scene };

struct Output {
    std::string option;
    fs::path path;
    Written what;
    bool may_be_device;
};

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

// Standard output by a name of the file system, where it has one.
constexpr const char* standard_output_file = "/dev/stdout";

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
                {"--report", fs::path(command.get_option("--report")->as<std::string>()) / name, Written::page, false});
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

// The files that a study, a breeding, an exercise or a lecture names.
void add_named_files(const fs::path& file, std::vector<fs::path>& files) {
    const auto text = read_text(file);
    if (!text || find_kind(file, *text).value_or(FileKind::run) == FileKind::run) return;
    const auto toml = parse_toml(*text, file.string());
    if (!toml) return;
    for (const TomlNode* named : named_files(toml->root)) files.push_back(file.parent_path() / *named->as_text());
}

std::vector<fs::path> files_read(const CLI::App& command) {
    std::vector<fs::path> files;
    const auto add = [&](const std::string& value) {
        std::error_code none;
        const bool is_folder = fs::is_directory(value, none);
        if (const auto file = is_folder ? Result<fs::path>(breeding_in(value)) : find_shipped(value)) {
            files.push_back(*file);
            add_named_files(*file, files);
        }
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

// True if replacing the file would lose a scene or another file of the lab, a run or an archive, whatever its name is.
// A run replaces a run, a scene or a brain replaces a scene or a brain.
bool loses_work(const fs::path& file, Written what) {
    std::error_code none;
    if (!fs::is_regular_file(file, none) || fs::file_size(file, none) == 0) return false;
    std::string text(limits::file_bytes, '\0');  // no file of the lab is larger, but for runs and states of breedings
    std::ifstream in(file, std::ios::binary);
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    const std::string_view format = foreign_format(text);
    const fs::path ending = file.extension();
    if (format == "ZIP" || ending == ".zip") return true;
    if (format == "JSON") return what != Written::run || ending != io::run_ending;
    if (format.empty()) {
        if (holds_hand_in(file.filename().string(), text)) return true;
        const auto kind = find_kind(fs::path(), text);
        const bool is_scene = kind == FileKind::scene || kind == FileKind::brain;
        if (kind) return !(is_scene && what == Written::scene);
    }
    return ending == ".toml" || ending == io::run_ending;
}

bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code none;
    if (fs::exists(a, none)) return fs::is_regular_file(a, none) && fs::equivalent(a, b, none);
    return behind_links(a) == behind_links(b);
}

}  // namespace

std::optional<Error> output_fault(const std::string& read, const std::vector<fs::path>& written) {
    std::vector<fs::path> files{standard_output_file};
    if (const auto file = find_shipped(read)) {
        files.push_back(*file);
        add_named_files(*file, files);
    }
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
    const auto is_in = [](const fs::path& path, const std::vector<fs::path>& files) {
        return std::any_of(files.begin(), files.end(), [&](const fs::path& file) { return is_same_file(path, file); });
    };
    std::vector<fs::path> written{standard_output_file};
    if (is_in(standard_output_file, read))
        return Error{"standard output goes to a file that this command reads; send it to another one"};
    for (const Output& output : outputs_of(command)) {
        const auto refused = [&](const std::string& why) { return Error{output.option + why, output.path.string()}; };
        const bool is_standard_output = output.path == standard_output;
        if (is_standard_output && output.what != Written::table)
            return refused(" writes no standard output; give the name of a file");
        if (is_in(output.path, read)) return refused(" names a file that this command reads; give another one");
        if (is_in(output.path, written)) return refused(" names a file that another option writes; give another one");
        if (!is_standard_output) {
            const fs::path target = behind_links(output.path);
            const bool is_own_json = output.option == "--report" && output.path.extension() == ".json";
            if (loses_work(target, output.what) && !is_own_json)
                return refused(" would write over a scene, another file of the lab, or an archive; give another one");
            std::error_code none;
            const bool is_device =
                fs::exists(target, none) && !fs::is_regular_file(target, none) && !fs::is_directory(target, none);
            if (auto fault = replacement_fault(output.path); fault && !(output.may_be_device && is_device))
                return fault;
        }
        written.push_back(output.path);
    }
    return std::nullopt;
}

int end_with(int code) {
    std::cout.flush();
    if (std::cout) return code;
    const int failed = complain({"standard output could not be written; check that it has room"});
    return code == exit_code::interrupted ? code : failed;
}

}  // namespace braitenlab
