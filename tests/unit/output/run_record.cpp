#include "host/output/run_record.hpp"

#include <cmath>
#include <limits>
#include <regex>
#include <set>
#include <sstream>

#include "host/output/atomic_file.hpp"
#include "temporary_folder.hpp"

namespace riffle {
namespace {

using Json = nlohmann::ordered_json;

RunRecord sample() {
  RunRecord r;
  r.case_name = "wet-0.5";
  r.title = "Dam break on a wet bed";
  r.time = 6;
  r.steps = 4;
  r.particles = 8000;
  r.errors["depth"] = {0.1, 0.2, 0.3, 0.05, 7990, 10, "exact"};
  r.extrema["depth"] = {5, 10, 10};
  r.mass = {100, 0, 0, 100};
  r.momentum = {{0}, {1}, 2};
  r.limits["courant"] = {3, 1e-3};
  r.limits["last step"] = {1, 1e-5};
  r.plugins.push_back(
      {"viscosity", "viscosity", "monaghan", "1.0.0", "libmonaghan.so", "sha256:00", "GCC", {{"alpha", 1.0}}});
  r.verdicts.push_back({"mass", "mass is conserved to 1e-16", Severity::note});
  r.overrides = {"time.end=6"};
  r.manifest = R"({"time": {"end": 6.0}})";
  r.volume = VolumeLedger{1, 1, 1};
  r.dam = DepthStep{100, 10, 5};
  r.fronts = {44, 43, 42, 8, 7};
  r.neighbours = NeighbourStatistics{7.9, 4, 8};
  r.averages = FlowAverages{};
  r.averages->samples = 1;
  for (auto* row : {&r.averages->z, &r.averages->velocity, &r.averages->rms_x, &r.averages->rms_z,
                    &r.averages->modelled, &r.averages->resolved, &r.averages->virial, &r.averages->pressure})
    *row = {0.5};
  return r;
}

TEST(RunRecord, HasTheKeysThatScriptsRelyOn) {
  const Json json = to_json(sample());
  for (const char* key : {"/status",
                          "/case",
                          "/time",
                          "/steps",
                          "/particles",
                          "/wall_seconds",
                          "/cpu_seconds",
                          "/particle_steps_per_second",
                          "/evaluations_per_second",
                          "/errors/depth/l1",
                          "/errors/depth/l2",
                          "/errors/depth/linf",
                          "/errors/depth/mean",
                          "/extrema/depth/min",
                          "/extrema/depth/max",
                          "/extrema/depth/max_abs",
                          "/ledger/mass/initial",
                          "/ledger/mass/in",
                          "/ledger/mass/out",
                          "/ledger/mass/final",
                          "/ledger/mass/imbalance",
                          "/ledger/momentum",
                          "/dt_limiters",
                          "/fronts/toe",
                          "/fronts/mid",
                          "/fronts/crest",
                          "/plateau",
                          "/active_fraction",
                          "/profiles/velocity/mean",
                          "/stress/modelled",
                          "/stress/resolved",
                          "/stress/virial",
                          "/balance/momentum",
                          "/plugins/0/id",
                          "/verdicts/0/name"}) {
    EXPECT_TRUE(json.contains(Json::json_pointer(key))) << key;
  }
  EXPECT_EQ(json["status"], "finished");
  EXPECT_EQ(json["dt_limiters"]["courant"]["share"], 0.75);
  EXPECT_EQ(json["plugins"][0]["parameters"]["alpha"], 1.0);
  EXPECT_EQ(json["manifest"]["time"]["end"], 6.0);
}

TEST(RunRecord, WhatIsNotFiniteBecomesNull) {
  RunRecord r = sample();
  r.time = std::nan("");
  r.errors["depth"].l2 = std::numeric_limits<double>::infinity();
  r.momentum.final = {std::nan("")};
  const Json json = to_json(r);
  EXPECT_TRUE(json["time"].is_null());
  EXPECT_TRUE(json["errors"]["depth"]["l2"].is_null());
  EXPECT_TRUE(json["ledger"]["momentum"]["final"][0].is_null());
}

TEST(RunRecord, IsWrittenCompleteAndReadsBackToTheSameNumbers) {
  const TemporaryFolder folder;
  RunRecord r = sample();
  r.wall_seconds = 0.1 + 0.2;
  write_run_record(folder.path() / "run.json", r);
  const Json back = Json::parse(read_file(folder.path() / "run.json"));
  EXPECT_EQ(back, to_json(r));
  EXPECT_EQ(back["wall_seconds"].get<double>(), 0.1 + 0.2);
}

TEST(RunRecord, BadTextNeverCostsTheRecord) {
  const TemporaryFolder folder;
  RunRecord r = sample();
  r.message = "plugin said \xff\xfe";
  r.manifest = "not JSON";
  write_run_record(folder.path() / "run.json", r);
  EXPECT_EQ(Json::parse(read_file(folder.path() / "run.json"))["manifest"], "not JSON");
}

TEST(RunRecord, TheWorstVerdictDecides) {
  const Verdict note{"a", "", Severity::note}, suspect{"b", "", Severity::suspect}, failed{"c", "", Severity::failed};
  EXPECT_EQ(status_from({}), RunStatus::finished);
  EXPECT_EQ(status_from({note}), RunStatus::finished);
  EXPECT_EQ(status_from({note, suspect, note}), RunStatus::suspect);
  EXPECT_EQ(status_from({failed, suspect}), RunStatus::failed);
}

TEST(RunRecord, ExitCodesAreThoseOfTheDocumentation) {
  EXPECT_EQ(exit_code(RunStatus::finished, true), 0);
  EXPECT_EQ(exit_code(RunStatus::failed, false), 1);
  EXPECT_EQ(exit_code(RunStatus::suspect, false), 0);
  EXPECT_EQ(exit_code(RunStatus::suspect, true), 3);
}

TEST(MassLedger, ImbalanceIsWhatCannotBeAccountedFor) {
  EXPECT_EQ((MassLedger{100, 10, 30, 80}).imbalance(), 0);
  EXPECT_DOUBLE_EQ((MassLedger{100, 0, 0, 99}).imbalance(), -0.01);
  EXPECT_EQ((MassLedger{0, 0, 0, 0}).imbalance(), 0);
}

// Names of all values in a record, with the parts that depend on the case replaced: errors.<field>.l1
void collect(const Json& json, const std::string& path, std::set<std::string>& keys) {
  static const std::set<std::string> by_field{"errors", "extrema"},
      opaque{"manifest", "plugins[].parameters", "overrides"};
  if (opaque.count(path) > 0 || (!json.is_object() && !json.is_array()) || (json.is_array() && !json[0].is_object())) {
    keys.insert(path);
  } else if (json.is_array()) {
    collect(json[0], path + "[]", keys);
  } else {
    for (const auto& [name, value] : json.items()) {
      const std::string part = by_field.count(path) > 0 ? "<field>" : path == "dt_limiters" ? "<name>" : name;
      collect(value, path.empty() ? part : path + "." + part, keys);
    }
  }
}

TEST(RunRecord, IsDocumentedKeyByKey) {
  std::set<std::string> written, documented;
  collect(to_json(sample()), "", written);
  // A documented key is the first cell of a row, | `key` | ..., of the part on run.json.
  const std::string page = read_file(std::filesystem::path(RIFFLE_TEST_DATA) / "../../../docs/run-record.md");
  ASSERT_TRUE(contains(page, "\n## run.json\n"));
  std::istringstream lines(page.substr(page.find("\n## run.json\n")));
  const std::regex row(R"(^\| `([a-z0-9_<>.\[\]]+)` \|.*)");
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, match, row)) documented.insert(match[1]);
  }
  EXPECT_EQ(written, documented);
}

}  // namespace
}  // namespace riffle
