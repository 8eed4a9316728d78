#include "app/reports/lab_record.h"

#include <cmath>

#include <fmt/format.h>

#include "app/reports/brain_drawing.h"
#include "app/reports/html.h"
#include "app/reports/path_picture.h"
#include "app/reports/texts.h"
#include "ui/words/measure_text.h"

namespace braitenlab {

namespace {

struct Record {
    const LabRecord& record;
    const Strings& strings;
    const Exercise& exercise = *record.exercise;

    std::string words(std::string_view key) const { return std::string(strings(key)); }
    std::string translated(const std::string& text) const { return std::string(strings.find(text, text)); }
    std::string heading(std::string_view key) const { return html::element("h2", strings(key)) + "\n"; }

    std::string title() const {
        if (exercise.number == 0)
            return record.shows_title ? translated(exercise.title) : words("exercise.heading_unnumbered");
        return record.shows_title ? fmt::format("{}. {}", exercise.number, translated(exercise.title))
                                  : fill(strings("exercise.heading"), {std::to_string(exercise.number)});
    }

    std::string head() const {
        const std::string name = record.student.empty() ? "____________________" : record.student;
        return "<header>" + html::element("p", words("report.lab_record"), "quiet") + html::element("h1", title()) +
               "<div class=\"who\">" + html::element("span", words("report.student") + ": " + name) +
               html::element("span", record.date) + "</div></header>\n" + heading("report.goal") +
               html::element("p", translated(exercise.goal)) + "\n";
    }

    std::string prediction() const {
        const Prediction& asked = exercise.prediction;
        if (!is_asked(asked)) return "";
        std::string out = heading("report.prediction") + html::element("p", translated(asked.question), "quiet");
        const auto chosen = static_cast<std::size_t>(record.prediction);
        const bool is_made = record.prediction >= 0 && chosen < asked.options.size();
        out += html::element("p", is_made ? fill(strings("exercise.you_predicted"), {translated(asked.options[chosen])})
                                  : record.path_difference ? fill(strings("report.drawn_path"), {path_distance_text()})
                                                           : words("report.no_prediction"));
        if (!record.outcome_known) return out;
        if (is_made) {
            const bool is_right = record.prediction == asked.answer;
            out += html::element("p", words(is_right ? "report.right" : "report.wrong"), is_right ? "good" : "bad");
        }
        return out + html::element("p", fill(strings("exercise.outcome"), {translated(asked.outcome)})) + "\n";
    }

    std::string path_distance_text() const {
        return ui::value_text(strings, Measure{.value = record.path_difference.value_or(0), .unit = "m"});
    }

    std::string pictures() const {
        std::string out = "<div class=\"pair\">";
        if (record.shows_brain)
            out += "<div>" + heading("report.brain") +
                   brain_drawing(record.submission.brain, record.submission.sensors, strings) + "</div>";
        if (record.last_run)
            out += "<div>" + heading("report.last_run") +
                   path_picture(exercise, *record.last_run, words("report.last_run"),
                                {.width = 330, .names = true, .points = 400}) +
                   "</div>";
        return out + "</div>\n";
    }

    std::string step(std::size_t index) const {
        const std::vector<Verdict>* verdicts = record.last_run ? &record.last_run->verdicts : nullptr;
        const bool is_known = verdicts && index < verdicts->size();
        const bool done = is_known && (*verdicts)[index].done;
        std::string measured;
        if (is_known)
            for (const Measure& measure : (*verdicts)[index].measures)
                if (std::isfinite(measure.value))
                    measured += (measured.empty() ? "" : "\n") + ui::measure_text(strings, measure, done);
        return "<tr>" + html::element("td", done ? "✓" : "○", done ? "good" : "quiet") +
               html::element("td", translated(exercise.steps[index].text)) + html::element("td", measured) + "</tr>\n";
    }

    std::string steps() const {
        std::string out = heading("report.steps") + "<table>\n";
        for (std::size_t i = 0; i < exercise.steps.size(); ++i) out += step(i);
        return out + "</table>\n" +
               html::element(
                   "p",
                   fill(strings("report.runs_and_hints"), {std::to_string(record.runs), std::to_string(record.hints)}) +
                       (record.solution_shown ? " " + words("report.solution_was_shown") : ""),
                   "quiet");
    }

    std::string starts() const {
        std::string out = heading("report.starts");
        if (!record.grade) return out + html::element("p", words("report.not_graded"), "quiet");
        const Grade& grade = *record.grade;
        const std::string count = std::to_string(grade.count), of = std::to_string(grade.starts.size());
        out += html::element("p",
                             grade.good
                                 ? fill(strings("report.passed_from"), {count, of})
                                 : fill(strings("report.failed_from"), {count, of, std::to_string(exercise.needed)}),
                             grade.good ? "good" : "bad");
        out += grade.starts.size() > 20 ? "<div class=\"starts many\">\n" : "<div class=\"starts\">\n";
        for (const StartResult& start : grade.starts)
            out += path_picture(exercise, start,
                                fill(strings(start.passed ? "exercise.start_passed" : "report.start_failed"),
                                     {std::to_string(start.seed)}),
                                {.width = 120, .has_sign = true}) +
                   "\n";
        return out + "</div>\n";
    }

    static std::string lines(int count) {
        std::string out;
        for (int i = 0; i < count; ++i) out += "<div class=\"line\"></div>";
        return out + "\n";
    }

    // A section that is not divided between two sheets.
    static std::string whole(const std::string& section) { return "<div class=\"whole\">\n" + section + "</div>\n"; }

    std::string notes() const {
        if (record.notes.empty()) return whole(heading("report.notes") + lines(5));
        return heading("report.notes") + html::element("p", record.notes, "notes");
    }

    std::string question() const {
        if (exercise.question.empty()) return "";
        return whole(heading("report.question") + html::element("p", translated(exercise.question)) + lines(5));
    }

    std::string body() const { return head() + prediction() + pictures() + steps() + starts() + notes() + question(); }
};

}  // namespace

std::string lab_record_html(const LabRecord& record, const Strings& strings, const std::string& language) {
    const Record page{record, strings};
    const std::string title = page.title();
    return html::page(language, record.student.empty() ? title : title + " – " + record.student, texts::record_css,
                      page.body());
}

}  // namespace braitenlab
