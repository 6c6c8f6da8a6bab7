// SPDX-License-Identifier: MIT
// A movie of a run. The solver only hands over the field; painting and encoding run on threads of
// their own.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/worker.hpp"
#include "output/files/movie_file.hpp"
#include "output/files/output.hpp"
#include "output/files/output_names.hpp"
#include "output/picture/painting.hpp"

namespace hackle {

class MovieOutput : public Output {
 public:
  // Encodes on up to `threads` threads. Reports a fallback to another kind, unless it is quiet.
  // Throws as Run::movie does.
  MovieOutput(const std::filesystem::path& path, const MovieOptions& options, const View& view,
              const Origin& origin, int threads, Talk talk,
              std::shared_ptr<const OutputNames> names);

  const std::filesystem::path& path() const { return file_.path(); }

  // With a graph of the cracks it follows them in every step.
  std::int64_t next_due(const Simulation& simulation) override;
  bool due(const Simulation& simulation) override;
  // Takes a frame now, whether it is due or not.
  void add(const View& view);
  void reserve() override;
  void close() override;
  Expected expected(double until, std::int64_t max_looks) const override;
  std::vector<std::filesystem::path> files() const override;
  void add_seconds(StageSeconds& wall) const override;

  void keep_continuable() override { file_.keep_frames(); }
  std::vector<std::filesystem::path> kept_files() const override;
  OutputMark mark() const override { return mark_at(path(), frames_, complete_); }
  std::function<void()> settled() override;
  void continue_from(const OutputMark& mark) override;

 private:
  using Work = std::function<void()>;
  void look(const Simulation& simulation) override;
  void hand_over(Work work);
  // On the painting thread.
  void work_on(const Work& work);
  void paint(const Shot& shot);
  void finish();

  MovieOptions options_;
  PictureStyle style_;
  CrackGrowth growth_;
  MovieFile file_;
  std::shared_ptr<const OutputNames> names_;
  std::int64_t frames_ = 0;  // handed over
  bool failed_ = false;
  bool complete_ = false;
  std::atomic<double> render_seconds_ = 0.0;
  // Created with the first frame, on the painting thread, because a GL context must be created and
  // destroyed there.
  std::unique_ptr<PlatePainter> painter_;
  std::string note_;  // of the last frame of a former program, until the painter knows it
  std::unique_ptr<Worker<Work>> painting_;
};

}  // namespace hackle
