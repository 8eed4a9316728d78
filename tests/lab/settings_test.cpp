#include "app/files/settings.h"

#include <gtest/gtest.h>

#include "tests/folder.h"

namespace braitenlab::tests::settings_test {
namespace {

const Preferences chosen{Theme::light, "es", 1.5f, true};

TEST(Settings, AreReadAsTheyWereWritten) {
    EXPECT_EQ(*parse_preferences(write_preferences(chosen), "s"), chosen);
    for (const std::optional<Quality> quality : {std::optional<Quality>{}, {Quality::low}, {Quality::high}}) {
        Preferences each = chosen;
        each.quality = quality;
        EXPECT_EQ(*parse_preferences(write_preferences(each), "s"), each);
    }
    StoredState state{1280, 800, "/a \"b\"/c.toml", {{"/x.toml", "A scene"}, {"/ünï.toml"}}, "/a"};
    EXPECT_EQ(*parse_state(write_state(state), "s"), state);
}

TEST(Settings, AreClampedToTheirRange) {
    EXPECT_EQ(parse_preferences("type_size = 99.0", "s")->type_size, largest_type_size);
    EXPECT_EQ(parse_preferences("type_size = -1.0", "s")->type_size, least_type_size);
    EXPECT_EQ(parse_preferences("type_size = nan", "s")->type_size, least_type_size);
    EXPECT_EQ(parse_state("width = 3\nheight = 1000000", "s")->width, 0);
}

TEST(Settings, KeepTheViewAndTheWindow) {
    StoredState state;
    state.view.settings.camera.mode = CameraMode::birds_eye;
    state.view.settings.overlays = {false, {TrailValue::speed}, false, false, false, false, 3, std::nullopt};
    state.view.settings.sensors = false, state.view.settings.outlines = true;
    state.view.settings.canvas_share = 0.5f, state.view.settings.selection.whole_kind = false;
    state.view.folded = {"card.brain", "card.scene"};
    state.view.followed = {true, false, true, false};
    state.view.strips = {"SL", "SL>N1"};
    state.view.may_change = {.weights = false, .biases = true, .thresholds = true, .eyes = false};
    state.place = WindowPlace{-20, 40};
    state.study = "prey-eyes", state.breeding = "/kept/breeding.toml";
    const auto read = parse_state(write_state(state), "s");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(*read, state);
    state.view.settings.overlays.trail_colour = {TrailValue::wheels};
    EXPECT_EQ(*parse_state(write_state(state), "s"), state);
    EXPECT_EQ(*parse_state(write_state({}), "s"), StoredState{});
    EXPECT_EQ(*parse_state("format = 1\ndiagram = true\n", "s"), StoredState{}) << "of an earlier version";
}

TEST(Settings, ClampTheView) {
    const auto state = parse_state("diagram_share = nan\ncamera = \"moon\"\nx = 3", "s");
    ASSERT_TRUE(state) << state.error().text();
    EXPECT_EQ(state->view.settings.canvas_share, ViewSettings{}.canvas_share);
    EXPECT_EQ(state->view.settings.camera.mode, CameraMode::overview);
    EXPECT_FALSE(state->place) << "y is missing";
    const auto trails = [](const char* toml) { return parse_state(toml, "s")->view.settings.overlays.trail_colour; };
    EXPECT_EQ(trails("trail_colour = \"rainbow\""), TrailColour{});
    EXPECT_EQ(trails("trail_colour = \"reading\""), TrailColour{}) << "of which sensor is not stored";
    EXPECT_EQ(*parse_state("speed = 16.0", "s"), StoredState{}) << "of an earlier version";
    EXPECT_FALSE(parse_state("trails = \"yes\"", "s"));
}

TEST(Settings, PlaceAWindowOnlyWhereItCanBeGrabbed) {
    const std::vector<std::array<int, 4>> displays{{0, 0, 1920, 1080}, {-1280, 0, 1280, 800}};
    EXPECT_TRUE(can_be_grabbed({100, 50}, {1280, 800}, displays));
    EXPECT_TRUE(can_be_grabbed({-900, 50}, {1280, 800}, displays));
    EXPECT_FALSE(can_be_grabbed({1900, 50}, {1280, 800}, displays)) << "beyond the right edge";
    EXPECT_FALSE(can_be_grabbed({100, 1060}, {1280, 800}, displays)) << "below";
    EXPECT_FALSE(can_be_grabbed({100, -30}, {1280, 800}, displays)) << "its title bar is above";
    EXPECT_FALSE(can_be_grabbed({-1250, 50}, {1280, 800}, {displays[0]})) << "the second display is gone";
}

TEST(Settings, NameFileAndLineOfAMistake) {
    const auto parsed = parse_preferences("format = 1\nlanguage = 7\n", "settings.toml");
    ASSERT_FALSE(parsed);
    EXPECT_EQ(parsed.error().file, "settings.toml");
    EXPECT_EQ(parsed.error().line, 2);
    EXPECT_EQ(parsed.error().what, "'language' should be text in quotes");
    EXPECT_EQ(parsed.error().phrases.size(), 2u) << "it can be translated";
    EXPECT_FALSE(parse_preferences("theme = \"da", "settings.toml"));
}

TEST(Settings, IgnoreKeysOfALaterVersion) {
    EXPECT_TRUE(parse_preferences("format = 2\nholograms = true\n[more]\nx = 1\n", "s"));
}

struct SettingsOnDisk : testing::Test {
    Folder folder;
    fs::path settings = folder / "config" / "settings.toml";
    SettingsFiles files{folder / "config", folder / "state"};
    Preferences preferences;
    StoredState state;
};

TEST_F(SettingsOnDisk, AreReadByTheNextStart) {
    EXPECT_TRUE(files.read(preferences, state).empty());
    add_recent(state, folder / "scene.toml");
    ASSERT_FALSE(files.write(chosen, state));
    SettingsFiles next{folder / "config", folder / "state"};
    EXPECT_TRUE(next.read(preferences, state).empty());
    EXPECT_EQ(preferences, chosen);
    EXPECT_EQ(state.last_opened, (folder / "scene.toml").string());
}

TEST_F(SettingsOnDisk, WriteNoPreferencesBeforeTheUserChangesOne) {
    files.read(preferences, state);
    ASSERT_FALSE(files.write(preferences, state));
    EXPECT_FALSE(fs::exists(settings)) << "the system's language applies until the user chooses one";
}

TEST_F(SettingsOnDisk, RenameABrokenFileAndReportItOnce) {
    const std::string broken = "language = \"d\xff\x00 [[[";
    put_text(settings, broken);
    const auto complaints = files.read(preferences, state);
    ASSERT_EQ(complaints.size(), 1u);
    EXPECT_EQ(complaints[0].file, settings.string());
    ASSERT_FALSE(complaints[0].phrases.empty());
    EXPECT_EQ(complaints[0].phrases.back(), (Phrase{"settings_kept_aside", {"settings.toml.broken"}}));
    EXPECT_EQ(preferences, Preferences{});
    EXPECT_EQ(text_of(folder / "config" / "settings.toml.broken"), broken) << "the text of the user is kept";
    SettingsFiles next{folder / "config", folder / "state"};
    EXPECT_TRUE(next.read(preferences, state).empty()) << "reported once";
}

TEST_F(SettingsOnDisk, SetAsideReplaceNoFileThatWasSetAsideBefore) {
    put_text(folder / "config" / "settings.toml.broken", "first");
    put_text(settings, "[[[");
    const auto complaints = files.read(preferences, state);
    ASSERT_EQ(complaints.size(), 1u);
    EXPECT_EQ(complaints[0].phrases.back(), (Phrase{"settings_kept_aside", {"settings.toml.broken2"}}));
    EXPECT_EQ(text_of(folder / "config" / "settings.toml.broken"), "first");
    EXPECT_EQ(text_of(folder / "config" / "settings.toml.broken2"), "[[[");
}

// The parser alone overflows the stack at the first of these texts, and the second takes its time.
TEST_F(SettingsOnDisk, AreSetAsideWhenTheyAreTooDeepOrTooLarge) {
    std::string dots = "a";
    for (int i = 0; i < 1000000; ++i) dots += ".a";
    const fs::path stored = folder / "state" / "state.toml";
    for (const std::string& text : {dots + " = 1\n", std::string(5u << 20u, '#')})
        for (const fs::path& file : {settings, stored}) {
            put_text(file, text);
            const auto complaints = files.read(preferences, state);
            ASSERT_EQ(complaints.size(), 1u);
            EXPECT_EQ(complaints[0].file, file.string());
            EXPECT_EQ(complaints[0].phrases.back().id, "settings_kept_aside");
            EXPECT_FALSE(fs::exists(file));
            EXPECT_EQ(fs::file_size(file.string() + ".broken"), text.size());
            fs::remove(file.string() + ".broken");
        }
    EXPECT_EQ(preferences, Preferences{});
    EXPECT_EQ(state, StoredState{});
}

TEST(Settings, AreReadableAlsoWithTheNameOfAFileThatIsNoUtf8) {
    StoredState state{.last_opened = "/odd\xFF.toml", .recent = {{"/odd\xFF.toml", "Odd"}}, .folder = "/here"};
    const auto read = parse_state(write_state(state), "s");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->folder, "/here");
    EXPECT_EQ(read->last_opened, "");
}

TEST_F(SettingsOnDisk, ReportAWriteErrorOnce) {
    put_text(folder / "config", "a file where the folder should be");
    files.read(preferences, state);
    EXPECT_TRUE(files.write(chosen, state));
    EXPECT_FALSE(files.write(chosen, state));
}

TEST(Settings, ListEachRecentFileOnceAndTheNewestFirst) {
    StoredState r;
    for (int i = 0; i < 12; ++i) add_recent(r, "/s/" + std::to_string(i) + ".toml");
    add_recent(r, "/s/../s/9.toml");
    EXPECT_EQ(r.recent.size(), most_recent);
    const auto absolute = [](const char* path) { return fs::absolute(path).lexically_normal().string(); };
    EXPECT_EQ(r.recent[0].path, absolute("/s/9.toml"));
    EXPECT_EQ(r.recent[1].path, absolute("/s/11.toml"));
    EXPECT_EQ(std::count(r.recent.begin(), r.recent.end(), RecentFile{absolute("/s/9.toml")}), 1);
}

TEST(Settings, LeaveOutRecentFilesWithoutAPath) {
    const auto state =
        parse_state(R"(recent = [{path = "/a.toml"}, {path = "/b.toml", title = "B"}, 7, {title = "no path"}])", "s");
    ASSERT_TRUE(state);
    EXPECT_EQ(state->recent, (std::vector<RecentFile>{{"/a.toml"}, {"/b.toml", "B"}}));
}

TEST_F(SettingsOnDisk, TheThemeOfTheSystemAppliesUntilAPreferenceIsStored) {
    const auto next = [&] { return read_settings({folder / "config", folder / "state"}, {}, "en", Theme::light); };
    Settings first = next();
    EXPECT_EQ(first.at_start.theme, Theme::light);
    ASSERT_FALSE(save(first, first.at_start, {1280, 800}));
    EXPECT_FALSE(fs::exists(folder / "config" / "settings.toml")) << "nothing is chosen";
    first.at_start.theme = Theme::dark;
    ASSERT_FALSE(save(first, first.at_start, {1280, 800}));
    EXPECT_EQ(next().at_start.theme, Theme::dark);
}

TEST_F(SettingsOnDisk, OverridesApplyToOneStartOnly) {
    preferences.quality = Quality::high;
    ASSERT_FALSE(files.write(preferences, state));
    const auto next = [&](PreferenceOverrides overrides) {
        return read_settings({folder / "config", folder / "state"}, overrides, "en");
    };
    EXPECT_EQ(next({}).at_start.quality, Quality::high);
    Settings measured = next({.has_quality = true});
    EXPECT_EQ(measured.at_start.quality, std::nullopt);
    ASSERT_FALSE(save(measured, measured.at_start, {1280, 800}));
    EXPECT_EQ(next({}).at_start.quality, Quality::high) << "not stored";
    Settings low = next({.has_quality = true, .quality = Quality::low});
    EXPECT_EQ(low.at_start.quality, Quality::low);
    low.at_start.quality = Quality::medium;  // chosen in the window
    ASSERT_FALSE(save(low, low.at_start, {1280, 800}));
    EXPECT_EQ(next({}).at_start.quality, Quality::medium);
}

}  // namespace
}  // namespace braitenlab::tests::settings_test
