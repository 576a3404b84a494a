// --labels FILE.seg.nrrd, read by a parser of its own: what 3D Slicer will find.
#include "cli/report_of.h"
#include "cli/volsurf_program.h"

#include <sstream>

namespace volsurf::test {
namespace {

using nlohmann::json;

constexpr char kPython[] = "/usr/bin/python3";

/// Prints the key/value pairs, the voxels of each label, and the label at each of the positions of argv[2] (LPS mm).
constexpr char kReader[] = R"python(import gzip, json, re, struct, sys
header, _, data = open(sys.argv[1], "rb").read().partition(b"\n\n")
lines = [line for line in header.decode().split("\n")[1:] if not line.startswith("#")]
pairs = dict(line.split(":=", 1) for line in lines if ":=" in line)
fields = dict(line.split(": ", 1) for line in lines if ":=" not in line)
assert fields["space"] == "left-posterior-superior" and fields["dimension"] == "3"
vector = lambda text: [float(part) for part in text.strip("()").split(",")]
origin = vector(fields["space origin"])
axes = [vector(text) for text in fields["space directions"].split(" ")]
sizes = [int(text) for text in fields["sizes"].split()]
code = {"unsigned char": "B", "unsigned short": "H", "unsigned int": "I"}[fields["type"]]
raw = gzip.decompress(data)
labels = struct.unpack("<%d%s" % (sizes[0] * sizes[1] * sizes[2], code), raw)
counts = {}
for label in labels:
    counts[label] = counts.get(label, 0) + 1

def determinant(a, b, c):
    minor = lambda i, j: b[i] * c[j] - b[j] * c[i]
    return a[0] * minor(1, 2) - a[1] * minor(0, 2) + a[2] * minor(0, 1)

def label_at(position):  # by Cramer's rule; at the centre of a voxel
    p = [x - o for x, o in zip(position, origin)]
    whole = determinant(*axes)
    index = [determinant(*(axes[:i] + [p] + axes[i + 1:])) / whole for i in range(3)]
    assert all(abs(x - round(x)) < 1e-3 for x in index), index
    x, y, z = (round(x) for x in index)
    return labels[x + sizes[0] * (y + sizes[1] * z)]

json.dump({
  "type" : fields["type"], "sizes" : sizes, "origin" : origin, "axes" : axes, "pairs" : pairs, "counts":
  {str(label): count for label, count in counts.items()
  },
           "at": [label_at(position) for position in json.loads(sys.argv[2])]}, sys.stdout)
)python";

class Segmentation : public VolsurfProgram {
protected:
  Segmentation() { write_file(inputs / "reader.py", kReader); }

  json report(const std::string &arguments) const
  {
    const Outcome outcome = run(arguments + " --report -");
    EXPECT_EQ(outcome.exit_code, 0) << arguments << ": " << outcome.err;
    return report_of(outcome);
  }

  json read(const std::string &name, const json &positions = json::array()) const
  {
    const Outcome outcome = run_program(inputs.path(), std::string(kPython) + " reader.py '" + (work / name).string() +
                                                           "' '" + positions.dump() + "'");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return report_of(outcome);
  }
};

/// The labels of segments 0, 1, ..., as the file tells them.
std::vector<int> labels_of(const json &segmentation)
{
  std::vector<int> labels;
  const json &pairs = segmentation["pairs"];
  for (int i = 0; pairs.contains("Segment" + std::to_string(i) + "_ID"); ++i)
    labels.push_back(std::stoi(pairs["Segment" + std::to_string(i) + "_LabelValue"].get<std::string>()));
  return labels;
}

TEST_F(Segmentation, OfTheShippedBrainHasTheCellsThatTheReportCounts)
{
  const json whole = report(VOLSURF_SOURCE "/data/brain.nrrd --delta 20 --labels brain.seg.nrrd");
  json places = json::array();
  for (const json &region : whole["strongest_regions"])
    places.push_back(region["maximum_mm"]);
  const json segmentation = read("brain.seg.nrrd", places);
  std::int64_t background = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const json &region = whole["strongest_regions"][i];
    if (region["id"] == whole["background_region"])
      background = region["cells"];
    else
      EXPECT_EQ(segmentation["counts"][region["id"].dump()], region["cells"]);
    EXPECT_EQ(segmentation["at"][i], region["id"] == whole["background_region"] ? json(0) : region["id"]);
  }
  EXPECT_EQ(segmentation["counts"]["0"], background);
  EXPECT_EQ(labels_of(segmentation).size(), whole["counts"]["regions"].get<std::size_t>() - 1);
  EXPECT_EQ(segmentation["counts"].size(), labels_of(segmentation).size() + 1);
  EXPECT_EQ(segmentation["type"], "unsigned char");
}

TEST_F(Segmentation, LiesOverAnObliqueScan)
{
  const std::string place = "space: left-posterior-superior\nspace origin: (10,-20,30)\n"
                            "space directions: (1.2,1.6,0) (-0.8,0.6,0) (0,0,-3)\n";
  const json whole = report(input("oblique.nrrd", float_nrrd(ball_samples(), kBallSizes, place)) +
                            " --delta 0.5 --sigma 0 --labels s.seg.nrrd --frame ras");
  const json &inside = whole["strongest_regions"][whole["strongest_regions"][0]["id"] == 1 ? 1 : 0];
  const json segmentation = read("s.seg.nrrd", json({inside["maximum_mm"]}));
  EXPECT_EQ(segmentation["at"][0], inside["id"]);
  EXPECT_EQ(segmentation["counts"][inside["id"].dump()], inside["cells"]);
  // Slicer's own description of the grid is in RAS, by rows, then the extent.
  std::istringstream numbers(segmentation["pairs"]["Segmentation_ConversionParameters"].get<std::string>());
  std::string name;
  std::getline(numbers, name, '|');
  EXPECT_EQ(name, "Reference image geometry");
  for (std::size_t i = 0; i < 22; ++i) {
    const std::size_t row = i / 4;
    const std::size_t column = i % 4;
    const double sign = row < 2 ? -1 : 1;
    double expected = i % 2 == 0 ? 0 : 16; // the extent
    if (i < 12)
      expected = sign * (column < 3 ? segmentation["axes"][column][row] : segmentation["origin"][row]).get<double>();
    else if (i < 16)
      expected = i == 15 ? 1 : 0;
    std::string number;
    std::getline(numbers, number, ';');
    EXPECT_NEAR(std::stod(number), expected, 1e-12) << i;
  }
}

TEST_F(Segmentation, SaysWhatSlicerAsksFor)
{
  report(balls() + " --delta 2 --sigma 0 --region 3 --region 20 --labels s.seg.nrrd");
  const json segmentation = read("s.seg.nrrd");
  const json &pairs = segmentation["pairs"];
  EXPECT_EQ(pairs["Segmentation_MasterRepresentation"], "Binary labelmap");
  EXPECT_EQ(pairs["Segmentation_ContainedRepresentationNames"], "Binary labelmap|");
  EXPECT_EQ(pairs["Segmentation_ReferenceImageExtentOffset"], "0 0 0");
  EXPECT_EQ(labels_of(segmentation), (std::vector<int>{3, 20}));
  for (const std::string segment : {"Segment0_", "Segment1_"}) {
    EXPECT_EQ(pairs[segment + "Layer"], "0");
    EXPECT_EQ(pairs[segment + "Extent"], "0 34 0 34 0 34") << "of the layer that the segments share";
    EXPECT_EQ(pairs[segment + "NameAutoGenerated"], "1");
    EXPECT_EQ(pairs[segment + "ColorAutoGenerated"], "1");
    EXPECT_TRUE(contains(pairs[segment + "Tags"], "TerminologyEntry:Segmentation category and type - 3D Slicer "
                                                  "General Anatomy list~SCT^85756007^Tissue~"));
  }
  EXPECT_EQ(pairs["Segment0_ID"], "region_3");
  const std::string cells = segmentation["counts"]["20"].dump();
  EXPECT_EQ(pairs["Segment1_Name"],
            cells.size() < 3 ? "region 20 (" + cells + ".0 mm3)" : "region 20 (0." + cells + " ml)");
  EXPECT_NE(pairs["Segment0_Color"], pairs["Segment1_Color"]);
  EXPECT_EQ(segmentation["counts"].size(), 3U) << "two segments and nothing";
}

TEST_F(Segmentation, ARegionKeepsItsColourAndLabelWhateverElseIsThere)
{
  const std::string scan = balls() + " --delta 2 --sigma 0 --labels s.seg.nrrd";
  report(scan);
  const json all = read("s.seg.nrrd");
  report(scan + " --region 9");
  const json one = read("s.seg.nrrd");
  EXPECT_EQ(one["pairs"]["Segment0_Color"], all["pairs"]["Segment7_Color"]);
  EXPECT_EQ(one["pairs"]["Segment0_Name"], all["pairs"]["Segment7_Name"]);
  EXPECT_EQ(one["counts"]["9"], all["counts"]["9"]);
  EXPECT_EQ(labels_of(all).size(), 27U);
}

TEST_F(Segmentation, HoldsThe255LargestAndSaysWhatItLeavesOut)
{
  const json whole = report(head(48) + " --delta 0.01 --labels s.seg.nrrd");
  const auto regions = whole["counts"]["regions"].get<int>() - 1;
  ASSERT_GT(regions, 255);
  EXPECT_EQ(labels_of(read("s.seg.nrrd")).size(), 255U);
  EXPECT_EQ(whole["warnings"], json({"s.seg.nrrd holds the 255 largest of " + std::to_string(regions) +
                                     " regions; choose by --min-volume, --region or a larger --delta"}));
}

TEST_F(Segmentation, PlainLabelsHoldAllRegionsAndNoSegments)
{
  report(balls() + " --delta 2 --sigma 0 --region 3 --labels l.nrrd");
  const json labels = read("l.nrrd");
  EXPECT_EQ(labels["counts"].size(), 28U);
  EXPECT_FALSE(labels["counts"].contains("0"));
  EXPECT_TRUE(labels_of(labels).empty());
}

} // namespace
} // namespace volsurf::test
