// What is fuzzed: each target reads one input as a stranger's file of one kind, or plays it as a person's commands, and
// ends the process where a promise is broken. `./dev fuzz` runs them under libFuzzer with sanitizers; the suite Fuzz
// repeats the shipped files, tests/corpus and some mutants in every test run.
#pragma once

#include <span>
#include <string_view>

namespace braitenlab::fuzz {

struct Target {
    std::string_view name;     // of its folder in tests/corpus, too
    std::string_view shipped;  // folder of shipped files of this kind, or empty
    bool is_text;              // its mutants are those of mutate.h
    void (*run)(std::string_view input);
};

std::span<const Target> targets();

// Null for an unknown name.
const Target* find_target(std::string_view name);

}  // namespace braitenlab::fuzz
