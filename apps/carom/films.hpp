// carom draw --movie.
#pragma once

#include <optional>
#include <string>

#include "carom/draw/state.hpp"

namespace carom::program {

/// What a film shows: the frames of a trajectory, or a scene simulated from time 0.
struct FilmOptions {
  std::string file;
  std::string out;
  std::optional<double> until;  ///< of a scene
  std::optional<double> every;  ///< of a scene: time between two frames; a 250th of the whole if absent
  double frames_per_second = 25;
  bool quiet = false;
  StatePicture picture;
};

/// Whether a file is an extended XYZ or H5MD trajectory, not a scene.
bool is_trajectory(const std::string& path);

/// Makes it. Throws UsageError for options that make no sense, Error if the film cannot be made, Interrupted.
void make_film(const FilmOptions& options);

}  // namespace carom::program
