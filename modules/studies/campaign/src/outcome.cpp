#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/campaign/outcome.hpp>
#include <scree/files/text_file.hpp>
#include <scree/run/input_hashes.hpp>
#include <scree/run/result_kind.hpp>
#include <scree/run/series.hpp>
#include <scree/scenario/quantities.hpp>

namespace scree::campaign {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// Absent in a run.json of former versions.
std::optional<run::InputHashes> hashes_in(const Json& json) {
  if (!json.contains("inputs")) return std::nullopt;
  return run::input_hashes_of(json["inputs"]);
}

Status status_of(const Json& json, const Inputs& inputs) {
  if (json.at("scenario") != inputs.resolved_text || hashes_in(json) != inputs.hashes) return Status::changed;
  const std::string status = json.at("status");
  for (const Status known : {Status::finished, Status::failed, Status::running})
    if (status == status_name(known)) return known;
  return Status::interrupted;
}

// Values of quantities "<probe>.<column>.<statistic>" from the series of a run. Where a series is missing or
// damaged, its quantities are omitted, and a line "<what>; <cure>" is appended to `damaged`.
std::vector<std::pair<std::string, double>> collected(const std::filesystem::path& directory,
                                                      const std::vector<std::string>& names,
                                                      std::vector<std::string>& damaged) {
  std::vector<std::pair<std::string, double>> numbers;
  for (const std::string& name : names) {
    const scenario::SeriesQuantity of = scenario::series_quantity(name);
    try {
      const std::vector<double> values = run::series_column(directory / "series" / (of.probe + ".csv"),
                                                            of.column, "run the campaign with --overwrite");
      if (!values.empty()) numbers.emplace_back(name, scenario::series_statistic(values, of.statistic));
    } catch (const Error& error) {
      if (std::find(damaged.begin(), damaged.end(), error.what()) == damaged.end())
        damaged.push_back(error.what());
    }
  }
  return numbers;
}

void add_numbers(const Json& json, const std::string& above, Outcome& outcome) {
  for (const auto& [key, value] : json.items()) {
    if (value.is_number()) outcome.numbers.emplace_back(above + key, value.get<double>());
    if (value.is_object()) add_numbers(value, above + key + ".", outcome);
  }
}

void add_expectations(const Json& json, Outcome& outcome) {
  for (const Json& expectation : json.at("expect")) {
    outcome.expectations.push_back({expectation.at("requirement"), expectation.at("met")});
    const std::string quantity = expectation.at("quantity");
    const bool known = std::any_of(outcome.numbers.begin(), outcome.numbers.end(),
                                   [&](const auto& number) { return number.first == quantity; });
    if (!known && expectation.at("value").is_number())
      outcome.numbers.emplace_back(quantity, expectation.at("value").get<double>());
  }
}

}  // namespace

const char* status_name(Status status) {
  static constexpr const char* names[] = {"missing", "changed",  "interrupted", "running",
                                          "failed",  "finished", "queued"};
  return names[std::size_t(status)];
}

double Outcome::number(const std::string& name) const {
  for (const auto& [known, value] : numbers)
    if (known == name) return value;
  return std::numeric_limits<double>::quiet_NaN();
}

std::size_t Outcome::unmet() const {
  return std::size_t(
      std::count_if(expectations.begin(), expectations.end(), [](const Judged& j) { return !j.met; }));
}

Outcome read_outcome(const fs::path& directory, const Campaign& campaign, const Inputs& inputs) {
  const fs::path record = directory / campaign.record();
  Outcome outcome;
  std::error_code failed;
  const fs::file_status status = fs::status(record, failed);
  if (status.type() == fs::file_type::not_found) return outcome;
  if (!fs::status_known(status)) {
    outcome.problem =
        fmt::format("{}: cannot be read ({}); check its permissions", record.string(), failed.message());
    return outcome;
  }
  try {
    const Json json = run::parse_record(files::read_text(record));
    if (!json.is_object()) return outcome;
    outcome.status = status_of(json, inputs);
    if (outcome.status == Status::failed) {
      outcome.problem = json.value("error", "");
      outcome.blew_up = json.value("exit_status", 0) == int(ExitStatus::blow_up);
    }
    if (outcome.status != Status::finished) return outcome;
    std::vector<std::string> damaged;
    outcome.numbers = collected(directory, campaign.collect, damaged);
    add_numbers(json, "", outcome);
    add_expectations(json, outcome);
    if (json.contains("warnings")) outcome.warnings = json["warnings"];
    outcome.warnings.insert(outcome.warnings.end(), damaged.begin(), damaged.end());
    return outcome;
  } catch (const Json::exception&) {
    return {};
  } catch (const files::ReadError& error) {
    outcome.problem = error.what();
    return outcome;
  }
}

}  // namespace scree::campaign
