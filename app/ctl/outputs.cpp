#include "app/ctl/outputs.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <streambuf>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/ctl/ctl.h"
#include "app/files/data.h"
#include "core/utf8.h"

namespace braitenlab {

namespace {

namespace fs = std::filesystem;

// The options of all commands whose values are files.
constexpr std::array<std::string_view, 9> written_files{"--csv",  "--html", "--out",     "--paths", "--png",
                                                        "--save", "--svg",  "--vectors", "--wiring"};
constexpr std::array<std::string_view, 6> tables_and_drawings{"--csv", "--html", "--paths",
                                                              "--png", "--svg",  "--wiring"};
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

// A file of the lab, or a class's archive: also one that the command reads from a folder, or that a file names.
bool is_work(const fs::path& file) {
    std::error_code none;
    const fs::path kind = file.extension();
    return fs::is_regular_file(file, none) && (kind == ".toml" || kind == ".run" || kind == ".zip");
}

bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code none;
    if (fs::exists(a, none)) return fs::is_regular_file(a, none) && fs::equivalent(a, b, none);
    return fs::weakly_canonical(fs::absolute(a, none), none) == fs::weakly_canonical(fs::absolute(b, none), none);
}

bool acts_on_terminal(char32_t code) {
    if (code == '\t' || code == '\n') return false;
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x200E || code == 0x200F || code == 0x061C ||
           (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

}  // namespace

std::string terminal_text(std::string_view text) {
    std::string inert;
    while (!text.empty()) {
        const CodePoint first = first_code_point(text);
        inert +=
            !first.is_valid || acts_on_terminal(first.code) ? std::string_view("\uFFFD") : text.substr(0, first.size);
        text.remove_prefix(first.size);
    }
    return inert;
}

// A buffer without memory of its own: a text of one call is passed on at once.
struct InertOutput::Filter : std::streambuf {
    explicit Filter(std::ostream& stream) : stream_(stream), to_(stream.rdbuf(this)) {}
    ~Filter() override { stream_.rdbuf(to_); }

protected:
    std::streamsize xsputn(const char* text, std::streamsize size) override {
        const std::string inert = terminal_text({text, static_cast<std::size_t>(size)});
        const auto length = static_cast<std::streamsize>(inert.size());
        return to_->sputn(inert.data(), length) == length ? size : 0;
    }
    int overflow(int c) override {
        const char byte = traits_type::to_char_type(c);
        return traits_type::eq_int_type(c, traits_type::eof()) || xsputn(&byte, 1) == 1 ? traits_type::not_eof(c)
                                                                                        : traits_type::eof();
    }
    int sync() override { return to_->pubsync(); }

private:
    std::ostream& stream_;
    std::streambuf* to_;
};

InertOutput::InertOutput() : out_(std::make_unique<Filter>(std::cout)), errors_(std::make_unique<Filter>(std::cerr)) {}
InertOutput::~InertOutput() = default;

std::optional<Error> output_over_input(const CLI::App& command) {
    const std::vector<fs::path> read = files_read(command);
    std::vector<fs::path> written;
    for (const CLI::Option* option : command.get_options()) {
        if (!is_one_of(*option, written_files)) continue;
        for (const std::string& value : option->results()) {
            if (value == "-") continue;
            const auto is_it = [&](const fs::path& other) { return is_same_file(value, other); };
            if (std::any_of(read.begin(), read.end(), is_it))
                return Error{option->get_name() + " names a file that this command reads; give another one", value};
            if (std::any_of(written.begin(), written.end(), is_it))
                return Error{option->get_name() + " names a file that another option writes; give another one", value};
            if (is_one_of(*option, tables_and_drawings) && is_work(value))
                return Error{option->get_name() + " would write over a scene, a run or an archive; give another one",
                             value};
            written.emplace_back(value);
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
