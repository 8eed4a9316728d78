#include "render/gl/shader.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "render/gl/renderer.h"
#include "tests/render/stage.h"
#include "tests/view/hand_made.h"

namespace braitenlab::tests::shader_test {
namespace {

using namespace render;

namespace fs = std::filesystem;

class ShaderTest : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(stage.ready()) << stage.problem();
        folder = fs::temp_directory_path() / fmt::format("braitenlab-shaders-{}", getpid());
        fs::remove_all(folder);
        fs::copy(BRAITENLAB_SOURCE "/shaders", folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    void write(const std::string& name, const std::string& text) { std::ofstream(folder / name) << text; }

    Stage stage{64, 64};
    fs::path folder;
};

TEST_F(ShaderTest, ReportsFileAndLineOfAnError) {
    write("floor.frag", "out vec4 colour;\n\nvoid main() {\n    colour = vec4(nonsense);\n}\n");
    const auto renderer = Renderer::create(folder);
    ASSERT_FALSE(renderer);
    EXPECT_EQ(fs::path(renderer.error().file).filename().string(), "floor.frag");
    EXPECT_EQ(renderer.error().line, 4);
    EXPECT_NE(renderer.error().what.find("nonsense"), std::string::npos) << renderer.error().text();
}

TEST_F(ShaderTest, NamesTheSharedHeaderForItsErrors) {
    std::ifstream in(folder / "common.glsl");
    const std::string common(std::istreambuf_iterator<char>(in), {});
    write("common.glsl", "// one line more\nfloat broken() { return nothing; }\n" + common);
    const auto program = Program::load(folder, "floor.vert", "floor.frag");
    ASSERT_FALSE(program);
    EXPECT_EQ(fs::path(program.error().file).filename().string(), "common.glsl") << program.error().text();
    EXPECT_EQ(program.error().line, 2);
}

TEST_F(ShaderTest, ReportsAMissingFile) {
    fs::remove(folder / "wire.vert");
    const auto renderer = Renderer::create(folder);
    ASSERT_FALSE(renderer);
    EXPECT_EQ(fs::path(renderer.error().file).filename().string(), "wire.vert");
}

TEST_F(ShaderTest, ReportsThePairThatDoesNotLink) {
    write("floor.frag", "in vec3 v_place;\nout vec4 colour;\nvoid main() { colour = vec4(v_place, 1.0); }\n");
    const auto program = Program::load(folder, "floor.vert", "floor.frag");
    ASSERT_FALSE(program);
    EXPECT_NE(program.error().text().find("floor.frag"), std::string::npos);
}

// Writes a shader with a later time than all others, for any resolution of the file system's clock.
class FollowShaders : public ShaderTest {
protected:
    void SetUp() override {
        ShaderTest::SetUp();
        renderer.emplace(std::move(*Renderer::create(folder)));
    }
    void TearDown() override {
        renderer.reset();
        ShaderTest::TearDown();
    }
    void save(const std::string& name, const std::string& text) {
        write(name, text);
        later += std::chrono::seconds(2);
        fs::last_write_time(folder / name, fs::file_time_type::clock::now() + later);
    }
    Colour middle() {
        Picture picture;
        const Rect window{0, 0, 64, 64};
        picture.camera_view = look(Camera{}, Arena{}, nullptr, window, window);
        // Often enough that the backdrop stores the ground.
        for (int frame = 0; frame < 3; ++frame) renderer->draw(hand_made::empty(hand_made::scene()), picture);
        return stage.pixel({32, 32});
    }

    std::optional<Renderer> renderer;
    std::chrono::seconds later{0};
};

constexpr const char* red_floor =
    "in vec2 v_place;\nflat in float v_beyond;\nout vec4 colour;\nvoid main() { colour = vec4(1.0, 0.0, 0.0, 1.0); }\n";

TEST_F(FollowShaders, UsesAShaderWhenItIsSaved) {
    EXPECT_LT(middle().r, 0.5f);
    EXPECT_FALSE(renderer->follow_shaders());
    save("floor.frag", red_floor);
    EXPECT_FALSE(renderer->follow_shaders());
    EXPECT_GT(middle().r, 0.9f);
}

TEST_F(FollowShaders, KeepsTheLastValidShadersAndReportsAnErrorOnce) {
    save("floor.frag", red_floor);
    EXPECT_FALSE(renderer->follow_shaders());
    save("floor.frag", "out vec4 colour;\nvoid main() {\n    colour = rubbish;\n}\n");
    const auto error = renderer->follow_shaders();
    ASSERT_TRUE(error);
    EXPECT_EQ(fs::path(error->file).filename().string(), "floor.frag");
    EXPECT_EQ(error->line, 3);
    EXPECT_GT(middle().r, 0.9f);
    EXPECT_FALSE(renderer->follow_shaders()) << "reported once";
    EXPECT_EQ(stage.complaints(), "");
}

TEST(Shader, FirstComplaintReadsTheLogsOfSeveralDrivers) {
    const auto mesa = first_complaint("0:12(5): error: `x' undeclared\n");
    EXPECT_EQ(mesa.line, 12);
    EXPECT_EQ(mesa.what, "error: `x' undeclared");
    const auto nvidia = first_complaint("1(7) : error C1008: undefined variable \"x\"\n");
    EXPECT_EQ(nvidia.line, 7);
    const auto amd = first_complaint("ERROR: 0:31: 'x' : undeclared identifier\n");
    EXPECT_EQ(amd.line, 31);
}

TEST(Shader, FirstComplaintSkipsWarnings) {
    EXPECT_EQ(first_complaint("0:2(1): warning: unused\n0:9(3): error: bad\n").line, 9);
}

TEST(Shader, FirstComplaintKeepsALogOfUnknownForm) {
    EXPECT_EQ(first_complaint("it broke").what, "it broke");
    EXPECT_EQ(first_complaint("it broke").line, 0);
}

}  // namespace
}  // namespace braitenlab::tests::shader_test
