#include "app/terminal.h"

#include <algorithm>
#include <iostream>
#include <streambuf>

#include "core/scene/nearest.h"
#include "core/utf8.h"

namespace braitenlab {

namespace {

bool acts_on_terminal(char32_t code) { return code == '\r' || is_control(code) || is_layout_mark(code); }

}  // namespace

std::string terminal_text(std::string_view text) { return utf8_without(text, acts_on_terminal); }

std::string one_line(std::string_view text) {
    std::string line = terminal_text(text);
    std::replace(line.begin(), line.end(), '\n', ' ');
    return line;
}

std::string usage_fault(std::string_view what) { return one_line(what) + "\nRun with --help for more information.\n"; }

std::string nearest_option(std::span<const std::string> known, int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i], name = word.substr(0, word.find('='));
        if (name.size() > 2 && name.starts_with("--") && std::find(known.begin(), known.end(), name) == known.end())
            return name_nearest(name, std::vector<std::string_view>(known.begin(), known.end()));
    }
    return {};
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

}  // namespace braitenlab
