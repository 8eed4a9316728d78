#include "core/brain/recogniser.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/brain/brain.h"

namespace braitenlab {

namespace {

struct Motors {
    float left = 0, right = 0;
    float turn() const { return right - left; }  // positive: to the left
    float drive() const { return (left + right) / 2; }
};

// What the motors settle to when the eyes rest at these values: the mean over the last second of four, so that a brain
// that oscillates counts by its average.
Motors settle(const Brain& brain, float left_eye, float right_eye) {
    constexpr int settling_ticks = 180, watched_ticks = 60;
    const std::array<float, 2> eyes{left_eye, right_eye};
    std::vector<float> neurons(static_cast<std::size_t>(brain.state_size()), 0.0f);
    std::array<float, 2> motors{};
    Motors mean;
    for (int t = 0; t < settling_ticks + watched_ticks; ++t) {
        think(brain, eyes, neurons, motors);
        if (t < settling_ticks) continue;
        mean.left += motors[0] / watched_ticks;
        mean.right += motors[1] / watched_ticks;
    }
    return mean;
}

int sign(float x, float dead) { return x > dead ? 1 : x < -dead ? -1 : 0; }

}  // namespace

const char* name(Character character) {
    switch (character) {
        case Character::still:
            return "still";
        case Character::indifferent:
            return "indifferent";
        case Character::alive:
            return "alive";
        case Character::coward:
            return "coward";
        case Character::aggressor:
            return "aggressor";
        case Character::love:
            return "love";
        case Character::explorer:
            return "explorer";
        case Character::mixed:
            return "mixed";
    }
    return "";
}

Character recognise(const BrainGraph& graph) {
    const std::array<std::string, 2> eyes{"SL", "SR"};
    const auto brain = compile(graph, eyes);
    if (!brain) return Character::still;

    // A source on one side is strong in that eye and faint in the other, at three distances.
    constexpr float dead = 0.02f;  // less than 1/50 of full speed is no answer
    constexpr std::array<float, 3> strengths{0.25f, 0.5f, 0.8f};
    constexpr float other_eye = 0.5f;
    const Motors dark = settle(*brain, 0, 0);
    int turns = 0, speeds = 0;  // towards and faster positive
    bool turned_both_ways = false, sped_both_ways = false, answered = false, moved = false;
    for (const float s : strengths) {
        const Motors left = settle(*brain, s, s * other_eye), right = settle(*brain, s * other_eye, s);
        const int turn = sign((left.turn() - right.turn()) / 2, dead);  // to the side that the source is on
        const int speed = sign((left.drive() + right.drive()) / 2 - dark.drive(), dead);
        turned_both_ways |= turn * turns < 0;
        sped_both_ways |= speed * speeds < 0;
        if (turn != 0) turns = turn;
        if (speed != 0) speeds = speed;
        answered |= turn != 0 || speed != 0;
        moved |= std::fabs(left.drive()) > dead || std::fabs(right.drive()) > dead;
    }
    const bool moves_in_the_dark = std::fabs(dark.left) > dead || std::fabs(dark.right) > dead;
    if (!answered) return moved || moves_in_the_dark ? Character::indifferent : Character::still;
    if (turned_both_ways || sped_both_ways) return Character::mixed;
    if (turns == 0) return speeds > 0 ? Character::alive : Character::mixed;
    if (speeds == 0) return Character::mixed;
    if (turns > 0) return speeds > 0 ? Character::aggressor : Character::love;
    return speeds > 0 ? Character::coward : Character::explorer;
}

int attraction(Character character) {
    switch (character) {
        case Character::aggressor:
        case Character::love:
            return 1;
        case Character::coward:
        case Character::explorer:
            return -1;
        default:
            return 0;
    }
}

}  // namespace braitenlab
