// The results of a class as a page.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "app/reports/class_report.h"
#include "app/reports/html.h"
#include "app/reports/path_picture.h"
#include "app/reports/texts.h"
#include "ui/words/number_text.h"

namespace braitenlab {

namespace {

using Row = ClassRow;

struct Page {
    const ClassReport& report;
    const Strings& strings;
    const ClassSummary summary = summary_of(report);
    const Exercise& exercise = *report.exercise;

    std::string words(std::string_view key) const { return std::string(strings(key)); }
    std::string translated(const std::string& text) const { return std::string(strings.find(text, text)); }
    std::string number(double value) const {
        const int digits = value == std::round(value) ? 0 : 1;
        return ui::fixed(static_cast<float>(value), digits, decimal_mark(strings));
    }

    std::string tile(const std::string& value, const std::string& meaning) const {
        return "<div class=\"tile\">" + html::element("b", value) + xml_text(meaning) + "</div>\n";
    }

    std::string passed_count() const {
        if (summary.passed_shown == 0) return fmt::format("{} / {}", summary.passed, summary.students);
        return fmt::format("{} ({}) / {}", summary.passed,
                           fill(strings("report.passed_shown"), {std::to_string(summary.passed_shown)}),
                           summary.students);
    }

    std::string tiles() const {
        const maths::Spread& s = summary.starts;
        std::string out = "<div class=\"tiles\">\n";
        out += tile(std::to_string(summary.students), words("report.students"));
        out += tile(passed_count(), words("report.passed"));
        if (summary.counted > 0) {
            out += tile(number(s.median), fill(strings("report.median"), {std::to_string(exercise.starts)}));
            out += tile(fmt::format("{} – {}", number(s.lower), number(s.upper)), words("report.quartiles"));
        }
        if (summary.without > 0) out += tile(std::to_string(summary.without), words("report.without"));
        if (const int more = static_cast<int>(report.rows.size()) - summary.students; more > 0)
            out += tile(std::to_string(more), words("report.not_counted"));
        return out + "</div>\n";
    }

    // Students who passed so many starts, of one way to pass or not; the bars of one number are one above the other.
    struct Bars {
        std::string_view colour, words;  // words: key of the string
        std::vector<int> students;       // by number of starts passed
    };

    // The numbers of the tile "passed": with the solution shown, alone, and those who do not pass, e.g. because they
    // change what is not offered.
    std::array<Bars, 3> bars() const {
        const std::vector<int> none(static_cast<std::size_t>(exercise.starts) + 1);
        std::array<Bars, 3> all{
            Bars{"#0b6e4f", summary.passed_shown > 0 ? "report.passed_alone" : "report.passed", none},
            Bars{"#c98a00", "report.passed_with_solution", none}, Bars{"#a3a39c", "report.not_passed", none}};
        for (const Row& row : report.rows) {
            if (row.problem || !row.grade) continue;
            const std::size_t which = !row.passed ? 2 : passed_with_solution_shown(row) ? 1 : 0;
            ++all[which].students[static_cast<std::size_t>(row.grade->count)];
        }
        return all;
    }

    // How many students passed 0, 1, … starts.
    std::string histogram() const {
        const std::array<Bars, 3> parts = bars();
        std::vector<int> counts(static_cast<std::size_t>(exercise.starts) + 1);
        for (const Bars& part : parts)
            for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += part.students[i];
        const int most = std::max(1, *std::max_element(counts.begin(), counts.end()));
        const float step = std::min(44.0f, 900.0f / static_cast<float>(counts.size())), high = 90;
        std::string out = html::element("h2", words("report.distribution"));
        out += fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{}\" width=\"{:.0f}\" "
            "height=\"130\" viewBox=\"0 0 {:.0f} 130\" font-size=\"12\" text-anchor=\"middle\">",
            xml_text(strings("report.distribution")), step * static_cast<float>(counts.size()),
            step * static_cast<float>(counts.size()));
        const auto box = [&](float left, float top, float tall, std::string_view colour) {
            out += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>",
                               left + 2, top, step - 4, tall, colour);
        };
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const float left = step * static_cast<float>(i);
            float top = 108;
            if (counts[i] == 0) box(left, top, 1, "#a3a39c");
            for (const Bars& part : parts) {
                const float tall = high * static_cast<float>(part.students[i]) / static_cast<float>(most);
                if (part.students[i] > 0) box(left, top -= tall, tall, part.colour);
            }
            out += fmt::format("<text x=\"{:.1f}\" y=\"124\" fill=\"#1c1c1a\">{}</text>", left + step / 2, i);
            if (counts[i] > 0)
                out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"#1c1c1a\">{}</text>", left + step / 2,
                                   top - 4, counts[i]);
        }
        return out + "</svg>\n" + legend(parts);
    }

    // The colours of the histogram with the number of students of each.
    std::string legend(const std::array<Bars, 3>& parts) const {
        std::string out = "<p class=\"quiet\">";
        for (const Bars& part : parts) {
            const int students = std::accumulate(part.students.begin(), part.students.end(), 0);
            if (students > 0)
                out += fmt::format("<span style=\"color:{}\">■</span> {}: {} &#160; ", part.colour,
                                   xml_text(strings(part.words)), students);
        }
        return out + "</p>\n";
    }

    std::string steps() const {
        std::string out = html::element("h2", words("report.steps")) + "<table><thead><tr>" +
                          html::element("th", words("report.step"));
        out += html::element("th", words("report.made_fail"), "n") + "</tr></thead><tbody>\n";
        for (std::size_t i = 0; i < exercise.steps.size(); ++i) {
            const bool is_worst = summary.worst_step == i;
            out += "<tr>" +
                   html::element("td", fmt::format("{}. {}", i + 1, translated(exercise.steps[i].text)),
                                 is_worst ? "bad" : "") +
                   html::element("td", std::to_string(summary.failed[i]), "n") + "</tr>\n";
        }
        return out + "</tbody></table>\n";
    }

    // The most frequent mistake first.
    std::string misconceptions() const {
        struct Mistake {
            std::string name, text;
            int students;
        };
        std::vector<Mistake> mistakes;
        for (std::size_t i = 0; i < exercise.wrong.size(); ++i)
            mistakes.push_back(
                {translated(exercise.wrong[i].name), translated(exercise.wrong[i].text), summary.resembling[i]});
        mistakes.push_back({words("report.refused_mistake"), words("report.refused_how"), summary.refused});
        mistakes.push_back({words("report.as_shipped"), words("report.as_shipped_how"), summary.unchanged});
        mistakes.push_back({words("report.other_mistakes"), words("report.other_mistakes_how"), summary.other});
        mistakes.push_back({words("report.without"), words("report.without_how"), summary.without});
        std::stable_sort(mistakes.begin(), mistakes.end(),
                         [](const Mistake& a, const Mistake& b) { return a.students > b.students; });
        std::string out;
        for (const Mistake& each : mistakes)
            if (each.students > 0)
                out += "<tr>" + html::element("td", each.name) + html::element("td", each.text) +
                       html::element("td", std::to_string(each.students), "n") + "</tr>\n";
        if (out.empty()) return out;
        return html::element("h2", words("report.resembled")) + "<table><tbody>\n" + out + "</tbody></table>\n";
    }

    std::string heads() const {
        std::string out = html::element("th", words("report.student")) + html::element("th", words("report.passed")) +
                          html::element("th", words("report.starts"), "n");
        for (std::size_t i = 1; i <= exercise.steps.size(); ++i)
            out += html::element("th", fill(strings("report.step_number"), {std::to_string(i)}), "n");
        out += html::element("th", words("report.prediction")) + html::element("th", words("report.hints"), "n") +
               html::element("th", words("report.runs"), "n") + html::element("th", words("report.remark"));
        return out;
    }

    std::string yes_or_no(bool yes) const { return words(yes ? "report.yes" : "report.no"); }

    std::string own_result(const Row& row) const {
        return fill(strings("report.own_result"),
                    {std::to_string(row.hand_in->passed_starts), std::to_string(row.grade->count)});
    }

    std::string remark(const Row& row) const {
        std::string text;
        const auto add = [&](const std::string& more) { text += (text.empty() || more.empty() ? "" : "; ") + more; };
        add(problem_text(row, strings));
        if (const std::string name = other_name(row); !name.empty()) add(fill(strings("report.other_name"), {name}));
        if (!row.same_as.empty()) add(fill(strings("report.same_as"), {row.same_as}));
        if (row.problem) return text;
        if (row.refusal) add(text_of(*row.refusal, strings));
        if (row.hand_in && row.hand_in->solution_shown && !row.passed) add(words("report.solution_shown"));
        if (row.unchanged) add(words("report.as_shipped"));
        if (row.resembles)
            add(fill(strings(has_wires_of_mistake(report, row) ? "report.like" : "report.like_with_other_wires"),
                     {translated(exercise.wrong[*row.resembles].name)}));
        if (states_another_result(report, row)) add(own_result(row));
        return text;
    }

    std::string passed_cell(const Row& row) const {
        if (is_superseded(row)) return html::element("td", words("report.superseded"));
        if (passed_with_solution_shown(row))
            return html::element("td", yes_or_no(true) + " (" + words("report.solution_shown") + ")", "shown");
        return html::element("td", yes_or_no(row.passed), row.passed ? "good" : "bad");
    }

    std::string line(const Row& row, std::size_t index) const {
        const auto number_cell = [](std::optional<int> value) {
            return html::element("td", value ? std::to_string(*value) : "", "n");
        };
        // The names of an anonymous export differ by the number alone.
        const std::string id = row.submitter.id.empty() ? "" : " " + html::element("span", row.submitter.id, "quiet");
        std::string out =
            fmt::format("<tr{}><td class=\"name\"><a href=\"#s{}\">{}</a>{}</td>",
                        is_superseded(row) ? " class=\"superseded\"" : "", index, xml_text(row.student), id);
        if (!row.grade)  // the reason has the room of all results
            return out + fmt::format("<td class=\"bad\" colspan=\"{}\">", 6 + exercise.steps.size()) +
                   html::with_breaks(remark(row)) + "</td></tr>\n";
        out += passed_cell(row);
        out += number_cell(row.grade->count);
        for (std::size_t i = 0; i < exercise.steps.size(); ++i) out += number_cell(starts_done(*row.grade, i));
        const auto& h = row.hand_in;
        const bool is_right = h && h->prediction - 1 == exercise.prediction.answer;
        out += html::element("td", h && h->prediction > 0 ? words(is_right ? "report.right" : "report.wrong") : "");
        out += number_cell(h ? std::optional(h->hints) : std::nullopt);
        out += number_cell(h ? std::optional(h->runs) : std::nullopt);
        const bool is_bad = (row.problem && !is_superseded(row)) || row.refusal || !row.same_as.empty() ||
                            !other_name(row).empty() || states_another_result(report, row);
        return out + html::element("td", remark(row), is_bad ? "bad" : "") + "</tr>\n";
    }

    std::string student(const Row& row, std::size_t index) const {
        std::string out =
            fmt::format("<section class=\"student{}\" id=\"s{}\">\n", is_superseded(row) ? " superseded" : "", index);
        out += html::element("h3", row.student, "name") + html::element("p", row.file, "quiet name");
        out += html::element("div", feedback(report, row, strings), "feedback");
        if (states_another_result(report, row)) out += html::element("p", own_result(row), "bad");
        if (row.grade) {
            out += "<div class=\"starts\">\n";
            for (const StartResult& start : row.grade->starts)
                out += path_picture(exercise, start,
                                    fill(strings(start.passed ? "exercise.start_passed" : "report.start_failed"),
                                         {std::to_string(start.seed)}),
                                    {.width = 92, .has_sign = true}) +
                       "\n";
            out += "</div>\n";
        }
        if (row.hand_in && !row.hand_in->notes.empty())
            out += html::element("p", words("report.notes"), "quiet") + html::element("p", row.hand_in->notes);
        return out + "</section>\n";
    }

    std::string body() const {
        const std::string title = translated(exercise.title);
        std::string out = html::element("h1", fill(strings("report.class"), {title}));
        out += html::element("p", translated(exercise.goal), "quiet") + tiles();
        if (summary.counted > 0) out += histogram() + steps() + misconceptions();
        out += html::element("h2", words("report.students")) + "<table class=\"sorted\"><thead><tr>" + heads() +
               "</tr></thead><tbody>\n";
        for (std::size_t i = 0; i < report.rows.size(); ++i) out += line(report.rows[i], i + 1);
        out += "</tbody></table>\n" + html::element("h2", words("report.feedback"));
        out += html::element("p", words("report.feedback_how"), "quiet");
        for (std::size_t i = 0; i < report.rows.size(); ++i) out += student(report.rows[i], i + 1);
        return out;
    }
};

}  // namespace

std::string class_page(const ClassReport& report, const Strings& strings, const std::string& language) {
    const Page page{report, strings};
    // A click on a heading sorts the table by this column: numbers by value, others as text. Again: the other way
    // round.
    const std::string_view script = texts::sorted_tables_js;
    return html::page(language, page.translated(report.exercise->title), texts::class_css, page.body(), script);
}

}  // namespace braitenlab
