#include "core/io/checked_json.h"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/evolve/breeding_file.h"
#include "core/evolve/breeding_json.h"
#include "core/io/run_file.h"
#include "core/lesson/exercise_file.h"
#include "core/lesson/progress.h"
#include "core/lesson/referee.h"
#include "core/scene/file_kind.h"
#include "tests/core/sessions.h"

namespace braitenlab::tests::checked_json_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path exercises = fs::path(BRAITENLAB_SOURCE) / "exercises";

template <class T>
void expect_checks(const std::vector<const char*>& in_range, const std::vector<const char*>& others) {
    for (const char* text : in_range) EXPECT_EQ(Json(Json::parse(text).get<T>()), Json::parse(text)) << text;
    for (const char* text : others) {
        EXPECT_THROW((void)Json::parse(text).get<T>(), Json::type_error) << text;
        const Json list = Json::parse(std::string("[0, ") + text + "]");
        EXPECT_THROW((void)list.get<std::vector<T>>(), Json::type_error) << text;
        const Json object = Json::object({{"key", list[1]}});
        EXPECT_THROW((void)object.value("key", T{}), Json::type_error) << text;
    }
}

TEST(CheckedJson, ReadsWholeNumbersInTheRangeOfTheirType) {
    expect_checks<std::int32_t>({"0", "-2147483648", "2147483647", "-0.0", "3.0", "2e9", "-2147483648.0"},
                                {"0.5", "-1e-9", "1e30", "-1e30", "2147483648", "-2147483649", "2147483648.0",
                                 "18446744073709551615", "true", "\"1\"", "null", "[]", "{}"});
    expect_checks<std::uint32_t>({"0", "4294967295", "4294967295.0"}, {"-1", "4294967296", "4294967296.0", "-1.0"});
    expect_checks<std::int64_t>({"-9223372036854775808", "9223372036854775807", "-9223372036854775808.0"},
                                {"9223372036854775808", "9223372036854775808.0", "1e19", "-1e19", "0.5"});
    expect_checks<std::uint64_t>({"18446744073709551615", "9223372036854775808", "1e19"},
                                 {"-1", "18446744073709551616", "18446744073709551616.0", "1e20", "1e-3"});
    EXPECT_EQ(Json::parse("true").get<bool>(), true);
    EXPECT_EQ(Json::parse("[1, 2]").get<std::vector<float>>(), (std::vector<float>{1, 2}));
}

TEST(CheckedJson, NamesTheNumberAndTheRange) {
    try {
        (void)Json(1e30).get<int>();
        ADD_FAILURE() << "1e30 is read";
    } catch (const Json::exception& problem) {
        EXPECT_NE(std::string(problem.what()).find("1e+30 is no whole number from -2147483648 to 2147483647"),
                  std::string::npos)
            << problem.what();
    }
}

// A kind of file: one of it, and whether a text is read as one with all its parts.
struct FileKind {
    std::string text;
    std::function<bool(const std::string&)> is_read;
    int fewest = 0;  // fields that are whole numbers
};

// A run with a vehicle that has its own sensors, contacts, marks, strikes and most commands.
FileKind run() {
    Scene scene = furnished();
    for (Kind& kind : scene.kinds) kind.memory.marks = 3;
    scene.arena.width = scene.arena.height = 11;
    Session session = open_session(scene);
    (void)session.apply(SetSensors{{.vehicle = 1}, {{.name = "own", .channel = Channel::heat}}});
    for (int i = 0; i < 310; ++i) session.step();
    maths::Random chance{5, 1};
    for (int i = 0; i < 200; ++i) {
        (void)session.apply(any_edit(session, chance));
        if (i % 4 == 0) session.step();
    }
    const auto is_read = [](const std::string& text) {
        const auto read = io::read_run(text, "a.run");
        const bool is_named = read || read.error().text().find("whole number") != std::string::npos ||
                              text.find("\"braitenlab_run\":1,") == std::string::npos;
        EXPECT_TRUE(is_named) << read.error().text();
        return static_cast<bool>(read);
    };
    return {io::write_run(session.save()), is_read, 60};
}

FileKind progress() {
    const auto exercise = load_exercise(exercises / "guided" / "05-aggressor.toml");
    StudentProgress student{"Anna", {}};
    student.exercises["a"] = {true, true, 9, 10, 3, "x", true, true, "y", exercise->solution.submission};
    const auto is_read = [](const std::string& text) {
        const auto read = read_progress(text, "anna.json");
        return read && read->exercises.at("a").submission;
    };
    return {write_progress(student), is_read, 7};
}

FileKind referee() {
    auto exercise = std::make_shared<Exercise>(*load_exercise(exercises / "guided" / "05-aggressor.toml"));
    Session session = open_session(exercise->scene, exercise->seed);
    Referee watching(*exercise);
    watching.watch(session.snapshot());
    const auto is_read = [exercise](const std::string& text) {
        return read_referee_state(text, *exercise).has_value();
    };
    return {write_referee_state(watching.state()), is_read, 4};
}

// A breeding with one complete generation.
FileKind breeding() {
    const fs::path folder = exercises / "breeding";
    auto file = evolve::parse_breeding(*read_text(folder / "flee.toml"), "flee.toml");
    const auto scene = *read_text(folder / "scenes" / "flee-arena.toml");
    const auto base = *evolve::BreedingBase::create(std::move(*file), scene, "scene.toml");
    evolve::BreedingState state = evolve::begin_breeding(*base);
    for (auto trials = evolve::next_trials(*base, state, 1); !trials.empty();
         trials = evolve::next_trials(*base, state, 1))
        evolve::advance(*base, state, std::vector<float>(trials.size(), 1));
    const auto is_read = [base](const std::string& text) {
        return static_cast<bool>(evolve::read_state(*base, text, "state.json"));
    };
    return {evolve::write_state(*base, state), is_read, 4};
}

// The whole numbers of a file, one for each field: places in lists do not count. A float is written with a point.
std::map<std::string, Json::json_pointer> whole_numbers(const Json& file) {
    static const std::regex place{R"(/\d+(?=/|$))"};
    std::map<std::string, Json::json_pointer> fields;
    const Json flat = file.flatten();
    for (const auto& [path, value] : flat.items())
        if (value.is_number_integer()) fields.try_emplace(std::regex_replace(path, place, "/#"), path);
    return fields;
}

TEST(CheckedJson, ChecksEveryWholeNumberOfEveryKindOfFile) {
    for (const FileKind& kind : {run(), progress(), referee(), breeding()}) {
        ASSERT_TRUE(kind.is_read(kind.text)) << kind.text.substr(0, 200);
        const Json file = Json::parse(kind.text);
        const auto fields = whole_numbers(file);
        EXPECT_GE(static_cast<int>(fields.size()), kind.fewest);
        for (const auto& [field, place] : fields)
            for (const double number : {0.5, 1e30, -1e30}) {
                Json changed = file;
                changed[place] = number;
                EXPECT_FALSE(kind.is_read(changed.dump())) << field << " = " << number;
            }
    }
}

}  // namespace
}  // namespace braitenlab::tests::checked_json_test
