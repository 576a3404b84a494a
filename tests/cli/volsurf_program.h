// The program volsurf on small scans. VOLSURF and VOLSURF_PHANTOM are the programs' paths, VOLSURF_SOURCE the source
// tree's.
#pragma once

#include "support/contains.h"
#include "support/program.h"
#include "support/volume_bytes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

namespace volsurf::test {

/// A bright ball of radius 5 mm with a blurred wall, at `centre` of a dark cube, 18 samples of 1 mm to a side.
constexpr int kBallSize = 18;

inline std::vector<float> ball_samples(std::array<double, 3> centre = {8.5, 8.5, 8.5})
{
  std::vector<float> samples;
  for (int z = 0; z < kBallSize; ++z)
    for (int y = 0; y < kBallSize; ++y)
      for (int x = 0; x < kBallSize; ++x) {
        const double distance = std::hypot(x - centre[0], y - centre[1], z - centre[2]);
        samples.push_back(static_cast<float>(100 * std::clamp((6.5 - distance) / 3, 0.0, 1.0)));
      }
  return samples;
}

constexpr char kBallSizes[] = "18 18 18";

/// 27 bright balls, each of another radius, in a dark cube of 36 samples to a side.
inline std::vector<float> samples_of_27_balls()
{
  std::vector<float> samples;
  for (int z = 0; z < 36; ++z)
    for (int y = 0; y < 36; ++y)
      for (int x = 0; x < 36; ++x) {
        const int ball = x / 12 + 3 * (y / 12) + 9 * (z / 12);
        const double distance = std::hypot(x % 12 - 5.5, y % 12 - 5.5, z % 12 - 5.5);
        samples.push_back(static_cast<float>(100 * std::clamp(3.0 + ball / 20.0 - distance, 0.0, 1.0)));
      }
  return samples;
}

/// A raw NRRD file of float samples; `more` is further header lines.
inline std::string float_nrrd(const std::vector<float> &samples, const std::string &sizes = kBallSizes,
                              const std::string &more = "")
{
  return nrrd_header("float", sizes, "encoding: raw\n" + more) + "\n" + bytes_of(samples);
}

inline std::string first_line(const std::string &text)
{
  return text.substr(0, text.find('\n'));
}

inline bool is_one_line(const std::string &text)
{
  return std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n';
}

/// Scans in `inputs`, and the folder `work` that the program runs in and must keep clean.
class VolsurfProgram : public testing::Test {
protected:
  VolsurfProgram() { write_file(inputs / "ball.nrrd", float_nrrd(ball_samples())); }

  Outcome run(const std::string &arguments) const { return run_program(work.path(), "'" VOLSURF "' " + arguments); }

  /// The path of a new input.
  std::string input(const std::string &name, const std::string &bytes) const
  {
    write_file(inputs / name, bytes);
    return (inputs / name).string();
  }

  std::string ball() const { return (inputs / "ball.nrrd").string(); }

  std::string balls() const { return input("balls.nrrd", float_nrrd(samples_of_27_balls(), "36 36 36")); }

  /// A head of n^3 samples.
  std::string head(int size) const
  {
    const std::string path = (inputs / "head.nrrd").string();
    const std::string options = " --size " + std::to_string(size) + " --noise impulse:2% -o ";
    EXPECT_EQ(run_program(inputs.path(), "'" VOLSURF_PHANTOM "'" + options + path).exit_code, 0);
    return path;
  }

  std::set<std::string> files() const
  {
    std::set<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(work.path()))
      names.insert(entry.path().filename().string());
    return names;
  }

  /// The run ends with an exit code and one line that holds all parts, and neither writes nor leaves a file.
  void expect_refused(const std::string &arguments, int exit_code, const std::vector<std::string> &parts) const
  {
    const auto before = files();
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << arguments << ": " << outcome.err;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_TRUE(is_one_line(outcome.err)) << arguments << ": " << outcome.err;
    EXPECT_EQ(outcome.err.rfind("volsurf: ", 0), 0U) << outcome.err;
    for (const std::string &part : parts)
      EXPECT_TRUE(contains(outcome.err, part)) << arguments;
    EXPECT_EQ(files(), before) << arguments;
  }

  const TemporaryFolder inputs;
  const TemporaryFolder work;
};

} // namespace volsurf::test
