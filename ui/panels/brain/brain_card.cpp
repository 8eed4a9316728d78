// The card of the selected vehicle's brain: name, recognised character, sliders, motor sums and the brain picture.
// When the user or a script drives the vehicle, a stick or a note takes the place of the sums.
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <imgui.h>

#include "core/scene/enums.h"
#include "core/scene/sensor_edits.h"
#include "ui/imgui_compat.h"
#include "ui/panels/cards.h"
#include "ui/panels/exercise_names.h"
#include "ui/panels/offered.h"
#include "ui/panels/panels.h"
#include "ui/panels/prompt_run.h"
#include "ui/panels/sensor_changes.h"
#include "ui/shortcuts.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/wiring/node_text.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

// Layout pixels. In a lower column the picture is smaller, and the rows are closer for a vehicle with many; in the
// lowest they are closer for each.
constexpr float low_column = 680, lowest_column = 650;
constexpr float stick_size = 88;  // layout pixels

// True for a name that a start gets without a person choosing it: "one", "hunter" and "hunter-2" for the kind hunter.
bool is_given_name(const std::string& name, const std::string& kind) {
    constexpr std::array numbers{"one", "two", "three", "four", "five"};
    if (std::find(numbers.begin(), numbers.end(), name) != numbers.end() || name == kind) return true;
    return name.starts_with(kind + "-") && name.find_first_not_of("0123456789", kind.size() + 1) == std::string::npos;
}

// The name that a person gave to the vehicle; empty without one, and in an exercise, whose steps use the names.
std::string own_name(const LabView& view, const VehicleView& vehicle) {
    if (view.lesson || hides_names(view)) return {};
    std::string name = look_of(*view.now, vehicle).label;
    if (vehicle.start < 0) return name;
    if (is_given_name(name, kind_of(*view.now, vehicle).name)) return {};
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

// That of the characters and drivers; window pixels.
float widest_chip(const Ui& ui) {
    float widest = 0;
    const auto take = [&](const std::string& word) { widest = std::max(widest, chip_width(ui, ui.strings(word))); };
    for (int i = 0; i <= static_cast<int>(Character::mixed); ++i)
        take("character." + std::string(name(static_cast<Character>(i))));
    take("character.hidden"), take("character.parts"), take("character.single_sensors"), take("brain.secret");
    for (const Driver driver : {Driver::manual, Driver::path, Driver::wander, Driver::parked})
        take("driver." + std::string(word(driver)));
    return widest;
}

// "Sensors 3 · neurons 2 · wires 5"
std::string parts_of(const Ui& ui, const BrainGraph& brain) {
    const auto count = [&](NodeKind kind) {
        return std::to_string(std::count_if(brain.nodes.begin(), brain.nodes.end(),
                                            [kind](const Node& node) { return node.kind == kind; }));
    };
    const auto wires =
        std::count_if(brain.wires.begin(), brain.wires.end(), [](const Wire& wire) { return wire.weight != 0; });
    return fill(ui.strings("brain.parts"), {count(NodeKind::sensor), count(NodeKind::neuron), std::to_string(wires)});
}

// "flees heat", "slows near obstacles and turns away".
std::string response(const Ui& ui, Character character, Channel channel) {
    const std::string of_channel(word(channel)), named(name(character));
    const std::string_view own = ui.strings.find("response_to." + named + "_" + of_channel, {});
    return own.empty() ? fill(ui.strings("response." + named), {ui.strings("sense." + of_channel)}) : std::string(own);
}

// What the brain does with each pair ("attacks light, flees heat"). Nothing for one pair, whose character is in the
// title row.
std::string description(const Ui& ui, const Recognised& known) {
    const auto wired =
        std::count_if(known.pairs.begin(), known.pairs.end(), [](const PairCharacter& each) { return each.is_wired; });
    if (wired < 2) return {};
    std::vector<std::string> said;  // once for pairs that do the same
    for (const PairCharacter& each : known.pairs)
        if (std::string words = response(ui, each.character, each.pair.channel);
            each.is_wired && std::find(said.begin(), said.end(), words) == said.end())
            said.push_back(std::move(words));
    std::string all;
    for (const std::string& words : said) all += (all.empty() ? "" : ", ") + words;
    return all;
}

// Role sign, name, and the recognised character as a chip.
void title_row(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = line_height(ui, Face::title), size = ui.px(spacing::large), width = card_width(ui);
    put_role(ui, {at.x + size / 2, at.y + height / 2}, size, vehicle.role, colour_of(ui.palette, *view.now, vehicle));
    std::string title = kind_name(view, ui, vehicle) + " " + std::to_string(vehicle.id + 1);
    if (const std::string own = own_name(view, vehicle); !own.empty()) title += " · " + own;
    // When the brain does not drive the vehicle, the chip names the driver.
    const bool thinks = vehicle.driver == Driver::brain;
    const Recognised& known = recognised(state.brain.recognised, *view.now, vehicle, view.wall_seconds);
    const std::string_view character = !thinks ? word(vehicle.driver)
                                       : hides_character(view, vehicle)
                                           ? "hidden"
                                           : character_key(known, *view.now, vehicle, shown_pair(view, vehicle));
    const bool secret = thinks && is_brain_secret(view, vehicle.kind);
    const std::string_view label =
        secret ? ui.strings("brain.secret")
               : ui.strings.find((thinks ? "character." : "driver.") + std::string(character), character);
    const float left = at.x + size + ui.px(spacing::small),
                room = at.x + width - left - ui.px(spacing::small) - widest_chip(ui);
    const Face face = text_width(ui, Face::title, title) > room ? Face::strong : Face::title;
    const float name_width = text_width(ui, face, title);
    // Without room for the widest chip, the chip is below the name, so that another character does not move it.
    const bool below = name_width > room;
    const float chip_middle = below ? height + ui.px(spacing::large) : height / 2;
    put(ui, {left, at.y + (height - line_height(ui, face)) / 2}, shortened(ui, title, face, at.x + width - left),
        ui.palette.text, face);
    chip(ui, {below ? left : left + name_width + ui.px(spacing::small), at.y + chip_middle}, label);
    const Item row = item(ui, "brain.character", {width, below ? height + ui.px(2 * spacing::large) : height}, false);
    if (row.hovered && secret) return tooltip(ui, row, ui.strings("brain.hidden"));
    if (!row.hovered) return;
    std::string story(ui.strings((thinks ? "character_story." : "drive.") + std::string(character)));
    if (thinks && character != "hidden") story += "\n" + parts_of(ui, *brain_of(*view.now, vehicle));
    if (const std::string words = description(ui, known); thinks && has_close_rows(view, ui) && !words.empty())
        story = words + "\n" + story;
    tooltip(ui, row, story);
}

// The lines that the description always takes, so that the sliders below stay where they are while an edit changes the
// sentence: one for each pair of sensors, at most three. Of one pair nothing is said.
std::size_t lines_of_description(const LabView& view, const VehicleView& vehicle) {
    const std::size_t pairs = sensor_pairs(kind_of(*view.now, vehicle)).size();
    return pairs >= 2 ? std::min<std::size_t>(pairs, 3) : 0;
}

// The space between the rows, in layout pixels. It depends on nothing that an edit of the brain changes.
float space_of_rows(const LabView& view, const Ui& ui, const VehicleView& vehicle, Rect column) {
    const bool has_many = sensor_pairs(kind_of(*view.now, vehicle)).size() >= 3;
    if (has_close_rows(view, ui)) return spacing::hair;
    return column.h < ui.px(has_many ? low_column : lowest_column) ? spacing::tight : spacing::small;
}

// The words, or what fits into `count` lines with an ellipsis.
std::string fitting_lines(const Ui& ui, const std::string& words, std::size_t count) {
    const std::vector<std::string> lines = lines_of_words(ui, words, Face::label, card_width(ui));
    if (lines.size() <= count) return words;
    std::string text, last;
    for (std::size_t i = 0; i < lines.size(); ++i)
        (i + 1 < count ? text : last) += lines[i] + (i + 1 < count ? '\n' : ' ');
    return text + shortened(ui, last, Face::label, card_width(ui));
}

// The description, in as many lines as it always takes; all of it is the tooltip. Before a prediction it takes the same
// room without words, so that nothing moves once the run has begun.
void describe_brain(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle) {
    const std::string words = description(ui, state.brain.recognised);
    const std::size_t lines = std::max<std::size_t>(lines_of_description(view, vehicle), words.empty() ? 0 : 1);
    if (lines == 0) return;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float height = static_cast<float>(lines) * line_height(ui, Face::label);
    if (!words.empty() && !hides_outcome(view)) {
        const std::string shown = fitting_lines(ui, words, lines);
        paragraph(ui, shown, ui.palette.second_text, Face::label);
        ImGui::SetCursorScreenPos(start);
        const Item at = item(ui, "brain.description", {card_width(ui), height}, false);
        if (shown != words) tooltip(ui, at, words);
    }
    ImGui::SetCursorScreenPos(start);
    ImGui::Dummy({1, height});
}

// The parts of a brain that no word describes, at the end of the card, where they move nothing.
void say_parts(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle) {
    const Recognised& known = state.brain.recognised;
    if (!description(ui, known).empty() || shown_character(known, *view.now, vehicle, shown_pair(view, vehicle)))
        return;
    paragraph(ui, parts_of(ui, *brain_of(*view.now, vehicle)), ui.palette.second_text, Face::label);
}

struct PairToChoose {
    KindPair pair;
    bool is_mirrored = true;
};

// The pairs of the kind, and SL and SR, which the sliders set without a chosen pair, also where they are no mirror
// images of each other: a breeding turns each eye by itself.
std::vector<PairToChoose> pairs_to_choose(const Kind& kind) {
    std::vector<PairToChoose> all;
    for (const KindPair& pair : sensor_pairs(kind)) all.push_back({pair});
    const SensorPair usual{};
    const Sensor *left = find_sensor(kind.sensors, usual.left), *right = find_sensor(kind.sensors, usual.right);
    const bool is_listed =
        std::any_of(all.begin(), all.end(), [&](const PairToChoose& each) { return each.pair.sensors == usual; });
    if (is_listed || !left || !right || left->channel != right->channel) return all;
    const std::string channel(word(left->channel));
    const bool is_taken =
        std::any_of(all.begin(), all.end(), [&](const PairToChoose& each) { return each.pair.name == channel; });
    // With a name that no pair has the usual one is chosen.
    all.insert(all.begin(), {{is_taken ? usual.left : channel, left->channel, usual}, false});
    return all;
}

// A button for each pair of sensors; the sliders set the wires of the chosen one.
void pair_choice(const LabView& view, Ui& ui, const VehicleView& vehicle) {
    const std::vector<PairToChoose> pairs = pairs_to_choose(kind_of(*view.now, vehicle));
    if (pairs.size() < 2) return;
    const SensorPair shown = shown_pair(view, vehicle);
    const std::vector<Sensor>& sensors = kind_of(*view.now, vehicle).sensors;
    const auto label = [&](const std::string& name) {
        const auto found =
            std::find_if(sensors.begin(), sensors.end(), [&](const Sensor& sensor) { return sensor.name == name; });
        return found == sensors.end() ? name : sensor_label(ui, sensors, *found);
    };
    const float space = ui.px(spacing::tight), right = ImGui::GetCursorScreenPos().x + card_width(ui);
    const auto words_of = [&](const KindPair& pair) {
        std::string words(ui.strings("view.channel." + std::string(word(pair.channel))));
        if (const auto number = pair.name.find(' '); number != std::string::npos) words += pair.name.substr(number);
        return words;
    };
    float row = -space;
    for (const auto& [pair, is_mirrored] : pairs)
        row += space + small_button_width(ui, {"", wiring::channel_symbol(pair.channel), words_of(pair)}, true);
    // Where the words do not fit into one row, only the shown pair has its word.
    const bool all_words = row <= card_width(ui) || !has_icons(ui);
    bool is_first = true;
    for (const auto& [pair, is_mirrored] : pairs) {
        const std::string id = "pair." + pair.name, words = words_of(pair);
        const SmallButton look{id, wiring::channel_symbol(pair.channel), words, pair.sensors == shown};
        const bool has_words = all_words || look.on;
        if (!is_first && ImGui::GetItemRectMax().x + space + small_button_width(ui, look, has_words) <= right)
            ImGui::SameLine(0, space);
        is_first = false;
        const Item at = small_button(ui, look, has_words);
        tooltip(ui, at,
                fill(ui.strings(is_mirrored ? "tooltip.pair" : "tooltip.pair_uneven"),
                     {label(pair.sensors.left), label(pair.sensors.right)}));
        if (at.pressed) ui.outbox.push_back(PairRequest{pair.name});
    }
}

// A sensor for a brain that reads this name: that of the vehicle's kind now or in the file, else one that fits the
// name.
Sensor sensor_to_add(const LabView& view, const VehicleView& vehicle, const std::string& name) {
    const Kind& kind = view.now->scene->kinds[static_cast<std::size_t>(vehicle.kind)];
    for (const Kind* source : {&kind, filed_kind(view, vehicle)})
        if (source)
            for (const Sensor& sensor : source->sensors)
                if (sensor.name == name) return sensor;
    return sensor_named(name);
}

// True if the brain reads the sensor by a wire with an effect: one with a weight, or one that can learn it.
bool has_effect(const BrainGraph& brain, const std::string& sensor) {
    const Node* node = find_node(brain, sensor);
    return node && std::any_of(brain.wires.begin(), brain.wires.end(), [&](const Wire& wire) {
               return wire.from == node->id && (wire.weight != 0 || wire.learning_rate > 0);
           });
}

// A brain from another vehicle or file can read sensors that this vehicle does not have. A button adds them.
void missing_sensors_note(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle) {
    const Kind& kind = kind_of(*view.now, vehicle);
    std::vector<Sensor> added;
    const BrainGraph& brain = *brain_of(*view.now, vehicle);
    for (const std::string& sensor : missing_sensors(brain, kind))
        if (has_effect(brain, sensor)) added.push_back(sensor_to_add(view, vehicle, sensor));
    if (added.empty()) return;
    std::string names;
    for (const Sensor& sensor : added) names += (names.empty() ? "" : ", ") + sensor_label(ui, added, sensor);
    paragraph(ui, fill(ui.strings("brain.missing_sensors"), {names}), ui.palette.second_text, Face::small);
    if (small_push_button(ui, {"brain.add_sensors", icon::add, ui.strings("brain.add_sensors")},
                          ui.strings("brain.add_sensors_how")))
        request_sensors(view, ui.outbox, vehicle, with_sensors(kind.sensors, added),
                        gestures::panels + ++state.sliders.gesture);
}

// A line that is there, without words, as soon as edits apply to this vehicle alone.
void own_brain_note(const LabView& view, Ui& ui, const VehicleView& vehicle) {
    const auto same = [&](const VehicleView& other) { return other.kind == vehicle.kind; };
    if (std::count_if(view.now->vehicles.begin(), view.now->vehicles.end(), same) < 2) return;
    const auto& of_kind = view.now->kind_brains;
    const auto number = static_cast<std::size_t>(vehicle.kind);
    const bool has_own = number < of_kind.size() && *brain_of(*view.now, vehicle) != *of_kind[number];
    const std::string_view words = ui.strings("brain.own");
    if (has_own) return paragraph(ui, words, ui.palette.second_text, Face::small);
    if (view.settings.selection.whole_kind) return;
    // The first edit of this vehicle alone moves no slider.
    const std::string text = wrapped_at_spaces(ui, Face::small, words, card_width(ui));
    const auto lines = static_cast<float>(1 + std::count(text.begin(), text.end(), '\n'));
    ImGui::Dummy({1, lines * line_height(ui, Face::small)});
}

struct Push {
    float right = 0, ahead = 0;  // −1..1
};

// The position of the stick that gives these wheel commands.
Push push_of(const VehicleView& vehicle) {
    return {std::clamp(vehicle.motor[0] - vehicle.motor[1], -1.0f, 1.0f),
            std::clamp((vehicle.motor[0] + vehicle.motor[1]) / 2, -1.0f, 1.0f)};
}

Push pushed_by_pointer(const Item& at) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const float reach = at.rect.w / 2;
    return {std::clamp((mouse.x - at.middle_x()) / reach, -1.0f, 1.0f),
            std::clamp((at.middle_y() - mouse.y) / reach, -1.0f, 1.0f)};
}

void draw_stick(const Ui& ui, const Item& at, Push push) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const Palette& p = ui.palette;
    fill_box(ui, at.rect, p.ground.with_alpha(0.45f));
    line_box(ui, at.rect, p.line);
    const ImVec2 middle{at.middle_x(), at.middle_y()};
    const float reach = at.rect.w / 2 - ui.px(16), edge = at.rect.w / 2 - ui.px(8), half = ui.px(4);
    for (const ImVec2 to : {ImVec2{0, -1}, ImVec2{0, 1}, ImVec2{-1, 0}, ImVec2{1, 0}}) {
        const ImVec2 tip{middle.x + to.x * edge, middle.y + to.y * edge}, across{to.y * half, to.x * half};
        const ImVec2 foot{tip.x - to.x * half, tip.y - to.y * half};
        draw.AddTriangleFilled(tip, {foot.x + across.x, foot.y + across.y}, {foot.x - across.x, foot.y - across.y},
                               paint(p.second_text));
    }
    const ImVec2 knob{middle.x + push.right * reach, middle.y - push.ahead * reach};
    draw.AddLine(middle, knob, paint(p.second_text), ui.px(3));
    draw.AddCircleFilled(knob, ui.px(11), paint(mix(p.raised, p.accent, 0.25f + 0.5f * at.warmth)));
    draw.AddCircle(knob, ui.px(11), paint(p.accent), 0, ui.px(1.5f));
}

// The stick drives the vehicle while it is held and stops the vehicle when it is released.
void stick(PanelState& state, Ui& ui, const VehicleView& vehicle) {
    const Item at = item(ui, "drive.stick", {ui.px(stick_size), ui.px(stick_size)});
    Push push = push_of(vehicle);
    if (at.held) {
        push = pushed_by_pointer(at);
        const Steer wanted = steer(vehicle.id, push.right, push.ahead);
        if (wanted != state.brain.steered) ui.outbox.push_back(EditRequest{wanted});
        state.brain.steered = wanted;
    } else if (state.brain.stick_held) {
        state.brain.steered = steer(vehicle.id, 0, 0);
        ui.outbox.push_back(EditRequest{state.brain.steered});
    }
    state.brain.stick_held = at.held;
    draw_stick(ui, at, push);
    tooltip(ui, at, ui.strings("drive.stick"));
}

// The name of the driver, and a button that lets the brain drive again.
void driver_note(PanelState& state, Ui& ui, const VehicleView& vehicle, float width) {
    ImGui::BeginGroup();
    const std::string key = "drive." + std::string(word(vehicle.driver));
    paragraph(ui, ui.strings(key), ui.palette.text, Face::small, width);
    const SmallButton back{"drive.back", {}, ui.strings("drive.back")};
    const bool fits = small_button_width(ui, back, true) <= width;
    if (!fits) compat::end_group();  // below the stick
    if (small_push_button(ui, back, ui.strings("tooltip.drive_back")))
        ui.outbox.push_back(
            EditRequest{ChooseDriver{vehicle.id, Driver::brain}, gestures::panels + ++state.sliders.gesture});
    if (fits) compat::end_group();
}

// In an exercise that offers some controls: a button that shows all of them, or only the offered ones again.
void free_play_row(const LabView& view, Ui& ui) {
    if (!view.lesson || offers_all(*view.lesson->exercise)) return;
    gap(ui, spacing::tight);
    const bool free = view.lesson->attempt.work.free_play;
    if (small_push_button(
            ui, {"button.free_play", {}, ui.strings(free ? "exercise.offered_only" : "exercise.free_play"), free},
            ui.strings("exercise.free_play_how")))
        ui.outbox.push_back(FreePlayRequest{!free});
    if (!offers(*view.lesson->exercise, offer_parts::wiring) || view.mode == Mode::wiring) return;
    ImGui::SameLine(0, ui.px(spacing::tight));
    if (small_push_button(ui, {"button.open_wiring", icon::wiring, ui.strings("exercise.open_wiring")},
                          ui.strings("exercise.open_wiring_how")))
        ui.outbox.push_back(Action::wiring);
}

void driver_panel(PanelState& state, Ui& ui, const VehicleView& vehicle) {
    float width = card_width(ui);
    if (vehicle.driver == Driver::manual) {
        stick(state, ui, vehicle);
        ImGui::SameLine(0, ui.px(spacing::medium));
        width -= ui.px(stick_size + spacing::medium);
    }
    driver_note(state, ui, vehicle, width);
}

// The string key of what the card says without a vehicle.
std::string_view no_brain_text(const LabView& view) {
    if (is_subject_gone(view)) return "brain.gone";
    return view.now->vehicles.empty() ? "brain.empty_scene" : "brain.no_vehicle";
}

// True if a vehicle alone of its kind is shown from several starts at once: no row appears then.
bool is_alone_in_exercise(const LabView& view, const VehicleView& vehicle) {
    if (!view.lesson || !view.lesson->together) return false;
    const std::vector<Start>& starts = view.lesson->exercise->scene.starts;
    const std::string& kind = kind_of(*view.now, vehicle).name;
    return std::count_if(starts.begin(), starts.end(), [&](const Start& start) { return start.kind == kind; }) == 1;
}

// The room of the picture while the prediction hides it, so that nothing is new there but the picture.
void hidden_picture(const LabView& view, Ui& ui, float layout_height) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect box{at.x, at.y, card_width(ui), ui.px(layout_height)};
    fill_box(ui, box, ui.palette.ground.with_alpha(0.45f));
    const float inset = ui.px(spacing::small);
    ImGui::SetCursorScreenPos({at.x + inset, at.y + inset});
    paragraph(ui, ui.strings(way_to_brain(view)), ui.palette.second_text, Face::small, box.w - 2 * inset);
    ImGui::SetCursorScreenPos(at);
    ImGui::Dummy({box.w, box.h});
}

// The name of the vehicle, which does not scroll. Of another vehicle or document the card is at its top.
void brain_head(const LabView& view, PanelState& state, Ui& ui, const VehicleView* vehicle, Rect place) {
    if (vehicle) title_row(view, state, ui, *vehicle);
    end_head(ui, state.card(Card::brain), place);
    const VehicleId shown = vehicle ? vehicle->id : no_vehicle;
    const bool is_other_run = std::exchange(state.brain.shown_run, view.run_id) != view.run_id;
    if (std::exchange(state.brain.shown_vehicle, shown) != shown || is_other_run) ImGui::SetScrollY(0);
}

}  // namespace

void scope_choice(const LabView& view, Ui& ui, const VehicleView& vehicle, std::string_view id, std::string_view how) {
    const auto same = [&](const VehicleView& other) { return other.kind == vehicle.kind; };
    if (std::count_if(view.now->vehicles.begin(), view.now->vehicles.end(), same) < 2) return;
    if (is_alone_in_exercise(view, vehicle)) return;
    const std::string kind = kind_of(*view.now, vehicle).name;
    const std::array words{ui.strings("scope.one"), ui.strings.find("kind_all." + kind, ui.strings("scope.all"))};
    const int chosen = segments(ui, id, words, view.settings.selection.whole_kind ? 1 : 0, card_width(ui), how);
    if (chosen >= 0) ui.outbox.push_back(ScopeRequest{chosen == 1});
}

std::string kind_name(const Ui& ui, const Kind& kind) {
    std::string name(ui.strings.find("kind." + kind.name, kind.name));
    if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
    return name;
}

std::string kind_name(const LabView& view, const Ui& ui, const VehicleView& vehicle) {
    const bool is_plain = vehicle.role == Role::none && (view.now->scene->kinds.size() == 1 || hides_names(view));
    return is_plain ? std::string(ui.strings("kind.vehicle")) : kind_name(ui, kind_of(*view.now, vehicle));
}

// Layout pixels: both equations with the cause; one line of it; its two lines.
constexpr float sums_height = 104, cause_height = 28, whole_cause_height = 46;

// True if less than this height (layout pixels) is left in the column. A card is not scrolled in a lecture.
bool would_be_cut(const Ui& ui, float height, Rect column) {
    const float top = ImGui::GetCursorScreenPos().y + ImGui::GetScrollY();
    return top + ui.px(height + spacing::medium) > column.y + column.h;
}

// The lowest end of the card: above the folded card of information where that is below. Window pixels.
float bottom_of_card(const LabView& view, const Ui& ui, Rect column) {
    const bool has_card_below = traits(Card::information).shown(view);
    return column.y + column.h - (has_card_below ? folded_height(ui) + ui.px(spacing::medium) : 0);
}

void brain_card(const LabView& view, PanelState& state, Ui& ui, Rect place, Rect column) {
    const VehicleView* vehicle = selected_vehicle(view);
    const std::string keys = key_name(Action::drive, ui.strings);
    const bool by_hand = vehicle && vehicle->driver == Driver::manual;
    std::array buttons{
        HeadingButton{"button.presets", ui.strings("button.presets"), ui.strings("tooltip.presets")},
        HeadingButton{"button.drive", ui.strings("button.drive"), ui.strings("tooltip.drive"), keys, by_hand},
        HeadingButton{"button.controls", "…", ui.strings("lecture.controls"), {}, state.lecture.controls}};
    const bool has_controls = shows_controls(view, state);
    const std::size_t first = vehicle && !offers_some(view) && has_controls ? 0 : 2, last = view.lecture ? 3 : 2;
    CardState& card = state.card(Card::brain);
    if (!card.head) card.head = 0;
    const bool open = open_card(state, ui, Card::brain, place, std::span(buttons).subspan(first, last - first));
    if (open) brain_head(view, state, ui, vehicle, place);
    if (buttons[2].pressed) state.lecture.controls = !state.lecture.controls;
    if (open && !vehicle) paragraph(ui, ui.strings(no_brain_text(view)), ui.palette.second_text);
    const bool unrevealed = !view.settings.revealed.brain;
    if (open && vehicle && (unrevealed || is_brain_secret(view, vehicle->kind))) {
        paragraph(ui, ui.strings(unrevealed ? "wiring.hidden" : "brain.hidden"), ui.palette.second_text);
    } else if (open && vehicle) {
        const float between = ui.px(space_of_rows(view, ui, *vehicle, column));
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(spacing::small), between});
        if (buttons[1].pressed) {
            ui.outbox.push_back(Action::drive);
            state.keyboard.focus.clear();  // the arrow keys then drive the vehicle
        }
        const bool has_wires = !offers_some(view) || !brain_of(*view.now, *vehicle)->wires.empty();
        const bool tells = !hides_outcome(view) && has_wires;
        const bool is_tight = has_close_rows(view, ui);  // then the tooltip of the name describes the brain
        if (vehicle->driver == Driver::brain && has_wires && !view.lecture && !is_tight)
            describe_brain(view, state, ui, *vehicle);
        missing_sensors_note(view, state, ui, *vehicle);
        if (!view.lecture) scope_choice(view, ui, *vehicle, "scope", ui.strings("scope.how"));
        own_brain_note(view, ui, *vehicle);
        pair_choice(view, ui, *vehicle);
        dial_sliders(view, state, ui, *vehicle);
        const float height = is_tight && !offers_some(view) ? 84 : column.h < ui.px(low_column) ? 90 : 116;
        const float of_picture = brain_picture_height(view, *vehicle, height);
        // What explains the wheels comes before what there is no room for without scrolling.
        const bool sums_first =
            is_tight && vehicle->driver == Driver::brain && tells && would_be_cut(ui, sums_height + of_picture, column);
        if (has_controls && !sums_first) free_play_row(view, ui);
        if (!is_tight) gap(ui, spacing::small);
        const bool shows_sums =
            vehicle->driver == Driver::brain && tells && !(view.lecture && would_be_cut(ui, sums_height, column));
        if (vehicle->driver != Driver::brain) driver_panel(state, ui, *vehicle);
        if (shows_sums) equations(view, ui, *vehicle);
        const float bottom = bottom_of_card(view, ui, column);
        const auto cause = [&] {  // its length changes during a run
            if (shows_sums) cause_in_words(view, ui, *vehicle, bottom, has_controls);
        };
        // In an exercise above the picture where it would be cut below it.
        const float end_of_cause = ImGui::GetCursorScreenPos().y + ImGui::GetScrollY() +
                                   ui.px(of_picture + whole_cause_height + spacing::medium);
        const bool cause_first =
            sums_first || (shows_sums && offers_some(view) && !view.lecture && end_of_cause > bottom);
        if (cause_first) {
            const float below = ImGui::GetCursorPosY() + 2 * line_height(ui, Face::small) + between;
            cause();
            ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), below));
        }
        if (sums_first && has_controls) free_play_row(view, ui);
        // The wiring canvas shows the same brain larger.
        const float below = shows_sums ? cause_height : 0;
        if (view.mode != Mode::wiring && !hides_brain(view, vehicle->kind) &&
            !(view.lecture && would_be_cut(ui, of_picture + below, column)))
            brain_picture(view, state, ui, *vehicle, height);
        else if (view.mode != Mode::wiring && hides_brain(view, vehicle->kind) && !view.lecture)
            hidden_picture(view, ui, of_picture);
        if (!cause_first) cause();
        if (shows_sums && !view.lecture) say_parts(view, state, ui, *vehicle);
        const bool wanted = std::exchange(state.brain.presets.wanted, false) || buttons[0].pressed;
        ImGui::PopStyleVar();
        presets_menu(view, state, ui, *vehicle, wanted,
                     {place.x + place.w - ui.px(spacing::large), place.y + ui.px(spacing::medium + spacing::wide)});
    }
    end_card(ui, card);
}

}  // namespace braitenlab::ui
