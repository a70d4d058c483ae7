#include "carom/draw/movie.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <vector>

#include "carom/base/error.hpp"

extern char** environ;

namespace carom {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};

std::string reason() { return std::strerror(errno); }

std::vector<std::string> arguments(MovieFormat format, double frames_per_second, const std::string& out) {
  std::vector<std::string> words{"ffmpeg",     "-hide_banner",
                                 "-nostats",   "-loglevel",
                                 "error",      "-y",
                                 "-f",         "image2pipe",
                                 "-framerate", fmt::format("{}", frames_per_second),
                                 "-c:v",       "png",
                                 "-i",         "pipe:0",
                                 "-an",        "-map_metadata",
                                 "-1",         "-fflags",
                                 "+bitexact"};
  const auto add = [&](std::initializer_list<const char*> more) {
    words.insert(words.end(), more.begin(), more.end());
  };
  if (format == MovieFormat::mp4) {
    // Players want even sizes and this kind of pixels.
    add({"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white,format=yuv420p", "-c:v", "libx264", "-crf", "18",
         "-movflags", "+faststart", "-flags:v", "+bitexact", "-f", "mp4"});
  } else {
    // A palette for each picture: one for all would need all of them in memory.
    add({"-filter_complex", "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=none", "-f",
         "gif"});
  }
  words.push_back("file:" + out);
  return words;
}

// An empty file beside `path` with a name that nobody can foresee.
std::string make_hidden_file(const std::string& path) {
  const std::filesystem::path target(path);
  std::string name = (target.parent_path() / ".carom-film-XXXXXX").string();
  const int descriptor = mkstemp(name.data());
  if (descriptor < 0) throw Error("cannot be written: " + reason(), {path});
  const mode_t mask = umask(0);
  umask(mask);
  fchmod(descriptor, 0666 & ~mask);  // mkstemp's own mode lets nobody else look
  close(descriptor);
  return name;
}

}  // namespace

MovieFormat movie_format_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  if (ending == ".mp4") return MovieFormat::mp4;
  if (ending == ".gif") return MovieFormat::gif;
  throw Error("cannot make the film " + path + ": give a name that ends in .mp4 or .gif");
}

/// The running ffmpeg, with a pipe into it and a nameless file for its complaints.
class Movie::Process {
 public:
  explicit Process(const std::vector<std::string>& words) : complaints_(std::tmpfile()) {
    if (!complaints_) throw Error("no temporary file can be made: " + reason());
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw Error("no pipe to ffmpeg can be made: " + reason());
    input_ = ends[1];
    const int error = start(words, ends[0]);
    close(ends[0]);
    if (error == 0) return;
    close(input_);
    if (error == ENOENT) {
      throw Error("films are made by the program ffmpeg, which is not installed (Debian's package is called ffmpeg)");
    }
    throw Error(std::string("ffmpeg cannot be started: ") + std::strerror(error));
  }

  ~Process() {
    if (id_ <= 0) return;
    kill(id_, SIGKILL);
    wait();
  }

  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// False once ffmpeg no longer reads.
  bool write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t count = ::write(input_, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
  }

  /// Waits for its end; whether it succeeded.
  bool wait() {
    if (input_ >= 0) close(input_);
    input_ = -1;
    int status = 0;
    while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    id_ = 0;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

  [[nodiscard]] std::string last_complaint() {
    std::rewind(complaints_.get());
    std::string text, last;
    for (int letter = std::fgetc(complaints_.get()); letter != EOF; letter = std::fgetc(complaints_.get())) {
      text += static_cast<char>(letter);
    }
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      if (end > begin) last = text.substr(begin, end - begin);
      begin = end + 1;
    }
    return last;
  }

 private:
  /// In a process group of its own: an interrupt from the terminal is for us to deal with.
  int start(const std::vector<std::string>& words, int input) {
    std::vector<char*> pointers;
    for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, fileno(complaints_.get()), STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t usual;
    sigemptyset(&usual);
    sigaddset(&usual, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    const int error = posix_spawnp(&id_, "ffmpeg", &actions, &attributes, pointers.data(), environ);
    if (error != 0) id_ = 0;
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return error;
  }

  std::unique_ptr<std::FILE, CloseFile> complaints_;
  int input_ = -1;
  pid_t id_ = 0;
};

Movie::Movie(std::string path, double frames_per_second) : path_(std::move(path)), process_(nullptr) {
  const MovieFormat format = movie_format_of(path_);
  if (!(frames_per_second > 0 && frames_per_second <= 1000)) {
    throw Error(fmt::format("a film of {} frames per second cannot be made", frames_per_second));
  }
  hidden_ = make_hidden_file(path_);
  try {
    process_ = new Process(arguments(format, frames_per_second, hidden_));
  } catch (...) {
    std::remove(hidden_.c_str());
    throw;
  }
}

Movie::~Movie() {
  delete process_;
  if (!hidden_.empty()) std::remove(hidden_.c_str());
}

void Movie::fail() {
  const std::string complaint = process_->last_complaint();
  throw Error("ffmpeg failed" + (complaint.empty() ? std::string() : ": " + complaint), {path_});
}

void Movie::add(std::string_view png) {
  any_ = true;
  if (process_->write(png)) return;
  process_->wait();
  fail();
}

void Movie::finish() {
  if (!any_) throw Error("a film needs at least one picture", {path_});
  if (!process_->wait()) fail();
  if (std::rename(hidden_.c_str(), path_.c_str()) != 0) throw Error("cannot be written: " + reason(), {path_});
  hidden_.clear();
}

}  // namespace carom
