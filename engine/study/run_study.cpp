#include "engine/study/run_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "engine/base/stop_request.hpp"
#include "engine/base/wall_clock.hpp"
#include "engine/files/atomic_file.hpp"
#include "engine/study/child_run.hpp"
#include "engine/study/evaluate.hpp"
#include "engine/study/report_page.hpp"
#include "engine/study/run_store.hpp"
#include "engine/study/study_file.hpp"
#include "engine/study/study_progress.hpp"
#include "engine/study/words.hpp"

namespace sluice {
namespace {

/// Between two looks at a child: short against the shortest run, long against what a look costs.
constexpr std::chrono::milliseconds look_interval{20};

class Campaign {
  public:
    Campaign(const StudyOptions& options, Plan& plan)
        : options_(options),
          plan_(plan),
          study_(plan.study),
          program_(own_program()),
          build_(build_of(program_)),
          estimate_(study_.dimension),
          probes_(study_.points.size()) {
        for (int repeat = 0; repeat < study_.repeats; ++repeat)
            for (const std::size_t i : run_order(study_)) queue_.push_back({i, repeat});
    }

    StudyEnd execute() {
        make_folder(options_.directory);
        note_refusals();
        const std::size_t kept = options_.again ? 0 : take_finished();
        if (kept > 0) progress_.tell(fmt::format("{} of {} runs are done already", kept, queue_.size()));
        if (other_builds_ > 0)
            progress_.tell(fmt::format("{} of them by another build of sluice {}; --again makes them anew",
                                       other_builds_, study_.version));
        write_tables();
        const StopRequest stop;
        for (at_ = 0; at_ < queue_.size() && !stop.received(); ++at_)
            if (is_to_run(queue_[at_])) run(queue_[at_], stop);
        write_tables();
        return study_.is_complete() || !stop.received() ? StudyEnd::complete : StudyEnd::interrupted;
    }

  private:
    struct Turn {
        std::size_t point = 0;
        int repeat = 0;
    };

    StudyPoint& point(const Turn& turn) { return study_.points[turn.point]; }

    bool is_to_run(const Turn& turn) const {
        const StudyPoint& p = study_.points[turn.point];
        return p.state != PointState::failed && std::find(made_.begin(), made_.end(), key(turn)) == made_.end();
    }

    std::string key(const Turn& turn) const {
        return fmt::format("{}-{}", plan_.runs[turn.point].key, turn.repeat + 1);
    }

    std::filesystem::path folder(const Turn& turn) const { return options_.directory / "runs" / key(turn); }

    void note_refusals() {
        for (std::size_t i = 0; i < study_.points.size(); ++i) {
            if (plan_.runs[i].refusal.empty()) continue;
            study_.points[i].state = PointState::failed;
            study_.points[i].reason = plan_.runs[i].refusal;
        }
    }

    std::size_t take_finished() {
        std::size_t kept = 0;
        for (const Turn& turn : queue_) {
            if (point(turn).state == PointState::failed) continue;
            const auto result = load_result(folder(turn));
            if (!result) continue;
            take(turn, *result);
            ++kept;
            if (result->build != build_) ++other_builds_;
        }
        return kept;
    }

    void take(const Turn& turn, const RunResult& result) {
        StudyPoint& p = point(turn);
        made_.push_back(key(turn));
        if (result.failed) {
            p.state = PointState::failed;
            p.reason = result.reason;
            return;
        }
        if (!probes_[turn.point]) read_probes(turn);
        if (p.state == PointState::failed) return;
        p.state = PointState::done;
        p.cpu.push_back(result.cpu);
        p.wall.push_back(result.wall);
        estimate_.add({p.method, p.spacing}, result.wall);
    }

    /// All repeats have the same probes, as results do not depend on the machine's mood.
    void read_probes(const Turn& turn) {
        try {
            probes_[turn.point].emplace(folder(turn) / "probes.csv");
        } catch (const std::runtime_error& error) {
            point(turn).state = PointState::failed;
            point(turn).reason = error.what();
        }
    }

    std::vector<std::string> words(const Turn& turn) const {
        std::vector<std::string> words{program_.string(), "run", options_.scene};
        for (const std::string& change : plan_.runs[turn.point].overrides) {
            words.emplace_back("--set");
            words.push_back(change);
        }
        for (std::string word :
             {std::string("--threads"), fmt::format("{}", study_.threads), std::string("-o"), folder(turn).string()})
            words.push_back(std::move(word));
        return words;
    }

    void run(const Turn& turn, const StopRequest& stop) {
        std::error_code ignored;
        std::filesystem::remove(folder(turn) / "result.json", ignored);
        make_folder(folder(turn));
        const auto start = WallClock::now();
        ChildRun child(words(turn), folder(turn) / log_name);
        std::optional<ChildEnd> end;
        while (!(end = child.poll()) && !stop.received()) {
            progress_.show(at_, queue_.size(), left(seconds_since(start)), point_name(study_, point(turn)));
            std::this_thread::sleep_for(look_interval);
        }
        if (!end) end = child.stop();
        finish(turn, *end, stop);
    }

    void finish(const Turn& turn, const ChildEnd& end, const StopRequest& stop) {
        auto result = result_of_end(end, folder(turn));
        if (!result && stop.received()) return;
        if (result) {
            result->build = build_;
            store_result(folder(turn), *result);
        } else {
            result = RunResult{true, failure_reason(end, folder(turn)), end.cpu, end.wall, build_};
        }
        take(turn, *result);
        const StudyPoint& p = point(turn);
        progress_.tell(
            fmt::format("{:>3}/{} {}: {}", at_ + 1, queue_.size(), point_name(study_, p),
                        p.state == PointState::failed ? "failed: " + p.reason : seconds_text(result->cpu) + " CPU-s"));
        write_tables();
    }

    /// Wall time of what is running and what is still to come [s].
    std::optional<double> left(double running_for) const {
        double sum = -running_for;
        for (std::size_t k = at_; k < queue_.size(); ++k) {
            const StudyPoint& p = study_.points[queue_[k].point];
            if (!is_to_run(queue_[k])) continue;
            const auto one = estimate_.of({p.method, p.spacing});
            if (!one) return std::nullopt;
            sum += *one;
        }
        return std::max(sum, 0.0);
    }

    void write_tables() {
        measure_errors(study_, plan_.scene, probes_);
        write_atomically(options_.directory / "study.json", json_text(study_));
        write_atomically(options_.directory / "study.csv", csv_text(study_));
    }

    const StudyOptions& options_;
    Plan& plan_;
    Study& study_;
    std::filesystem::path program_;
    std::string build_;
    TimeEstimate estimate_;
    StudyProgress progress_;
    std::vector<std::optional<ProbeTable>> probes_;  ///< of each point
    std::vector<Turn> queue_;
    std::vector<std::string> made_;  ///< keys of the runs that are done
    std::size_t at_ = 0;             ///< in the queue
    std::size_t other_builds_ = 0;
};

}  // namespace

std::string point_name(const Study& study, const StudyPoint& point) {
    return fmt::format("{}, spacing {}", study.methods[point.method], length_text(point.spacing));
}

StudyEnd run_study(const StudyOptions& options, Plan& plan) { return Campaign(options, plan).execute(); }

void write_study(const Study& study, const std::filesystem::path& directory) {
    make_folder(directory);
    write_atomically(directory / "study.json", json_text(study));
    write_atomically(directory / "study.csv", csv_text(study));
    write_atomically(directory / "study.svg", study_svg(study));
    write_atomically(directory / "study.html", study_page(study));
}

}  // namespace sluice
