#include "tests/fuzz/mutate.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/maths/random.h"

namespace braitenlab::fuzz {

namespace {

using Lines = std::vector<std::string>;

constexpr std::array<std::string_view, 18> odd_numbers{
    "0",   "-1",    "1",     "0.001", "1e30", "-1e-30", "nan",   "inf",  "-inf",
    "2.5", "99999", "1e308", "20000", "0x7f", "true",   "[[1]]", "\"\"", "9223372036854775807"};

Lines lines_of(std::string_view text) {
    const char end = std::count(text.begin(), text.end(), '\n') > 1 ? '\n' : ',';
    Lines lines;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find(end), text.size() - 1) + 1;
        lines.emplace_back(text.substr(0, length));
        text.remove_prefix(length);
    }
    return lines;
}

bool is_of_number(char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-'; }
bool is_of_word(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || is_of_number(c); }

// The first run of such characters at or after `from`: where it begins and its length, 0 without one.
template <class Is>
std::pair<std::size_t, std::size_t> run_of(std::string_view line, std::size_t from, const Is& is) {
    const auto begin = std::find_if(line.begin() + static_cast<std::ptrdiff_t>(from), line.end(), is);
    const auto end = std::find_if_not(begin, line.end(), is);
    return {static_cast<std::size_t>(begin - line.begin()), static_cast<std::size_t>(end - begin)};
}

class Mutation {
public:
    Mutation(Lines& lines, maths::Random& chance, std::span<const std::string> others)
        : lines_(lines), chance_(chance), others_(others) {}

    void change() {
        if (lines_.empty()) lines_.emplace_back("format = 1\n");
        std::string& line = lines_[below(lines_.size())];
        const std::string other = any_line();
        switch (below(12)) {
            case 0:
                lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(below(lines_.size())));
                break;
            case 1:
                lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(below(lines_.size() + 1)), other);
                break;
            case 2:
                std::swap(line, lines_[below(lines_.size())]);
                break;
            case 3:
                line = other;
                break;
            case 4:
                replace(line, is_of_word, word_of(other));
                break;
            case 5:
                line[below(line.size())] = static_cast<char>(below(256));
                break;
            default:
                replace(line, is_of_number, std::string(odd_numbers[below(odd_numbers.size())]));
        }
    }

private:
    std::size_t below(std::size_t count) { return chance_.next() % count; }

    std::string any_line() {
        if (others_.empty() || below(2) == 0) return lines_[below(lines_.size())];
        const Lines of_other = lines_of(others_[below(others_.size())]);
        return of_other.empty() ? "\n" : of_other[below(of_other.size())];
    }
    std::string word_of(const std::string& line) {
        const auto [begin, length] = run_of(line, below(line.size()), is_of_word);
        return length > 0 ? line.substr(begin, length) : "x";
    }
    // Replaces a run of such characters, of the value where the line has one.
    template <class Is>
    void replace(std::string& line, const Is& is, const std::string& by) {
        const std::size_t value = std::min(line.find('=') + 1, line.size() - 1);  // 0 without one
        const auto [begin, length] = run_of(line, value + below(line.size() - value), is);
        if (length > 0) line.replace(begin, length, by);
    }

    Lines& lines_;
    maths::Random& chance_;
    std::span<const std::string> others_;
};

}  // namespace

std::string mutant_of(std::string_view text, std::uint64_t seed, std::span<const std::string> others) {
    maths::Random chance{seed, 53};
    Lines lines = lines_of(text);
    Mutation mutation(lines, chance, others);
    for (std::uint32_t changes = chance.next() % 4 + 1; changes > 0; --changes) mutation.change();
    std::string mutant;
    for (const std::string& line : lines) mutant += line;
    return mutant;
}

}  // namespace braitenlab::fuzz
