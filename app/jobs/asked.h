// A question and its answer, which is computed in the background.
//
//     Asked<RobotsQuestion, RobotsReport> trial;
//     if (!trial.is_about(question)) trial.ask(question);
//     trial.follow([&](const RobotsQuestion& asked) { return submit_robots(jobs, asked); });  // once per turn
//     if (const RobotsReport* report = trial.answer()) show(*report);
//
// A question is a value. Its answer depends on nothing else, so it is the same whether threads or time slices compute
// it.
#pragma once

#include <optional>
#include <utility>

#include "app/jobs/jobs.h"
#include "core/result.h"

namespace braitenlab {

template <class Question, class Reply>
class Asked {
public:
    // Cancels what is computed. The answer to an earlier question stays until the new one is known.
    void ask(Question question) {
        job_.cancel();
        error_.reset();
        question_ = std::move(question);
        is_due_ = true;
    }
    void forget() { *this = {}; }
    void forget_answer() { answered_.reset(); }

    // Begins what has been asked: submit(const Question&) returns a Job<Reply>, or an error.
    template <class Submit>
    void begin(const Submit& submit) {
        if (!std::exchange(is_due_, false)) return;
        Result<Job<Reply>> job = submit(std::as_const(*question_));
        job ? void(job_ = std::move(*job)) : fail(job.error());
    }
    // Call once per turn, after Jobs::deliver.
    void take() {
        auto done = job_.take();
        if (!done) return;
        *done ? void(answered_.emplace(*question_, std::move(**done))) : fail(done->error());
    }
    template <class Submit>
    void follow(const Submit& submit) {
        take();
        begin(submit);
    }

    // The question asked last; null: none.
    const Question* question() const { return question_ ? &*question_ : nullptr; }
    bool is_about(const Question& question) const { return question_ && *question_ == question; }
    bool is_computing() const { return is_due_ || job_.active(); }
    JobProgress progress() const { return job_.progress(); }

    // The last answer and its question, which may be an earlier one; null: none is known.
    const Reply* answer() const { return answered_ ? &answered_->second : nullptr; }
    const Question* answered() const { return answered_ ? &answered_->first : nullptr; }
    // Why the question has no answer.
    const std::optional<Error>& error() const { return error_; }

private:
    void fail(Error error) {
        answered_.reset();
        error_ = std::move(error);
    }

    std::optional<Question> question_{};
    bool is_due_ = false;
    Job<Reply> job_{};
    std::optional<std::pair<Question, Reply>> answered_{};
    std::optional<Error> error_{};
};

}  // namespace braitenlab
