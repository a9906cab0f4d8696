#include "engine/run/run.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/base/errors.hpp"
#include "engine/base/process_usage.hpp"
#include "engine/base/stop_request.hpp"
#include "engine/base/version.hpp"
#include "engine/base/wall_clock.hpp"
#include "engine/files/atomic_file.hpp"
#include "engine/files/background_writer.hpp"
#include "engine/files/folder_lock.hpp"
#include "engine/files/hdf5_file.hpp"
#include "engine/run/checkpoint/checkpoint_store.hpp"
#include "engine/run/checkpoint_times.hpp"
#include "engine/run/output/frames.hpp"
#include "engine/run/output/probes.hpp"
#include "engine/run/profile/run_profile.hpp"
#include "engine/run/progress.hpp"
#include "engine/run/recovery.hpp"
#include "engine/run/report.hpp"
#include "engine/run/schedule.hpp"
#include "engine/run/summary.hpp"
#include "engine/run/watch/watch.hpp"
#include "neighbor/isa.hpp"

namespace sluice {
namespace {

/// Steps between two looks at the state of each particle: seldom enough to be free, often enough to lose little.
constexpr std::uint64_t steps_per_look = 50;

/// Adds its lifetime to a sum.
class Stopwatch {
  public:
    explicit Stopwatch(double& sum) : sum_(sum), start_(WallClock::now()) {}
    ~Stopwatch() { sum_ += seconds_since(start_); }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

  private:
    double& sum_;
    WallClock::time_point start_;
};

/// The canonical scene is written beside the results; that must not replace the file which it came from.
void refuse_to_overwrite(const Scene& scene, const std::filesystem::path& directory) {
    std::error_code error;
    if (std::filesystem::equivalent(scene.file, directory / "scene.toml", error))
        throw SceneError(
            fmt::format("{}: the results cannot go into the scene's own folder '{}', where scene.toml would "
                        "be replaced; choose another folder with -o",
                        scene.file, directory.string()));
}

/// How much of each output belongs to a checkpoint; what is behind it is written anew.
struct OutputState {
    std::uint64_t probe_bytes = 0;    ///< of probes.csv
    std::vector<double> frame_times;  ///< [s]

    /// visit(name, member) for each member.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("probe_bytes", probe_bytes), visit("frame_times", frame_times);
    }
};

template <int Dim>
class Run {
  public:
    Run(const Scene& scene, const RunOptions& options)
        : directory_(options.directory),
          start_(WallClock::now()),
          cpu_start_(process_cpu_seconds()),
          simulation_(scene),
          watch_(simulation_),
          progress_(options.progress),
          frame_times_(scene.output.frame_interval),
          probe_times_(scene.output.probe_interval),
          checkpoint_times_(scene.output) {
        record_.end_time = options.until.value_or(scene.output.end);
        record_.threads = omp_get_max_threads();
        record_.initial_energy = simulation_.energy();
        Probes<Dim> probes(simulation_);
        if (options.resume_from.empty())
            start_files(std::move(probes));
        else
            resume(options.resume_from, std::move(probes));
        if (options.traced_steps)
            profile_.emplace(record_.threads, TracePlan{*options.traced_steps, simulation_.time(), record_.end_time});
        record_.setup_seconds += seconds_since(start_);
        update_summary();
        writer_.finish();
    }

    RunStatus execute() {
        const StopRequest stop;
        try {
            try {
                advance(stop);
                finish();
            } catch (const NumericalError& failure) {
                fail(failure.what());
            }
            writer_.finish();
            if (profile_) profile_text_ = write_profile(*profile_, simulation_, directory_);
        } catch (const OutputError& failure) {
            record_failed_output(failure);
            throw;
        }
        return {record_.state, record_.message, report_text(simulation_, record_) + profile_text_};
    }

  private:
    /// The probes come first: one that has nothing to measure is refused before a folder is made.
    void start_files(Probes<Dim> probes) {
        make_folder(directory_);
        lock_.emplace(directory_);
        write_atomically(directory_ / "scene.toml", simulation_.scene().source);
        std::error_code absent;
        for (const char* other_run : {"profile.json", "trace.json"})
            std::filesystem::remove(directory_ / other_run, absent);
        record_.probe_columns = probes.columns();
        checkpoints_.emplace(directory_);
        probes_.emplace(directory_, std::move(probes), writer_);
        if (simulation_.scene().output.frame_interval > 0) frames_.emplace(directory_, writer_);
    }

    /// The state comes first: a checkpoint that does not fit is refused before results are cut back to it.
    void resume(const std::filesystem::path& checkpoint, Probes<Dim> probes) {
        lock_.emplace(directory_);
        OutputState written;
        restore(open_checkpoint(checkpoint), written);
        record_.probe_columns = probes.columns();
        checkpoints_.emplace(directory_, checkpoint);
        probes_.emplace(directory_, std::move(probes), written.probe_bytes, writer_);
        if (simulation_.scene().output.frame_interval > 0) frames_.emplace(directory_, written.frame_times, writer_);
        write_atomically(directory_ / "scene.toml", simulation_.scene().source);
    }

    void restore(const StateReader& reader, OutputState& written) {
        simulation_.restore(reader.group("simulation"));
        visit_run(reader, written);
        record_.resumed_at.push_back(simulation_.work().steps);
        wall_before_ = record_.wall_seconds;
        cpu_before_ = record_.cpu_seconds;
        disk_wait_before_ = record_.disk_wait_seconds;
    }

    template <class Visit>
    void visit_run(Visit&& visit, OutputState& written) {
        visit("output", written), visit("record", record_);
        visit("frame_schedule", frame_times_), visit("probe_schedule", probe_times_);
        visit("checkpoint_schedule", checkpoint_times_);
        visit("watch", watch_), visit("recovery", recovery_);
        visit("probe_written", probe_written_), visit("frame_written", frame_written_);
    }

    bool at_end() const { return simulation_.time() >= record_.end_time - simulation_.time_step() / 2; }

    void advance(const StopRequest& stop) {
        watch_.check(simulation_);
        if (record_.resumed_at.empty()) {
            write_due();
            checkpoint_times_.due(0, simulation_.time_step());  // the scene itself is as good as the first one
        }
        while (!at_end() && !stop.received()) {
            try {
                keep_state();
                go_on();
            } catch (const NumericalError& failure) {
                if (!go_back(failure)) throw;
            }
            progress_.update(progress_state());
        }
        record_.state = at_end() ? RunState::done : RunState::interrupted;
        if (at_end()) return;
        progress_.note("stopping, when all is written; the same signal once more stops at once");
        // Before the last state is written out, which in a run that goes on is not due.
        if (simulation_.scene().output.has_checkpoints()) write_checkpoint();
    }

    /// A step, and what is due after it.
    void go_on() {
        {
            const Stopwatch watch(record_.step_seconds);
            const StepProfile::Step profiled(profile_ ? &*profile_ : nullptr, simulation_.work().steps,
                                             simulation_.time());
            simulation_.step();
        }
        if (simulation_.work().steps % steps_per_look == 0) look();
        write_due();
        if (checkpoint_times_.due(simulation_.time(), simulation_.time_step())) write_checkpoint();
    }

    void look() {
        const Stopwatch watch(record_.watch_seconds);
        watch_.look(simulation_);
        for (const std::string& news : watch_.take_news())
            progress_.note(fmt::format("warning: t = {:.4g} s: {}", simulation_.time(), news));
        if (recovery_.calm(simulation_.work().steps)) simulation_.set_step_share(1);
    }

    void keep_state() {
        if (!recovery_.due(simulation_.work().steps)) return;
        const Stopwatch watch(record_.watch_seconds);
        recovery_.keep(simulation_.work().steps, CheckpointImage([this](const StateWriter& writer) { save(writer); }));
        ++record_.snapshots;
    }

    /// After a breakdown: to the last good state, and on with half the step, if the scene asks for that. Else the good
    /// state is made a checkpoint, and false returned.
    bool go_back(const NumericalError& failure) {
        Recovery::Good& good = recovery_.before(simulation_.work().steps);
        const Retry retry{simulation_.work().steps, simulation_.time(), failure.what()};
        if (simulation_.scene().watch != WatchPolicy::retry || !recovery_.shorten(retry.step)) {
            writer_.finish();
            if (simulation_.scene().output.has_checkpoints()) checkpoints_->write(good.step, good.image);
            return false;
        }
        const RunRecord record = record_;
        const Recovery::Shortening shortening = recovery_.shortening();
        OutputState written;
        const StateReader reader = good.image.reader();
        simulation_.restore(reader.group("simulation"));
        visit_run(reader, written);
        recovery_.set(shortening);
        record_ = record;
        record_.retries.push_back(retry);
        ++record_.retry_count;
        simulation_.set_step_share(shortening.share);
        writer_.finish();
        probes_->cut_back(written.probe_bytes);
        if (frames_) frames_.emplace(directory_, written.frame_times, writer_);
        progress_.note(fmt::format("{}; going on from t = {:.4g} s with {:.3g} of the step", retry.message,
                                   simulation_.time(), shortening.share));
        return true;
    }

    /// The last state is always written, due or not.
    void finish() {
        watch_.check(simulation_);
        {
            const Stopwatch watch(record_.output_seconds);
            if (probe_written_ != simulation_.time()) write_probes();
            if (frames_ && frame_written_ != simulation_.time()) write_frame();
            sync_output();     // what a disk refuses later than it was written is told too
            writer_.finish();  // what is told of the time that a run took includes it
        }
        update_summary();
        progress_.finish(progress_state());
    }

    void write_due() {
        const double time = simulation_.time(), dt = simulation_.time_step();
        const bool probes = probe_times_.ask(time, dt) == Schedule::Answer::due || time == 0;
        const bool frame = frame_times_.ask(time, dt) == Schedule::Answer::due;
        if (!probes && !frame) return;
        {
            const Stopwatch watch(record_.output_seconds);
            watch_.check(simulation_);
            if (probes) write_probes();
            if (frame) write_frame();
        }
        if (frame) update_summary();
    }

    void write_probes() {
        probes_->write(simulation_);
        probe_written_ = simulation_.time();
    }

    void write_frame() {
        frames_->write(simulation_);
        frame_written_ = simulation_.time();
    }

    /// What is counted as written is on the disk before the checkpoint is.
    void write_checkpoint() {
        watch_.check(simulation_);
        const double before = record_.checkpoint_seconds;
        {
            const Stopwatch watch(record_.checkpoint_seconds);
            sync_output();
            note_time();
            ++record_.checkpoints;
            const auto image = std::make_shared<CheckpointImage>([this](const StateWriter& writer) { save(writer); });
            const std::uint64_t step = simulation_.work().steps;
            writer_.add(image->bytes(), [this, image, step] { checkpoints_->write(step, *image); });
        }
        checkpoint_times_.was_written(record_.checkpoint_seconds - before);
    }

    void sync_output() {
        probes_->sync();
        if (frames_) frames_->sync();
    }

    void save(const StateWriter& writer) {
        const Scene& scene = simulation_.scene();
        CheckpointLabel label{std::string(program_version()),
                              std::string(name_of(active_isa())),
                              scene.file,
                              scene.source,
                              record_.end_time,
                              simulation_.time(),
                              simulation_.work().steps};
        writer("label", label);
        simulation_.save(writer.group("simulation"));
        OutputState written{probes_->size(), frames_ ? frames_->times() : std::vector<double>{}};
        visit_run(writer, written);
    }

    void note_time() {
        record_.wall_seconds = wall_before_ + seconds_since(start_);
        record_.cpu_seconds = cpu_before_ + process_cpu_seconds() - cpu_start_;
        record_.disk_wait_seconds = disk_wait_before_ + writer_.waited();
    }

    void update_summary() {
        const Stopwatch watch(record_.output_seconds);
        note_time();
        record_.probe_values = probes_->sample(simulation_);
        record_.warnings = watch_.warnings();
        record_.looks = watch_.looks();
        std::string text = summary_text(simulation_, record_);
        const std::size_t bytes = text.size();
        writer_.add(bytes,
                    [file = directory_ / "summary.json", text = std::move(text)] { write_atomically(file, text); });
    }

    void fail(const std::string& message) {
        record_.state = RunState::failed;
        record_.message = message;
        update_summary();
        progress_.finish(progress_state());
    }

    /// The disk that refused a frame may still take the summary, at least in the place of the old one, which would
    /// claim that the run goes on. The first refusal is the one to report.
    void record_failed_output(const OutputError& failure) {
        try {
            fail(failure.what());
            writer_.finish();
        } catch (const OutputError&) {
            std::error_code ignored;
            std::filesystem::remove(directory_ / "summary.json", ignored);
            try {
                update_summary();
                writer_.finish();
            } catch (const OutputError&) {
            }
        }
    }

    ProgressState progress_state() const {
        const WorkCount work = simulation_.work();
        return {simulation_.time(), record_.end_time,
                record_.step_seconds + record_.output_seconds + record_.checkpoint_seconds,
                static_cast<double>(work.steps), static_cast<double>(work.particle_steps)};
    }

    std::filesystem::path directory_;
    std::optional<FolderLock> lock_;
    WallClock::time_point start_;
    double cpu_start_;
    Simulation<Dim> simulation_;
    Watch<Dim> watch_;
    Recovery recovery_;
    RunRecord record_;
    Progress progress_;
    Schedule frame_times_, probe_times_;
    CheckpointTimes checkpoint_times_;
    std::optional<CheckpointStore> checkpoints_;
    std::optional<ProbeWriter<Dim>> probes_;
    std::optional<FrameWriter<Dim>> frames_;
    std::optional<StepProfile> profile_;
    std::string profile_text_;
    double probe_written_ = -1, frame_written_ = -1;                  ///< simulated time of the last one [s]
    double wall_before_ = 0, cpu_before_ = 0, disk_wait_before_ = 0;  ///< up to the checkpoint that it goes on from [s]
    /// Last, so that it has finished before what it writes for goes.
    BackgroundWriter writer_{Hdf5File::is_thread_safe() ? BackgroundWriter::default_capacity : 0};
};

}  // namespace

RunStatus run(const Scene& scene, const RunOptions& options) {
    if (options.resume_from.empty()) refuse_to_overwrite(scene, options.directory);
    if (options.threads > 0) omp_set_num_threads(options.threads);
    if (scene.dimension == 2) return Run<2>(scene, options).execute();
    return Run<3>(scene, options).execute();
}

}  // namespace sluice
