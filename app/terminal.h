// Text that goes to a terminal. Titles, names and keys of files, and their paths, come from strangers.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

namespace braitenlab {

// The text without what a terminal acts upon: control characters other than tab and line feed, and marks that end a
// line or change the direction of writing, are U+FFFD.
std::string terminal_text(std::string_view);

// The same for a text that is one line or a part of it: a line feed is a space.
std::string one_line(std::string_view);

// What follows a wrong command line: what is wrong, and how to find help.
std::string usage_fault(std::string_view what);

// "; the nearest is '--lang'" for the first option in the arguments that is not among `known`; empty if there is none.
std::string nearest_option(std::span<const std::string> known, int argc, char** argv);

// The same for the options of a CLI::App.
template <class App>
std::string nearest_option_of(const App& app, int argc, char** argv) {
    std::vector<std::string> known;
    for (const auto* option : app.get_options())
        for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
    return nearest_option(known, argc, argv);
}

// As fmt::format(), with one_line() of each argument that is a text: all ends of lines are those of the format, so that
// no title looks like a line of a report.
template <class... Args>
std::string format_lines(fmt::format_string<const Args&...> format, const Args&... args) {
    const auto inert = [](const auto& value) -> decltype(auto) {
        if constexpr (std::is_convertible_v<decltype(value), std::string_view>)
            return one_line(value);
        else
            return (value);
    };
    return fmt::format(fmt::runtime(fmt::string_view(format)), inert(args)...);
}

// While it exists, terminal_text() applies to all that is written to std::cout and std::cerr.
class InertOutput {
public:
    InertOutput();
    ~InertOutput();
    InertOutput(const InertOutput&) = delete;
    InertOutput& operator=(const InertOutput&) = delete;

private:
    struct Filter;
    std::unique_ptr<Filter> out_, errors_;
};

}  // namespace braitenlab
