// carom lab: serves the page on this machine, to this machine only.
#include <fmt/format.h>
#include <httplib.h>
#include <spawn.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <thread>

#include "carom/carom.hpp"
#include "command.hpp"
#include "interrupt.hpp"
#include "options.hpp"

extern char** environ;  // NOLINT: POSIX's name

namespace carom::program {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHost = "127.0.0.1";
constexpr int kUsualPort = 8237;

/// Nothing from elsewhere, and no code made from text; WebAssembly may be compiled.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; connect-src 'self'; font-src 'self'; "
    "img-src 'self' data: blob:; worker-src 'self' blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

struct LabOptions {
  std::optional<std::uint64_t> port;
  std::string page;
  bool no_open = false;
};

/// A file of the page, in memory: what is not here when the program starts is never served.
struct Served {
  std::string content;
  std::string type;
};
using Page = std::map<std::string, Served>;

std::string type_of(const fs::path& file) {
  static const std::map<std::string, std::string> types{{".html", "text/html; charset=utf-8"},
                                                        {".js", "text/javascript; charset=utf-8"},
                                                        {".css", "text/css"},
                                                        {".wasm", "application/wasm"},
                                                        {".woff2", "font/woff2"},
                                                        {".svg", "image/svg+xml"}};
  const auto found = types.find(file.extension().string());
  return found == types.end() ? "application/octet-stream" : found->second;
}

/// Where the page is: as installed beside the program, or as built in the program's source tree.
fs::path find_page() {
  std::error_code unknown;
  const fs::path home = fs::read_symlink("/proc/self/exe", unknown).parent_path();
  for (const char* place : {"../share/carom/lab", "../../../../web/dist/page"}) {
    const fs::path folder = (home / place).lexically_normal();
    if (fs::exists(folder / "index.html", unknown)) return folder;
  }
  throw Error("the page is not here: scripts/build-web builds it, or give its folder with --page DIR");
}

Page load_page(const fs::path& folder) {
  std::error_code failure;
  if (!fs::exists(folder / "index.html", failure))
    throw Error("there is no index.html: this is not the page", {folder.string()});
  Page page;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.is_symlink()) continue;
    const std::string path = "/" + entry.path().lexically_relative(folder).generic_string();
    page[path] = {read_file(entry.path().string()), type_of(entry.path())};
  }
  page["/"] = page["/index.html"];
  return page;
}

/// A name that leads here by way of somebody else's name server is no name of ours.
bool asks_for_us(const httplib::Request& request, int port) {
  const std::string host = request.get_header_value("Host");
  return host == fmt::format("{}:{}", kHost, port) || host == fmt::format("localhost:{}", port);
}

void answer(const httplib::Request& request, httplib::Response& response, const Page& page, int port) {
  const auto found = page.find(request.path);
  if (!asks_for_us(request, port)) {
    response.status = 403;
  } else if (found == page.end()) {
    response.status = 404;
  } else {
    response.set_content(found->second.content, found->second.type);
  }
}

int bind(httplib::Server& server, const std::optional<std::uint64_t>& wanted) {
  if (!wanted) {
    if (server.bind_to_port(kHost, kUsualPort)) return kUsualPort;
    return server.bind_to_any_port(kHost);
  }
  if (*wanted > 65535) throw UsageError(fmt::format("--port {}: ports go from 0 to 65535", *wanted));
  if (*wanted == 0) return server.bind_to_any_port(kHost);
  const int port = static_cast<int>(*wanted);
  if (!server.bind_to_port(kHost, port)) throw Error(fmt::format("port {} is taken: give another with --port", port));
  return port;
}

/// Where there is a screen, asks the desktop to show the address. It does not matter if it cannot.
void open_browser(const std::string& address) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
  std::string command = "xdg-open";
  std::string argument = address;
  char* words[] = {command.data(), argument.data(), nullptr};
  pid_t child = 0;
  if (posix_spawnp(&child, command.c_str(), nullptr, nullptr, words, environ) == 0) {
    std::thread([child] { waitpid(child, nullptr, 0); }).detach();
  }
}

int lab_command(const LabOptions& options) {
  const Page page = load_page(options.page.empty() ? find_page() : fs::path(options.page));
  httplib::Server server;
  // Not the library's default, by which several programs can share one port and take turns.
  server.set_socket_options([](socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  server.set_keep_alive_timeout(1);  // seconds; ending waits for them
  server.set_default_headers({{"Content-Security-Policy", kPolicy},
                              {"X-Content-Type-Options", "nosniff"},
                              {"Referrer-Policy", "no-referrer"},
                              {"Cross-Origin-Resource-Policy", "same-origin"},
                              {"Cache-Control", "no-cache"}});
  int port = 0;
  server.Get(".*", [&](const httplib::Request& request, httplib::Response& response) {
    answer(request, response, page, port);
  });
  port = bind(server, options.port);
  if (port < 0) throw Error("no port of this machine can be had");

  const std::atomic<bool>& interrupted = catch_interrupts();
  std::atomic<bool> ended{false};
  std::thread serving([&] {
    server.listen_after_bind();
    ended = true;
  });
  const std::string address = fmt::format("http://{}:{}/", kHost, port);
  print(fmt::format("{}\nCtrl-C ends it.\n", address));
  if (!options.no_open) open_browser(address);
  while (!interrupted && !ended) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  server.stop();
  serving.join();
  if (!interrupted) throw Error("the server stopped by itself");
  return kSuccess;
}

}  // namespace

void add_lab(CLI::App& app, Action& action) {
  CLI::App* command = add_command(app, "lab", "Serve the page on this machine and open it", "carom lab --port 8237");
  const auto options = std::make_shared<LabOptions>();
  add_count(*command, "--port", options->port, "of 127.0.0.1; 0 takes any that is free (8237, or any if it is taken)");
  add_path(*command, "--page", options->page, "DIR", "where the built page is, if not beside the program");
  command->add_flag("--no-open", options->no_open, "do not open a browser");
  command->callback([options, &action] { action = [options] { return lab_command(*options); }; });
}

}  // namespace carom::program
