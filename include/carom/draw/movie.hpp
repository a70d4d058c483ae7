// Pictures one after another as a film, through the program ffmpeg.
#pragma once

#include <string>
#include <string_view>

namespace carom {

enum class MovieFormat { mp4, gif };

/// The format that a file's name ends in: .mp4 or .gif, in either case.
/// Throws Error "cannot make the film FILE: give a name that ends in .mp4 or .gif" for any other.
MovieFormat movie_format_of(const std::string& path);

/// A film that is being made. Pictures go through a pipe; ffmpeg writes a hidden file with a random name beside the
/// film, which takes the film's place when all went well. So a film that is there is whole, whatever happened. The
/// program must ignore SIGPIPE.
class Movie {
 public:
  /// Starts ffmpeg. Throws Error if it is not installed, or the file cannot be made. `frames_per_second` is positive
  /// and at most 1000.
  Movie(std::string path, double frames_per_second);
  /// Ends ffmpeg and removes its file, unless finish() succeeded.
  ~Movie();
  Movie(const Movie&) = delete;
  Movie& operator=(const Movie&) = delete;

  /// Adds a picture: the bytes of a PNG, all of one size. Throws Error with the last line of ffmpeg's complaint if it
  /// has ended.
  void add(std::string_view png);

  /// Waits for ffmpeg and puts the film in its place. Throws Error with the last line of ffmpeg's complaint if it
  /// failed, or if there was no picture.
  void finish();

 private:
  class Process;

  [[noreturn]] void fail();

  std::string path_;
  std::string hidden_;  // the file that ffmpeg writes; empty if there is none
  Process* process_;    // owned
  bool any_ = false;
};

}  // namespace carom
