#include "core/brain/recogniser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/brain/brain.h"

namespace braitenlab {

namespace {

struct Motors {
    float left = 0, right = 0;
    float turn() const { return right - left; }  // positive: to the left
    float drive() const { return (left + right) / 2; }
};

constexpr float dead = 0.02f;  // of full speed; smaller responses count as none

int sign(float x) { return x > dead ? 1 : x < -dead ? -1 : 0; }

// A brain and the readings of its sensors; the two that get the stimulus are first.
struct Subject {
    Brain brain;
    std::vector<float> sensed;

    // Motor values for constant readings: the values at which the state no longer changes; for a brain that oscillates,
    // the mean over the last of 4 s.
    Motors settle(float left_eye, float right_eye) {
        constexpr int settling_ticks = 180, watched_ticks = 60;
        sensed[0] = left_eye, sensed[1] = right_eye;
        std::vector<float> state(static_cast<std::size_t>(brain.state_size()), 0.0f), before;
        std::array<float, 2> motors{};
        Motors mean;
        for (int t = 0; t < settling_ticks + watched_ticks; ++t) {
            before = state;
            think(brain, sensed, state, motors);
            if (state == before) return {motors[0], motors[1]};
            if (t < settling_ticks) continue;
            mean.left += motors[0] / watched_ticks;
            mean.right += motors[1] / watched_ticks;
        }
        return mean;
    }
};

// The response to a source on one side: full strength in that sensor and half of it in the other.
struct Answer {
    float turn;   // positive: towards the source
    float veer;   // to the left for sources on both sides; 0 for a vehicle that does not move
    float speed;  // positive: faster than in the dark
    bool moves;
};

Answer answer_to(Subject& subject, const Motors& dark, float strength) {
    const Motors left = subject.settle(strength, strength / 2), right = subject.settle(strength / 2, strength);
    const auto moves = [](const Motors& m) { return std::fabs(m.left) > dead || std::fabs(m.right) > dead; };
    const bool moving = moves(left) || moves(right);
    return {.turn = (left.turn() - right.turn()) / 2,
            .veer = moving ? (left.turn() + right.turn()) / 2 - dark.turn() : 0,
            .speed = (left.drive() + right.drive()) / 2 - dark.drive(),
            .moves = moving};
}

// The mean drive for a source on each side.
float drive_towards(Subject& subject, float strength) {
    return (subject.settle(strength, strength / 2).drive() + subject.settle(strength / 2, strength).drive()) / 2;
}

// True if the drive goes through 0 where it changes from forwards to backwards between two strengths, so that the
// vehicle can rest there; it does not where a neuron or a threshold switches.
bool rests_between(Subject& subject, float weak, float strong) {
    constexpr int halvings = 12;
    constexpr float largest_step = 0.1f;  // of full speed
    for (int i = 0; i < halvings; ++i) {
        const float between = (weak + strong) / 2;
        (drive_towards(subject, between) > 0 ? weak : strong) = between;
    }
    return drive_towards(subject, weak) - drive_towards(subject, strong) < largest_step;
}

// The first and last sign other than 0 of a series, and how often the sign changes.
struct Tendency {
    int first = 0, last = 0, turned = 0;
    void add(int sign) {
        if (sign == 0) return;
        if (first == 0) first = sign;
        turned += last != 0 && sign != last;
        last = sign;
    }
};

}  // namespace

const char* name(Character character) {
    switch (character) {
        case Character::still:
            return "still";
        case Character::indifferent:
            return "indifferent";
        case Character::alive:
            return "alive";
        case Character::drowsy:
            return "drowsy";
        case Character::coward:
            return "coward";
        case Character::aggressor:
            return "aggressor";
        case Character::love:
            return "love";
        case Character::explorer:
            return "explorer";
        case Character::orbiting:
            return "orbiting";
        case Character::mixed:
            return "mixed";
    }
    return "";
}

Character recognise(const BrainGraph& graph, const SensorPair& pair, std::span<const Reading> meanwhile) {
    std::vector<std::string> sensors{pair.left, pair.right};
    std::vector<float> sensed{0, 0};
    for (const Reading& reading : meanwhile) {
        if (std::find(sensors.begin(), sensors.end(), reading.sensor) != sensors.end()) continue;
        sensors.push_back(reading.sensor);
        sensed.push_back(reading.value);
    }
    auto brain = compile(graph, sensors);
    if (!brain) return Character::still;
    Subject subject{std::move(*brain), std::move(sensed)};

    constexpr std::array<float, 8> strengths{0.05f, 0.1f, 0.2f, 0.35f, 0.5f, 0.65f, 0.8f, 0.95f};
    const Motors dark = subject.settle(0, 0);
    Tendency turn, speed;
    float turned = 0, veered = 0;
    bool moves = std::fabs(dark.left) > dead || std::fabs(dark.right) > dead, rests = true;
    float last_drive = dark.drive(), last_strength = 0;
    for (const float strength : strengths) {
        const Answer answer = answer_to(subject, dark, strength);
        const float drive = dark.drive() + answer.speed;
        if (last_drive > dead && drive < -dead) rests &= rests_between(subject, last_strength, strength);
        last_drive = drive, last_strength = strength;
        turn.add(sign(answer.turn));
        speed.add(sign(answer.speed));
        turned += std::fabs(answer.turn);
        veered += std::fabs(answer.veer);
        moves |= answer.moves;
    }
    if (veered > turned && sign(veered / static_cast<float>(strengths.size())) != 0) return Character::mixed;
    if (turn.first > 0 && turn.last < 0 && turn.turned == 1) return Character::orbiting;
    if (turn.turned > 0) return Character::mixed;
    if (turn.first > 0 && speed.last < 0 && speed.turned <= 1) return rests ? Character::love : Character::mixed;
    if (speed.turned > 0) return Character::mixed;
    if (turn.first == 0 && speed.first == 0) return moves ? Character::indifferent : Character::still;
    if (turn.first == 0) return speed.first > 0 ? Character::alive : Character::drowsy;
    if (speed.first == 0) return Character::mixed;
    if (turn.first > 0) return Character::aggressor;
    return speed.first > 0 ? Character::coward : Character::explorer;
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
