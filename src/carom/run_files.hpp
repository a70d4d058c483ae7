// The files that grow while a run goes on. What belongs to a window in flight can be told from what is there to stay.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "carom/io/checkpoint.hpp"
#include "carom/io/collisions_csv.hpp"
#include "carom/io/trajectory.hpp"
#include "carom/run/simulation.hpp"

namespace carom {

/// Writes every finished window's collisions; what a window in flight holds is added at the end.
class CollisionLog final : public Observer {
 public:
  explicit CollisionLog(const std::string& path) : csv_(path), kept_(csv_.size()) {}
  CollisionLog(const std::string& path, std::uint64_t kept) : csv_(path, kept), kept_(kept) {}
  /// Removes what is beyond `kept`.
  void cut() { csv_.cut_to(kept_); }

  void on_window(const WindowRecord& window) override;
  void finish(const Simulation& simulation);
  void sync() { csv_.sync(); }
  /// How long it was at the start of the window in flight (bytes).
  [[nodiscard]] std::uint64_t kept() const noexcept { return kept_; }

 private:
  CollisionsCsv csv_;
  std::uint64_t kept_;
};

/// Frames at times 0, dt, 2 dt, …
class FrameSchedule {
 public:
  FrameSchedule(std::unique_ptr<TrajectoryWriter> writer, double every, std::optional<double> until)
      : writer_(std::move(writer)), every_(every), until_(until), kept_(writer_->length()) {}
  /// Removes what is beyond `kept`.
  void cut_to(const TrajectoryLength& kept) {
    writer_->cut_to(kept);
    kept_ = kept;
  }

  /// A frame that is due at the end but for rounding is due at the end.
  [[nodiscard]] double next_time() const noexcept;
  void write_if_due(const Simulation& simulation);

  /// What is written so far stays, whatever becomes of the next window.
  void keep() noexcept { kept_ = writer_->length(); }
  [[nodiscard]] const TrajectoryLength& kept() const noexcept { return kept_; }
  void sync() { writer_->sync(); }
  /// Closes the file; frames of a window that was abandoned are taken back.
  void finish(bool interrupted);

 private:
  std::unique_ptr<TrajectoryWriter> writer_;
  double every_;
  std::optional<double> until_;
  TrajectoryLength kept_;
};

}  // namespace carom
