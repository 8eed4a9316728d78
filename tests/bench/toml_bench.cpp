// The time of the guarded reader of TOML beside that of the parser alone, on all files of the lab.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <toml++/toml.h>

#include "core/scene/file_kind.h"
#include "core/scene/toml_tree.h"

namespace braitenlab::bench {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> shipped_texts() {
    std::vector<fs::path> files;
    for (const char* folder : {"exercises", "ui/strings"})
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(BRAITENLAB_SOURCE) / folder))
            if (entry.path().extension() == ".toml") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<std::string> texts;
    for (const fs::path& file : files) texts.push_back(*read_text(file));
    return texts;
}

template <class Read>
void read_all(benchmark::State& state, const Read& read) {
    const std::vector<std::string> texts = shipped_texts();
    std::size_t bytes = 0;
    for (const std::string& text : texts) bytes += text.size();
    for (auto _ : state)
        for (const std::string& text : texts) read(text);
    state.counters["files"] = static_cast<double>(texts.size());
    state.SetBytesProcessed(static_cast<std::int64_t>(bytes) * state.iterations());
}

void BM_TomlGuarded(benchmark::State& state) {
    read_all(state, [](const std::string& text) { benchmark::DoNotOptimize(parse_toml(text, "f.toml")); });
}
BENCHMARK(BM_TomlGuarded);

void BM_TomlParserAlone(benchmark::State& state) {
    read_all(state, [](const std::string& text) {
        benchmark::DoNotOptimize(toml::parse(std::string_view(text), std::string_view("f.toml")));
    });
}
BENCHMARK(BM_TomlParserAlone);

}  // namespace
}  // namespace braitenlab::bench
