// Text of exported programs: numbers, identifiers, comments.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace braitenlab::robots {

// The shortest decimal number that reads as the same float, with a decimal point: "0.8", "1.0", "1e-05".
std::string number(float);

// The same as a float constant of C: "0.8f".
std::string c_number(float);

// A name that a user typed, for a comment of C, Python, Aseba or SPICE: without line ends and without characters that
// end or begin a comment.
std::string comment_text(std::string_view);

// The template with each @KEY@ replaced by its value. Values are not searched for keys. Precondition: every key of the
// template has a value.
std::string filled(std::string_view text, const std::map<std::string, std::string>& values);

// Identifiers that differ from each other, also where case does not count, as in SPICE.
class Identifiers {
public:
    // The prefix and the name, with _ for other characters than ASCII letters and digits; with a number at its end when
    // the identifier exists. Identifiers of C that begin with a letter, if the prefix does.
    std::string make(std::string_view prefix, std::string_view name);

private:
    std::set<std::string> made_;  // in lower case
};

}  // namespace braitenlab::robots
