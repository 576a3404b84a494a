// The report: real ones are valid by docs/report.schema.json, and what they count adds up.
#include "cli/report_of.h"
#include "cli/volsurf_program.h"

#include <iterator>

namespace volsurf::test {
namespace {

using nlohmann::json;

constexpr char kPython[] = "/usr/bin/python3";

class ReportFile : public VolsurfProgram {
protected:
  json report(const std::string &arguments) const
  {
    const Outcome outcome = run(arguments + " --report r.json");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(read_file(work / "r.json"));
  }
};

class ReportSchema : public ReportFile {
protected:
  void SetUp() override
  {
    if (run_program(work.path(), std::string(kPython) + " -c 'import jsonschema'").exit_code != 0)
      GTEST_SKIP() << "python3-jsonschema is missing: scripts/install_packages.sh --test installs it";
    write_file(inputs / "validate.py", R"(import json, sys
from jsonschema import Draft202012Validator as Validator
schema = json.load(open(sys.argv[1]))
Validator.check_schema(schema)
validator = Validator(schema)
objections = lambda report: [f"{error.json_path}: {error.message}" for error in validator.iter_errors(report)]
json.dump([" ".join(objections(report)) for report in json.load(open(sys.argv[2]))], sys.stdout)
)");
  }

  /// What the schema has against each of the reports.
  std::vector<std::string> objections(const std::vector<json> &reports) const
  {
    write_file(inputs / "reports.json", json(reports).dump());
    const Outcome outcome = run_program(inputs.path(), std::string(kPython) + " validate.py '" VOLSURF_SOURCE
                                                                              "/docs/report.schema.json' reports.json");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const json list = json::parse(outcome.out, nullptr, false);
    return list.size() == reports.size() ? list.get<std::vector<std::string>>()
                                         : std::vector<std::string>(reports.size(), "no answer: " + outcome.err);
  }
};

TEST_F(ReportSchema, AcceptsReportsOfEachKindOfRun)
{
  const std::string scan = head(48);
  std::vector<json> reports;
  for (const std::string options :
       {"--delta 15", "--delta 15 --surface hull --frame ras", "--delta 20 --paper --keep 2 --rank-by radius",
        "--delta 10 --exterior infinite --keep 5% --rank-by area -o a.vdb -o a.stl --labels l.nrrd --save-hierarchy "
        "h.volsurf",
        "--delta 15 --seed 35,0,30 --smooth 0", "--delta 15 --region 2 --region 3 --split regions --labels l.seg.nrrd",
        "--delta 5 --min-volume 2000 --split components -o a.vdb -o a.ply -o a.obj",
        "--delta 5 --edge-map --threads 1 --smooth 1", "--delta 15 --median 2", "--delta 15 --oversample 2",
        "--method threshold --keep 1", "--method isosurface --iso 40 --keep 1", "--method marching-cubes --smooth 1",
        "--method watershed --delta 15 --surface hull", "--method watershed --delta 15 --edge-map --split components",
        "", "--regions 5", "--delta 12.5% --keep 1"})
    reports.push_back(report(scan + " " + options));
  reports.push_back(report("h.volsurf --delta 20"));
  EXPECT_EQ(objections(reports), std::vector<std::string>(reports.size()));
}

TEST_F(ReportSchema, RefusesMissingAndUnknownKeysAtEveryLevel)
{
  const json whole = report(ball() + " --delta 2");
  std::vector<json> damaged;
  std::vector<std::string> expected;
  for (const std::string place :
       {"", "/source", "/geometry", "/options", "/counts", "/strongest_regions/0", "/surfaces/0", "/mesh"}) {
    const json::json_pointer pointer(place);
    damaged.push_back(whole);
    damaged.back()[pointer]["surprise"] = 1;
    expected.emplace_back("'surprise' was unexpected");
    for (const auto &[key, value] : whole[pointer].items()) {
      damaged.push_back(whole);
      damaged.back()[pointer].erase(key);
      expected.push_back("'" + key + "' is a required property");
    }
  }
  const std::vector<std::string> found = objections(damaged);
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_TRUE(contains(found[i], expected[i]));
}

TEST_F(ReportSchema, DescribesEveryKey)
{
  const json schema = json::parse(read_file(VOLSURF_SOURCE "/docs/report.schema.json"));
  const auto describes = [](const json &object) {
    for (const auto &[key, value] : object["properties"].items())
      EXPECT_TRUE(value.contains("description") || value.contains("$ref")) << key;
  };
  describes(schema);
  for (const std::string part : {"source", "geometry", "options", "counts", "mesh"})
    describes(schema["properties"][part]);
}

TEST_F(ReportFile, NamesTheSourceAndItsDigest)
{
  const json source = report(ball() + " --delta 2")["source"];
  EXPECT_EQ(source["path"], ball());
  EXPECT_EQ(source["bytes"], std::filesystem::file_size(ball()));
  EXPECT_EQ(source["pixel_type"], "float32");
  const std::string digest = run_program(work.path(), "sha256sum " + ball()).out;
  EXPECT_EQ(source["sha256"], digest.substr(0, 64));
}

TEST_F(ReportFile, CountsAddUp)
{
  const json whole = report(balls() + " --delta 2 --sigma 0 --keep 3 --smooth 0");
  const json &counts = whole["counts"];
  EXPECT_EQ(counts["samples"], 36 * 36 * 36);
  EXPECT_EQ(counts["cells"], 35 * 35 * 35);
  EXPECT_EQ(counts["non_finite_gradients"], 0);
  EXPECT_EQ(counts["components_kept"], 3);
  EXPECT_EQ(counts["components"].get<int>(),
            counts["components_kept"].get<int>() + counts["components_dropped"].get<int>());
  ASSERT_EQ(whole["component_sizes"].size(), 3U);
  double kept_faces = 0;
  for (const double size : whole["component_sizes"])
    kept_faces += size;
  EXPECT_EQ(whole["mesh"]["triangles"], 2 * kept_faces);
  EXPECT_LT(kept_faces, counts["boundary_faces"]);
  EXPECT_EQ(counts["regions"], 28);
  EXPECT_LE(counts["regions"], counts["basins"]);
}

TEST_F(ReportFile, EveryBoundaryFaceIsInTheMeshWhereAllAreKept)
{
  const json whole = report(head(48) + " --delta 15");
  EXPECT_EQ(whole["mesh"]["triangles"], 2 * whole["counts"]["boundary_faces"].get<int>());
  EXPECT_EQ(whole["counts"]["components_dropped"], 0);
}

TEST_F(ReportFile, TheOneSurfaceIsTheMesh)
{
  const json whole = report(head(48) + " --delta 15 --surface hull -o a.stl -o a.vdb -o a.ply");
  ASSERT_EQ(whole["surfaces"].size(), 1U);
  const json &surface = whole["surfaces"][0];
  EXPECT_EQ(surface["files"], json({"a.stl", "a.ply"}));
  EXPECT_TRUE(surface["region"].is_null());
  EXPECT_TRUE(surface["component"].is_null());
  for (const std::string key : {"triangles", "watertight", "volume_mm3", "volume_drift"})
    EXPECT_EQ(surface[key], whole["mesh"][key]) << key;
}

TEST_F(ReportFile, StrongestRegionsDecreaseFromTheOneThatNothingJoins)
{
  for (const std::string exterior : {"none", "infinite"}) {
    const json whole = report(head(48) + " --sigma 0 --delta 5 --exterior " + exterior);
    const json &strongest = whole["strongest_regions"];
    ASSERT_EQ(strongest.size(), exterior == "none" ? 20U : 19U) << "the exterior has no place to report";
    double above = whole["largest_persistence"];
    for (std::size_t i = 0; i < strongest.size(); ++i) {
      const json &persistence = strongest[i]["persistence"];
      if (persistence.is_null()) {
        EXPECT_TRUE(i == 0 && exterior == "none") << i;
        continue;
      }
      EXPECT_LE(persistence, above);
      EXPECT_GE(persistence, 5);
      above = persistence;
    }
  }
}

TEST_F(ReportFile, TellsHowDeltaWasChosen)
{
  const json whole = report(head(48));
  const json &choice = whole["delta_choice"];
  EXPECT_EQ(choice["given"], "--delta auto");
  EXPECT_NEAR(choice["noise"]["floor"], 1.7 * choice["noise"]["in_gradient"].get<double>(), 1e-9);
  ASSERT_FALSE(choice["candidates"].empty());
  EXPECT_EQ(choice["candidates"][0]["delta"], whole["options"]["delta"]);
  EXPECT_EQ(choice["candidates"][0]["regions"], whole["counts"]["regions"]);

  const json by_value = report(head(48) + " --delta 15")["delta_choice"];
  EXPECT_EQ(by_value["given"], "--delta 15");
  EXPECT_TRUE(by_value["noise"].is_null());
}

TEST_F(ReportFile, TellsOptionsAsUsed)
{
  const json options = report(ball() + " --delta 2 --rank-by area --keep 50% -o a.stl --labels l.nrrd")["options"];
  EXPECT_EQ(options["delta"], 2);
  EXPECT_EQ(options["sigma_mm"], 1) << "the mean spacing";
  EXPECT_EQ(options["keep"], "50%");
  EXPECT_EQ(options["rank_by"], "area");
  EXPECT_EQ(options["outputs"], json({"a.stl"}));
  EXPECT_EQ(options["labels"], "l.nrrd");
  EXPECT_EQ(options["report"], "r.json");
  EXPECT_EQ(options["exterior"], "none");
  EXPECT_EQ(options["surface"], "all");
  EXPECT_EQ(options["iterations"], 30);
  EXPECT_EQ(options["oversampling"], 1);
  const json finer = report(ball() + " --delta 2 --oversample 2")["options"];
  EXPECT_EQ(finer["oversampling"], 2);
  EXPECT_EQ(finer["sigma_mm"], 0.65) << "of the scan's voxel";
  EXPECT_EQ(finer["iterations"], 60);
  EXPECT_EQ(report(ball() + " --delta 2 --threads 1")["options"]["threads"], 1);
}

} // namespace
} // namespace volsurf::test
