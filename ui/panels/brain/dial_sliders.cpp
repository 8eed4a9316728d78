// The sliders of the four-neuron brain: weights with their thresholds, and biases. Two buttons mirror and cross the
// wires.
#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include <imgui.h>

#include "core/brain/four_neurons.h"
#include "core/scene/sensor_edits.h"
#include "ui/panels/brain/brain_layout.h"
#include "ui/panels/offered.h"
#include "ui/panels/panels.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/wiring/node_text.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

struct DialSlider {
    Dial dial;
    std::string_view anchor, tooltip;
};

constexpr DialSlider weight_sliders[]{{Dial::LL, "slider.LL", "dial.LL"},
                                      {Dial::LR, "slider.LR", "dial.LR"},
                                      {Dial::RL, "slider.RL", "dial.RL"},
                                      {Dial::RR, "slider.RR", "dial.RR"}};
constexpr DialSlider threshold_sliders[]{{Dial::threshold_LL, "threshold.LL", "dial.threshold"},
                                         {Dial::threshold_LR, "threshold.LR", "dial.threshold"},
                                         {Dial::threshold_RL, "threshold.RL", "dial.threshold"},
                                         {Dial::threshold_RR, "threshold.RR", "dial.threshold"}};
constexpr DialSlider bias_sliders[]{{Dial::LM, "bias.LM", "dial.LM"}, {Dial::RM, "bias.RM", "dial.RM"}};

const DialSlider& slider_of(Dial dial) {
    for (const std::span<const DialSlider> sliders :
         {std::span<const DialSlider>(weight_sliders), std::span<const DialSlider>(threshold_sliders)})
        for (const DialSlider& each : sliders)
            if (each.dial == dial) return each;
    return bias_sliders[dial == Dial::LM ? 0 : 1];
}

// "LL", "θ LL" for its threshold.
std::string shown_name(Dial dial) {
    const std::string_view key = name(dial);
    constexpr std::string_view of_threshold = "threshold_";
    return key.starts_with(of_threshold) ? "θ " + std::string(key.substr(of_threshold.size())) : std::string(key);
}

constexpr float threshold_width = 104, between_sliders = spacing::medium;  // layout pixels
constexpr float names_width = 28;  // of the widest dial: all tracks begin at one place
// In a narrower card the thresholds have their numbers only, which can be typed, and the weights keep a track.
constexpr float narrow_card = 236, narrow_threshold_width = 52;

// Of an offered slider: the least length of its track, and the room of its knob at both ends.
constexpr float least_track = 96, around_track = 16;
constexpr float room_for_two = 250;  // layout pixels, of both biases in one row

// Where no more sliders are offered, there is room for what their letters mean.
constexpr std::size_t few_offers = 2;

// In the lowest windows the sliders are closer, so that the picture below them is whole.
constexpr float lowest_window = 640, close_slider = 24;  // layout pixels

// In a lower window the two biases share a row; layout pixels. The picture of more than four wires is higher.
constexpr float low_window = 700, low_window_of_graph = 900;

class DialSliders {
public:
    DialSliders(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle)
        : view_(view),
          state_(state),
          ui_(ui),
          target_(target_of(view, vehicle)),
          brain_(*brain_of(*view.now, vehicle)),
          sensors_(kind_of(*view.now, vehicle).sensors),
          pair_(shown_pair(view, vehicle)),
          values_(read_dials(brain_, pair_)) {
        if (const Kind* filed = filed_kind(view, vehicle)) {
            homes_ = read_dials(filed->brain, pair_);
            if (const Wire* wire = first_curved(filed->brain)) curve_home_ = wire->curve;
        }
    }

    // One slider for each group of dials that the exercise offers.
    void draw_offered(const std::vector<Offer>& offers) {
        const float width = card_width(ui_), gap = ui_.px(between_sliders);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, 0});
        names_room_ = 0;
        for (const Offer& offer : offers) names_room_ = std::max(names_room_, room_for(words_of(offer)));
        are_names_above_ = width < ui_.px(names_room_ + SliderLook{}.number_width + around_track + least_track);
        for (const Offer& offer : offers) turn_together(offer, width);
        if (is_offered(view_, offer_parts::curves)) curve_sliders(width);
        ImGui::PopStyleVar();
        if (offers.size() <= few_offers && !view_.lecture) say_letters(offers);
    }

    void draw() {
        const bool thresholds = has_threshold() || state_.brain.thresholds_open;
        const float width = card_width(ui_), gap = ui_.px(between_sliders),
                    threshold = ui_.px(width < ui_.px(narrow_card) ? narrow_threshold_width : threshold_width),
                    weight_width = thresholds ? width - threshold - gap : width;
        if (shows_controls(view_, state_)) captions(width, thresholds);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, 0});
        for (std::size_t i = 0; i < std::size(weight_sliders); ++i) {
            turn(weight_sliders[i].dial, weight_sliders[i].anchor, weight_width, weight_look(weight_sliders[i]));
            if (!thresholds) continue;
            ImGui::SameLine();
            turn(threshold_sliders[i].dial, threshold_sliders[i].anchor, threshold, threshold_look());
        }
        const float window_height = ImGui::GetIO().DisplaySize.y;
        const bool is_low = window_height < ui_.px(low_window) ||
                            (window_height < ui_.px(low_window_of_graph) && !sketch::is_four_wires(brain_, pair_));
        const bool share_row = is_low && width >= ui_.px(room_for_two);
        const float bias_width = share_row ? (width - gap) / 2 : width;
        for (const DialSlider& bias : bias_sliders) {
            turn(bias.dial, bias.anchor, bias_width, bias_look(bias));
            if (share_row && bias.dial == Dial::LM) ImGui::SameLine();
        }
        ImGui::PopStyleVar();
    }

private:
    // A brain with a threshold always shows the thresholds.
    bool has_threshold() const {
        return std::any_of(std::begin(threshold_sliders), std::end(threshold_sliders),
                           [&](const DialSlider& each) { return at(values_, each.dial) != 0; });
    }

    // What the letters of the weights mean: of each one, or of all where there are more than two.
    void say_letters(const std::vector<Offer>& offers) {
        constexpr std::size_t most = 2;
        std::vector<std::string_view> words;
        for (const Offer& offer : offers)
            for (const Dial dial : offer.dials)
                if (is_weight(dial)) words.push_back(ui_.strings(slider_of(dial).tooltip));
        if (words.size() > most) words = {ui_.strings("dial.letters")};
        for (const std::string_view each : words) paragraph(ui_, each, ui_.palette.second_text, Face::label);
        say_signs();
    }

    // What the signs before L and R stand for: "▲ = Predators". Eyes have none.
    void say_signs() {
        std::string words;
        for (const std::string& name : {pair_.left, pair_.right}) {
            const Sensor* sensor = find_sensor(sensors_, name);
            if (!sensor || !has_icons(ui_) || wiring::short_name(sensors_, name) == name) continue;
            const std::string channel(word(sensor->channel));
            const std::string sign = std::string(wiring::channel_symbol(sensor->channel)) + " = ";
            if (words.find(sign) != words.npos) continue;
            words += (words.empty() ? "" : "  ") + sign;
            words += ui_.strings.find("view.channel." + channel, channel);
        }
        if (!words.empty()) paragraph(ui_, words, ui_.palette.second_text, Face::label);
    }

    // The heading of the weights; at its right end the buttons that edit both sides, and the one that unfolds the
    // thresholds.
    void captions(float width, bool thresholds) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float height = ui_.px(ui_.tall(22)), y = at.y + (height - line_height(ui_, Face::small)) / 2;
        const std::string_view weight = ui_.strings("brain.weight");
        const SmallButton mirror{"button.mirror", icon::mirror, ui_.strings("button.mirror")};
        const SmallButton cross{"button.cross", icon::cross_over, ui_.strings("button.cross")};
        const SmallButton unfold{"button.thresholds", thresholds ? icon::unfolded : icon::folded,
                                 ui_.strings("brain.threshold"), thresholds};
        const float space = ui_.px(spacing::tight), unfold_x = at.x + width - small_button_width(ui_, unfold, true);
        const float room = unfold_x - space - at.x - text_width(ui_, Face::small, weight) - 2 * space;
        const bool words = small_button_width(ui_, mirror, true) + small_button_width(ui_, cross, true) + space <= room;
        const float cross_x = unfold_x - space - small_button_width(ui_, cross, words);
        const float mirror_x = cross_x - space - small_button_width(ui_, mirror, words);
        if (at.x + text_width(ui_, Face::small, weight) + space <= mirror_x)
            put(ui_, {at.x, y}, weight, ui_.palette.second_text, Face::small);
        if (small(mirror, mirror_x, at.y, words, "tooltip.mirror")) set(mirrored(brain_, pair_));
        if (small(cross, cross_x, at.y, words, "tooltip.cross")) set(crossed(brain_, pair_));
        if (small(unfold, unfold_x, at.y, true, "tooltip.thresholds")) state_.brain.thresholds_open = !thresholds;
        ImGui::SetCursorScreenPos(at);
        // Room for the focus ring of the first slider; where the rows are close, for the buttons.
        ImGui::Dummy({1, has_close_rows(view_, ui_) ? ui_.px(small_button_height) : height - ui_.px(spacing::hair)});
    }

    bool small(const SmallButton& which, float x, float y, bool words, std::string_view tip) {
        ImGui::SetCursorScreenPos({x, y});
        const Item at = small_button(ui_, which, words);
        tooltip(ui_, at, ui_.strings(tip));
        return at.pressed;
    }

    void set(BrainGraph brain) {
        if (brain != brain_)
            ui_.outbox.push_back(
                EditRequest{SetBrain{target_, std::move(brain)}, gestures::panels + ++state_.sliders.gesture});
    }

    float height_of_each() const { return has_close_rows(view_, ui_) ? close_slider : slider_height; }

    SliderLook weight_look(const DialSlider& which) const {
        SliderLook look;
        look.words = name(which.dial);
        look.tooltip = ui_.strings(which.tooltip);
        look.words_width = names_width;
        look.height = height_of_each();
        return look;
    }
    SliderLook threshold_look() const {
        SliderLook look;
        look.tooltip = ui_.strings("dial.threshold");
        look.low = 0, look.high = 1;
        look.signed_number = look.meaning = false;
        look.words_width = 0, look.number_width = 38;
        look.height = height_of_each();
        return look;
    }
    SliderLook bias_look(const DialSlider& which) const {
        SliderLook look = weight_look(which);
        look.low = -1, look.high = 1;
        return look;
    }

    void turn(Dial dial, std::string_view anchor, float width, SliderLook look) {
        look.home = at(homes_, dial);
        const auto edit = slider(ui_, state_.sliders, anchor, at(values_, dial), width, view_.wall_seconds, look);
        if (edit) ui_.outbox.push_back(EditRequest{TurnDial{target_, dial, edit->value, pair_}, edit->gesture});
    }

    // The slider of several dials shows the first one and sets all. Its anchors are those of all of them.
    void turn_together(const Offer& offer, float width) {
        const Dial first = offer.dials.front();
        const DialRange limits = range(first);
        const std::string words = words_of(offer);
        SliderLook look;
        look.words = words;
        std::string tip(ui_.strings(slider_of(first).tooltip));
        if (offer.dials.size() > 1) tip += "\n" + std::string(ui_.strings("dial.together"));
        look.tooltip = tip;
        look.low = limits.low, look.high = limits.high;
        look.words_width = names_room_;
        look.home = at(homes_, first);
        look.height = height_of_each();
        put_name_above(look);
        const auto edit =
            slider(ui_, state_.sliders, slider_of(first).anchor, at(values_, first), width, view_.wall_seconds, look);
        const ImVec2 corner = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
        for (std::size_t i = 1; i < offer.dials.size(); ++i)
            mark(ui_, slider_of(offer.dials[i]).anchor, {corner.x, corner.y, size.x, size.y});
        if (!edit) return;
        for (const Dial dial : offer.dials)
            ui_.outbox.push_back(EditRequest{TurnDial{target_, dial, edit->value, pair_}, edit->gesture});
    }

    // Peak and width of all direct wires that have a curve with a width. The first of them is shown.
    void curve_sliders(float width) {
        const Wire* first = first_curved(brain_);
        if (!first) return;
        curve_slider("curve.peak", "brain.peak", width, first->curve, &Curve::peak, 0);
        curve_slider("curve.width", "brain.width", width, first->curve, &Curve::width, 0.01f);
    }

    bool is_curved(const BrainGraph& brain, const Wire& wire) const {
        return row_of(wire.curve.response).has_width && direct_dial(brain, {wire.from, wire.to}, pair_);
    }

    const Wire* first_curved(const BrainGraph& brain) const {
        const auto found = std::find_if(brain.wires.begin(), brain.wires.end(),
                                        [&](const Wire& wire) { return is_curved(brain, wire); });
        return found == brain.wires.end() ? nullptr : &*found;
    }

    void curve_slider(std::string_view anchor, std::string_view words, float width, const Curve& now,
                      float Curve::*member, float low) {
        SliderLook look;
        look.words = ui_.strings(words);
        look.tooltip = ui_.strings("dial.together");
        look.low = low, look.high = 1;
        look.mouse = 1;  // a hundredth of a signal moves an orbit visibly
        look.home = curve_home_.*member;
        look.signed_number = look.meaning = false;
        look.words_width = std::max(names_room_, room_for(look.words));
        look.height = height_of_each();
        put_name_above(look);
        const auto edit = slider(ui_, state_.sliders, anchor, now.*member, width, view_.wall_seconds, look);
        if (!edit) return;
        BrainGraph changed = brain_;
        for (Wire& wire : changed.wires)
            if (is_curved(brain_, wire)) wire.curve.*member = edit->value;
        ui_.outbox.push_back(EditRequest{SetBrain{target_, std::move(changed)}, edit->gesture});
    }

    // The words of the slider as a line of their own, where they would leave its track too little room.
    void put_name_above(SliderLook& look) {
        if (!are_names_above_) return;
        paragraph(ui_, look.words, ui_.palette.text, look.meaning ? Face::strong : Face::text);
        look.words = {}, look.words_width = 0;
    }

    // Width in layout pixels of the words in front of a slider, with a gap.
    float room_for(std::string_view words) const {
        return text_width(ui_, Face::strong, words) / ui_.px(1) + spacing::medium;
    }

    const LabView& view_;
    PanelState& state_;
    Ui& ui_;
    Target target_;
    const BrainGraph& brain_;
    const std::vector<Sensor>& sensors_;
    SensorPair pair_;
    float names_room_ = 0;  // of the offered dials, layout pixels
    bool are_names_above_ = false;
    FourNeurons values_, homes_;  // current values, and those of the file
    Curve curve_home_;            // of the file's first curved wire
};

}  // namespace

bool has_close_rows(const LabView& view, const Ui& ui) {
    return !view.lecture && ImGui::GetIO().DisplaySize.y < ui.px(lowest_window);
}

std::string_view anchor_of(Dial dial) { return slider_of(dial).anchor; }

std::vector<std::string_view> numbered_sliders(const LabView& view) {
    std::vector<std::string_view> anchors;
    if (offers_some(view)) {
        for (const Offer& offer : offered_dials(*view.lesson->exercise))
            anchors.push_back(anchor_of(offer.dials.front()));
    } else {
        for (const DialSlider& slider : weight_sliders) anchors.push_back(slider.anchor);
        for (const DialSlider& slider : bias_sliders) anchors.push_back(slider.anchor);
    }
    return anchors;
}

std::size_t number_of_slider(const LabView& view, std::string_view anchor) {
    const std::vector<std::string_view> sliders = numbered_sliders(view);
    if (offers_some(view))
        for (const Offer& offer : offered_dials(*view.lesson->exercise))
            for (const Dial dial : offer.dials)
                if (anchor_of(dial) == anchor) anchor = anchor_of(offer.dials.front());
    return static_cast<std::size_t>(std::find(sliders.begin(), sliders.end(), anchor) - sliders.begin());
}

std::string words_of(const Offer& offer) {
    std::string words;
    for (const Dial dial : offer.dials) words += (words.empty() ? "" : " = ") + shown_name(dial);
    return words;
}

void dial_sliders(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle) {
    DialSliders sliders(view, state, ui, vehicle);
    if (offers_some(view))
        sliders.draw_offered(offered_dials(*view.lesson->exercise));
    else
        sliders.draw();
}

}  // namespace braitenlab::ui
