#include "core/session/session.h"

#include <utility>

#include "core/match.h"

namespace braitenlab {

namespace {

constexpr std::size_t most_edits = 500;  // undo reaches this far back

// Whether the later command makes the earlier one pointless: the same number, brain or pose, set again.
bool supersedes(const Command& later, const Command& earlier) {
    if (later.index() != earlier.index()) return false;
    return std::visit(Match{[&](const TurnDial& c) {
                                const auto& e = std::get<TurnDial>(earlier);
                                return c.target == e.target && c.dial == e.dial;
                            },
                            [&](const SetBrain& c) { return c.target == std::get<SetBrain>(earlier).target; },
                            [&](const MoveVehicle& c) { return c.vehicle == std::get<MoveVehicle>(earlier).vehicle; },
                            [&](const MoveSource& c) { return c.source == std::get<MoveSource>(earlier).source; },
                            [](const auto&) { return false; }},
                      later);
}

void set_own_brains(const Snapshot& now, int kind, std::vector<Command>& commands) {
    for (const VehicleView& v : now.vehicles) {
        const auto& brain = now.brains[static_cast<std::size_t>(v.brain)];
        const auto of_kind = static_cast<std::size_t>(v.kind);
        if ((kind < 0 || v.kind == kind) && *brain != *now.kind_brains[of_kind])
            commands.push_back(SetBrain{{.vehicle = v.id}, *brain});
    }
}

// The commands that bring back the brains that a target has now.
std::vector<Command> restore_brains(const Snapshot& now, const Target& target) {
    std::vector<Command> commands;
    if (const VehicleView* v = find_vehicle(now, target.vehicle)) {
        commands.push_back(SetBrain{target, *now.brains[static_cast<std::size_t>(v->brain)]});
    } else if (target.kind >= 0 && target.kind < static_cast<int>(now.kind_brains.size())) {
        commands.push_back(SetBrain{target, *now.kind_brains[static_cast<std::size_t>(target.kind)]});
        set_own_brains(now, target.kind, commands);
    }
    return commands;
}

}  // namespace

Session::Session(Scene scene, std::uint64_t seed, World world)
    : scene_(std::move(scene)), seed_(seed), world_(std::move(world)) {
    world_.capture(snapshot_);
}

Result<Session> Session::open(const Scene& scene, std::uint64_t seed) {
    auto world = World::create(scene, seed);
    if (!world) return world.error();
    return Session(scene, seed, std::move(*world));
}

// What undoes a command, judged before it is carried out; empty for those that only time or another command takes back.
std::vector<Command> Session::undoing(const Command& command) const {
    return std::visit(Match{[&](const TurnDial& c) { return restore_brains(snapshot_, c.target); },
                            [&](const SetBrain& c) { return restore_brains(snapshot_, c.target); },
                            [&](const MoveVehicle& c) -> std::vector<Command> {
                                const VehicleView* v = find_vehicle(snapshot_, c.vehicle);
                                if (!v) return {};
                                return {MoveVehicle{v->id, v->x, v->y, v->heading}};
                            },
                            [&](const MoveSource& c) -> std::vector<Command> {
                                for (const SourceView& s : snapshot_.sources)
                                    if (s.source == c.source) return {MoveSource{s.source, s.x, s.y}};
                                return {};
                            },
                            [](const auto&) -> std::vector<Command> { return {}; }},
                      command);
}

std::optional<Error> Session::apply(const Command& command, std::uint64_t gesture) {
    std::vector<Command> back = undoing(command);
    if (auto error = world_.apply(command)) return error;
    world_.capture(snapshot_);
    if (back.empty()) return std::nullopt;

    undone_.clear();
    const bool same_gesture = gesture != 0 && !done_.empty() && done_.back().gesture == gesture;
    if (!same_gesture) {
        done_.push_back({std::move(back), {command}, gesture});
        if (done_.size() > most_edits) done_.erase(done_.begin());
        return std::nullopt;
    }
    Edit& edit = done_.back();
    if (undoing(command) == edit.back) {  // the drag is back where it began: there is nothing to undo
        done_.pop_back();
    } else if (supersedes(command, edit.again.back())) {
        edit.again.back() = command;  // what it took back before stays what undo brings back
    } else {
        edit.again.push_back(command);
        edit.back.insert(edit.back.begin(), back.begin(), back.end());  // the latest is taken back first
    }
    return std::nullopt;
}

void Session::carry_out(const std::vector<Command>& commands) {
    // Something may have left the world since the edit; then there is nothing to bring back, and the rest still counts.
    for (const Command& command : commands) (void)world_.apply(command);
    world_.capture(snapshot_);
}

bool Session::undo() {
    if (done_.empty()) return false;
    carry_out(done_.back().back);
    undone_.push_back(std::move(done_.back()));
    done_.pop_back();
    return true;
}

bool Session::redo() {
    if (undone_.empty()) return false;
    carry_out(undone_.back().again);
    done_.push_back(std::move(undone_.back()));
    done_.back().gesture = 0;  // a drag that goes on is a new step
    undone_.pop_back();
    return true;
}

void Session::step() {
    world_.step();
    world_.capture(snapshot_);
}

void Session::reset() {
    Scene scene = scene_;
    for (std::size_t k = 0; k < scene.kinds.size(); ++k) scene.kinds[k].brain = *snapshot_.kind_brains[k];
    std::vector<Command> own_brains;
    set_own_brains(snapshot_, -1, own_brains);
    auto world = World::create(scene, seed_);
    if (!world) return;  // cannot be: every brain in it has compiled before
    world_ = std::move(*world);
    carry_out(own_brains);
}

}  // namespace braitenlab
