// Rows that edit any record of core/scene/schema.h: one row per number, angle, word, flag and text, in the order of the
// schema. Label and tooltip are the strings field.RECORD.KEY and field.RECORD.KEY_how; unit and range are the schema's.
//
// Numbers and angles are sliders (ui/widgets/slider.h), words and flags are choices, texts are text fields. Lists,
// inner tables, brains and optional values have no row.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/maths/angle.h"
#include "core/maths/degrees.h"
#include "core/scene/enums.h"
#include "core/scene/schema.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/text_field.h"
#include "ui/widgets/ui.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

// The RECORD of the string keys.
constexpr std::string_view record_word(Of<Arena>) { return "arena"; }
constexpr std::string_view record_word(Of<Ecology>) { return "ecology"; }
constexpr std::string_view record_word(Of<Body>) { return "body"; }
constexpr std::string_view record_word(Of<PlaceMemory>) { return "memory"; }
constexpr std::string_view record_word(Of<CarriedLamp>) { return "lamp"; }
constexpr std::string_view record_word(Of<Waypoint>) { return "waypoint"; }
constexpr std::string_view record_word(Of<Kind>) { return "kind"; }
constexpr std::string_view record_word(Of<Zone>) { return "zone"; }

// The stem of the strings of an enumeration's words: "field.edge." of field.edge.wall.
constexpr std::string_view word_stem(Boundary) { return "field.edge."; }
constexpr std::string_view word_stem(Role) { return "field.role."; }
constexpr std::string_view word_stem(Driver) { return "field.driver."; }
constexpr std::string_view word_stem(Surface) { return "field.surface."; }
constexpr std::string_view word_stem(Channel) { return "view.channel."; }

// Calls f with Of<T> of every record above.
template <class F>
void each_record(F f) {
    f(Of<Arena>{}), f(Of<Ecology>{}), f(Of<Body>{}), f(Of<PlaceMemory>{}), f(Of<CarriedLamp>{}), f(Of<Waypoint>{});
    f(Of<Kind>{}), f(Of<Zone>{});
}

// The text fields of records.
struct FieldsState {
    std::map<std::string, TextField, std::less<>> texts;  // by anchor
    bool cancelled = false;                               // Esc was pressed in the active one
};

// Removes the text fields that were not drawn in this frame. Call at its end.
void keep_drawn(FieldsState&);

// Handles a key of an active text field of a record. Returns true if the key is handled.
bool for_record_text(FieldsState&, KeyPress);

// One number of a record as its row shows it.
struct NumberField {
    const char* key = "";
    std::string_view unit;
    Range range{};  // of the shown value
    float value = 0, home = 0;
    bool whole = false;
};

// The range, steps and track of a number's slider. A range of more than two powers of ten above the usual values has a
// wide track.
SliderLook look_of(const NumberField&);

// What draws the rows. `anchor`: prefix of the rows' anchors, which are PREFIX.KEY; `words`: "field.arena.".
struct FieldRows {
    Ui& ui;
    FieldsState& state;
    SliderState& sliders;
    double wall_seconds = 0;
    std::string anchor{}, words{};
    float words_width = 118;  // layout pixels

    std::optional<SliderEdit> number(const NumberField&) const;
    int choice(const char* key, std::span<const std::string_view> choices, int chosen) const;  // the new one, or −1
    std::optional<std::string> text(const char* key, const std::string& now, std::size_t longest) const;
    std::uint64_t next_gesture() const { return gestures::panels + ++sliders.gesture; }
};

// A record as edited in this frame.
template <class T>
struct RecordEdit {
    T to;
    std::uint64_t gesture = 0;  // the same for all edits of one drag
};

// The part of a visitor of core/scene/schema.h for values that have no row.
template <class T>
struct ValuesWithoutRow {
    template <class Enum>
    void word(const char*, std::optional<Enum> T::*, const char*) {}
    void colour(const char*, std::string T::*, const char*) {}
    template <class Part>
    void part(Part T::*) {}
    template <class Inner>
    void table(const char*, Inner T::*, const char*) {}
    template <class Element>
    void named(const char*, std::vector<Element> T::*, std::size_t, const char*) {}
    template <class Element>
    void list(const char*, std::vector<Element> T::*, std::size_t, const char*) {}
    template <class Graph>
    void brain(const char*, Graph T::*, const char*) {}
    void place(const char*, std::optional<maths::vec2> T::*, Range, const char*) {}
};

// The visitor of core/scene/schema.h that draws the rows.
template <class T>
class RecordFields : public ValuesWithoutRow<T> {
public:
    using ValuesWithoutRow<T>::word;
    RecordFields(const FieldRows& rows, const T& now, const T& home, std::span<const std::string_view> only)
        : rows_(rows), now_(now), home_(home), only_(only) {}

    void number(const char* key, float T::*member, const char* unit, Range range, const char*) {
        turn({key, unit, range, now_.*member, home_.*member}, [&](T& to, float value) { to.*member = value; });
    }
    template <class Whole>
    void number(const char* key, Whole T::*member, const char* unit, Range range, const char*) {
        const NumberField field{key, unit, range, static_cast<float>(now_.*member), static_cast<float>(home_.*member),
                                true};
        turn(field, [&](T& to, float value) { to.*member = static_cast<Whole>(std::lround(value)); });
    }
    void angle(const char* key, float T::*member, Range degrees, const char*) {
        turn({key, "°", degrees, maths::degrees(now_.*member), maths::degrees(home_.*member)},
             [&](T& to, float value) { to.*member = maths::from_degrees(static_cast<double>(value)); });
    }
    void flag(const char* key, bool T::*member, const char*) {
        if (!is_shown(key)) return;
        const std::array words{rows_.ui.strings("field.no"), rows_.ui.strings("field.yes")};
        const int chosen = rows_.choice(key, words, now_.*member ? 1 : 0);
        if (chosen >= 0) begin(rows_.next_gesture()).*member = chosen == 1;
    }
    template <class Enum>
    void word(const char* key, Enum T::*member, const char*) {
        if (!is_shown(key)) return;
        std::vector<std::string_view> words;
        std::vector<Enum> values;
        int present = -1;
        for (const auto& row : table_of(Enum{})) {
            if constexpr (requires { row.is_source; })  // a lamp gives off what a source gives off
                if (!row.is_source && row.value != now_.*member) continue;
            if (row.value == now_.*member) present = static_cast<int>(values.size());
            values.push_back(row.value);
            words.push_back(rows_.ui.strings.find(std::string(word_stem(Enum{})) + std::string(row.word), row.word));
        }
        const int chosen = rows_.choice(key, words, present);
        if (chosen >= 0) begin(rows_.next_gesture()).*member = values[static_cast<std::size_t>(chosen)];
    }
    void text(const char* key, std::string T::*member, std::size_t longest, const char*) {
        if (!is_shown(key)) return;
        if (auto typed = rows_.text(key, now_.*member, longest))
            begin(rows_.next_gesture()).*member = std::move(*typed);
    }
    std::optional<RecordEdit<T>> edit() { return std::move(edit_); }

private:
    bool is_shown(std::string_view key) const {
        return only_.empty() || std::find(only_.begin(), only_.end(), key) != only_.end();
    }
    T& begin(std::uint64_t gesture) {
        if (!edit_) edit_ = RecordEdit<T>{now_};
        edit_->gesture = gesture;
        return edit_->to;
    }
    template <class Set>
    void turn(const NumberField& field, Set set) {
        if (!is_shown(field.key)) return;
        if (const auto wanted = rows_.number(field)) set(begin(wanted->gesture), wanted->value);
    }

    const FieldRows& rows_;
    const T &now_, &home_;
    std::span<const std::string_view> only_;
    std::optional<RecordEdit<T>> edit_;
};

// Draws the rows of a record at the cursor, as wide as the card, and returns the edit made in this frame. `home`: the
// values that a right click restores; `only`: the keys to show, empty for all.
template <class T>
std::optional<RecordEdit<T>> record_fields(FieldRows rows, const T& now, const T& home,
                                           std::span<const std::string_view> only = {}) {
    rows.words = "field." + std::string(record_word(Of<T>{})) + ".";
    if (rows.anchor.empty()) rows.anchor = record_word(Of<T>{});
    RecordFields<T> fields(rows, now, home, only);
    describe(fields, Of<T>{});
    return fields.edit();
}

}  // namespace braitenlab::ui
