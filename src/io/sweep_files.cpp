#include "carom/io/sweep_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "carom/base/error.hpp"
#include "carom/io/file.hpp"

namespace carom {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string dumped(const ordered_json& json) {
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

ordered_json json_of_job(const SweepJob& job) {
  return {{"job", job.name}, {"replica", job.replica}, {"seed", job.seed}, {"values", job.values}};
}

}  // namespace

std::string sweep_settings_json(const SweepSettings& settings) {
  ordered_json json;
  json["version"] = settings.version;
  json["varied"] = ordered_json::array();
  for (const VariedKey& varied : settings.varied) {
    json["varied"].push_back({{"key", varied.key}, {"values", varied.values}});
  }
  json["replicas"] = settings.replicas;
  json["scene"] = settings.scene;
  return dumped(json);
}

SweepSettings read_sweep_settings(const std::string& path) {
  const std::string text = read_file(path);
  try {
    const ordered_json json = ordered_json::parse(text);
    SweepSettings settings;
    settings.version = json.at("version").get<std::string>();
    for (const ordered_json& varied : json.at("varied")) {
      settings.varied.push_back({varied.at("key").get<std::string>(), varied.at("values").get<std::vector<double>>()});
    }
    settings.replicas = json.at("replicas").get<std::uint64_t>();
    settings.scene = json.at("scene").get<std::string>();
    return settings;
  } catch (const ordered_json::exception& error) {
    throw Error(std::string("does not describe a sweep: ") + error.what(), {path});
  }
}

std::string finished_job_json(const SweepRow& row, const std::vector<VariedKey>& varied) {
  ordered_json json = json_of_job(row.job);
  json["keys"] = ordered_json::array();
  for (const VariedKey& key : varied) json["keys"].push_back(key.key);
  json["number_density"] = row.number_density ? ordered_json(*row.number_density) : ordered_json();
  json["violations"] = row.violations;
  json["digest"] = row.results.digest;
  return dumped(json);
}

std::optional<SweepRow> read_finished_job(const std::string& directory, const SweepJob& job) {
  const std::string path = (fs::path(directory) / "job.json").string();
  try {
    const ordered_json json = ordered_json::parse(read_file(path));
    const ordered_json expected = json_of_job(job);
    for (const auto& [key, value] : expected.items()) {
      if (json.at(key) != value) return std::nullopt;
    }
    SweepRow row;
    row.job = job;
    if (!json.at("number_density").is_null()) row.number_density = json.at("number_density").get<double>();
    row.violations = json.at("violations").get<std::vector<std::string>>();
    row.results = read_run_results(directory);
    if (json.at("digest") != row.results.digest) return std::nullopt;
    row.measurements = read_measurements(directory, false);
    return row;
  } catch (const ordered_json::exception&) {
    return std::nullopt;
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace carom
