// The watched diagram of a lecture, whose letters are larger than the cards and labels that hold them elsewhere.
#include "lecture_on_desk.h"

namespace braitenlab::tests::lecture_diagram_test {

namespace {

// A window and the scale that lecture mode has in it.
struct Size {
    float width, height, scale;
};
constexpr Size sizes[]{{1024, 768, 1.375f}, {1024, 768, 1.6f}, {1280, 800, 1.6f}, {1920, 1080, 2.0f}};

struct Diagram {
    Desk desk;
    Diagram(const Snapshot& now, const Size& size, const std::string& code)
        : desk(size.width, size.height, size.scale, true) {
        desk.strings = speaking(code);
        desk.now = now;
        desk.view.lecture = true;
        desk.view.settings.watching = true;
        desk.view.settings.selection.vehicle = now.vehicles.front().id;
    }
    std::vector<Rect> starting_with(std::string_view id) const {
        std::vector<Rect> found;
        for (const auto& [name, rect] : desk.anchors.all())
            if (name.starts_with(id)) found.push_back(rect);
        return found;
    }
};

// Every page with a diagram, and scenes with neurons.
template <class Check>
void each_diagram(const Check& check) {
    for (const Size& size : sizes)
        for (const std::string& code : shipped_codes()) {
            const auto of = [&](const std::string& name) {
                return name + " " + code + " at " + std::to_string(size.width) + ", scale " +
                       std::to_string(size.scale);
            };
            for (const char* scene : {"5-logic", "tortoise", "7-mnemotrix"}) {
                SCOPED_TRACE(of(scene));
                Diagram diagram(shipped_scene(scene), size, code);
                diagram.desk.frame(5);
                check(diagram);
            }
            for (const char* lecture : {"four-numbers", "wheels-to-neurons"}) {
                LectureView pages = opened_lecture(lecture);
                for (; pages.page < static_cast<int>(pages.lecture->pages.size()); ++pages.page) {
                    pages.step = static_cast<int>(pages.current().steps.size());
                    if (!pages.shows(PagePart::wiring)) continue;
                    SCOPED_TRACE(of(lecture) + ", page " + std::to_string(pages.page + 1));
                    Diagram diagram(first_moment(pages.current()), size, code);
                    diagram.desk.view.pages = &pages;
                    diagram.desk.frame(5);
                    check(diagram);
                }
            }
        }
}

}  // namespace

TEST(LectureDiagram, NoWeightIsOnANodeOrOnAnotherWeight) {
    int labels = 0;
    each_diagram([&](const Diagram& diagram) {
        const auto weights = diagram.starting_with("wire."), nodes = diagram.starting_with("node.");
        EXPECT_GE(nodes.size(), 4u);
        for (std::size_t i = 0; i < weights.size(); ++i, ++labels) {
            EXPECT_TRUE(is_inside(weights[i], diagram.desk.where("canvas"))) << i;
            for (std::size_t j = 0; j < nodes.size(); ++j) EXPECT_FALSE(overlap(weights[i], nodes[j])) << i << " " << j;
            for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(weights[i], weights[j])) << i << " " << j;
        }
    });
    EXPECT_GT(labels, 100);
}

TEST(LectureDiagram, AWeightIsInsideItsLabel) {
    each_diagram([&](const Diagram& diagram) {
        for (const auto& [name, rect] : diagram.desk.anchors.all())
            if (name.starts_with("weight.")) {
                EXPECT_TRUE(is_inside(rect, diagram.desk.where("wire." + name.substr(7)))) << name;
            }
    });
}

TEST(LectureDiagram, TheButtonsOfThePagesAreInTheBarAndTheTitleGivesWay) {
    each_diagram([&](const Diagram& diagram) {
        EXPECT_EQ(diagram.desk.anchors.find("lecture.next") != nullptr, diagram.desk.view.pages != nullptr);
    });
}

TEST(LectureDiagram, WiresOfObstacleSensorsHaveNoLabels) {
    Diagram diagram(shipped_scene("3b-explorer"), sizes[2], "en");
    Desk& desk = diagram.desk;
    desk.frame(5);
    EXPECT_TRUE(desk.anchors.find("weight.RL"));
    EXPECT_EQ(diagram.starting_with("weight.").size(), 4u);
    EXPECT_TRUE(desk.anchors.find("curve.OL-ML"));
    // Where nothing else is the subject they have labels: the pair of obstacle sensors alone.
    Snapshot& now = desk.now;
    auto scene = std::make_shared<Scene>(*now.scene);
    for (Sensor& sensor : scene->kinds[0].sensors) sensor.channel = Channel::obstacle;
    now.scene = scene;
    desk.frame(5);
    EXPECT_GT(diagram.starting_with("weight.").size(), 4u);
}

TEST(LectureDiagram, AWholeNameIsInsideTheBoxOfItsNode) {
    each_diagram([&](const Diagram& diagram) {
        EXPECT_EQ(diagram.desk.shortened, 0);
        for (const Node& node : diagram.desk.now.brains[0]->nodes)
            EXPECT_TRUE(is_inside(diagram.desk.where("name." + node.name), diagram.desk.where("node." + node.name)))
                << node.name;
    });
}

}  // namespace braitenlab::tests::lecture_diagram_test
