// volsurf-phantom: writes a synthetic T1-weighted head, or a single body, with its truth as labels and as a surface; or
// a given scan with noise added.
#include "program/program.h"

#include "volsurf/core/error.h"
#include "volsurf/core/parallel.h"
#include "volsurf/field/gaussian_blur.h"
#include "volsurf/interop/zero_surface.h"
#include "volsurf/io/output_file.h"
#include "volsurf/io/read_volume.h"
#include "volsurf/io/write_mesh.h"
#include "volsurf/io/write_volume.h"
#include "volsurf/phantom/body_phantom.h"
#include "volsurf/phantom/noise.h"
#include "volsurf/phantom/phantom.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <map>
#include <new>
#include <optional>
#include <sstream>
#include <string_view>

namespace {

using namespace volsurf;

constexpr const char *kProgram = "volsurf-phantom";

bool carry_on(std::string_view /*stage*/, double /*fraction*/)
{
  return !was_interrupted();
}

struct Arguments {
  std::vector<std::int64_t> size{128};
  std::vector<double> spacing_mm;
  std::vector<double> offset_mm{0};
  std::string noise = "none";
  std::string shape = "head";
  std::optional<double> bias;
  double blur_mm = 0;
  std::int64_t anatomy = static_cast<std::int64_t>(PhantomOptions().anatomy);
  std::int64_t seed = static_cast<std::int64_t>(NoiseOptions().seed);
  std::string type;
  std::string scan;
  std::string output;
  std::string truth;
  std::string truth_surface;
  int threads = 0;
};

void add_options(CLI::App &app, Arguments &arguments)
{
  app.add_option("-o,--output", arguments.output, "The scan, .nrrd")->required();
  app.add_option("--truth", arguments.truth,
                 "The tissue of each sample, .nrrd: 0 air, 1 scalp, 2 skull, 3 cerebrospinal fluid, 4 grey matter, "
                 "5 white matter, 6 ventricle, 7 muscle; of other shapes 1 inside");
  app.add_option("--truth-surface", arguments.truth_surface,
                 "The true surface, .vtp: of the head its brain (4, 5 and 6); closed where the scan's border cuts it");
  app.add_option("--shape", arguments.shape,
                 "head; or a single body of intensity 200 on 100, each sample the mean over its voxel: sphere, torus, "
                 "blobs (two balls that touch), shell (hollow, 3 voxels thick) or cortex (the head's brain) (head)");
  auto *const scan =
      app.add_option("--scan", arguments.scan, "Add the noise to this scan, of any format that volsurf reads, instead");
  app.add_option("--size", arguments.size, "Samples per axis: N or X,Y,Z (128)")->delimiter(',')->expected(1, 3);
  app.add_option("--spacing", arguments.spacing_mm,
                 "Millimetres between samples: S or X,Y,Z (so that the head, 204.8 mm, fits; shapes other than head "
                 "and cortex 1)")
      ->delimiter(',')
      ->expected(1, 3);
  app.add_option("--offset", arguments.offset_mm,
                 "Move a single body by X,Y,Z mm from the middle; the scan's border may cut it (0,0,0)")
      ->delimiter(',')
      ->expected(3);
  app.add_option(
      "--noise", arguments.noise,
      "none, impulse:2% (this part of the samples becomes uniform over the scan's range), gaussian:5% or "
      "rician:5% (standard deviation, in percent of the contrast: of brightest minus darkest tissue, 1030, of a "
      "body on its surroundings, 100, or of the range of --scan; without % in intensity) (none)");
  app.add_option("--bias", arguments.bias,
                 "Bias field: a factor of 1 - B/2 to 1 + B/2, B in 0 .. 1 (0.2; shapes other than head 0)");
  app.add_option("--blur", arguments.blur_mm,
                 "Blur the scan by a Gaussian of this many mm, after the noise, as volsurf's gradient does (0)")
      ->needs(scan);
  app.add_option("--seed", arguments.seed, "Seed of the noise")->capture_default_str();
  app.add_option("--anatomy", arguments.anatomy, "Seed of the folds and of the bias field")->capture_default_str();
  app.add_option("--type", arguments.type,
                 "uint16 (12 bits: 0 .. 4095), uint8 (scaled: 255 is intensity 1600) or float (uint16; shapes other "
                 "than head float; with --scan always float)");
  app.add_option("--threads", arguments.threads, "Threads; 0: all. They do not change the result")
      ->capture_default_str();
  app.set_version_flag("--version", "volsurf-phantom " VOLSURF_VERSION);
  for (const char *const option :
       {"--size", "--spacing", "--offset", "--bias", "--anatomy", "--truth", "--truth-surface", "--type", "--shape"})
    scan->excludes(app.get_option(option));
}

/// One number for all axes, or one for each.
template <typename T> std::array<T, 3> per_axis(const std::vector<T> &values, const std::string &option)
{
  if (values.size() == 1)
    return {values[0], values[0], values[0]};
  if (values.size() != 3)
    throw UsageError(option + ": " + std::to_string(values.size()) + " numbers, 1 or 3 are needed");
  return {values[0], values[1], values[2]};
}

void fit_to_type(Volume &volume, PixelType type)
{
  if (type == PixelType::float32)
    return;
  constexpr float kWhiteOfUint8 = 1600; // above every noise-free intensity
  const float scale = type == PixelType::uint8 ? 255 / kWhiteOfUint8 : 1;
  for (float &sample : volume.samples)
    sample = std::clamp(sample, 0.0F, kLargestIntensity) * scale;
}

PixelType parse_type(const std::string &name)
{
  const std::map<std::string, PixelType> types{
      {"uint8", PixelType::uint8}, {"uint16", PixelType::uint16}, {"float", PixelType::float32}};
  const auto found = types.find(name);
  if (found == types.end())
    throw UsageError("--type: \"" + name + "\" is not uint16, uint8 or float");
  return found->second;
}

std::uint64_t not_negative(std::int64_t number, const std::string &option)
{
  if (number < 0)
    throw UsageError(option + ": " + std::to_string(number) + ", must be 0 or more");
  return static_cast<std::uint64_t>(number);
}

void check_outputs(const Arguments &arguments)
{
  require_nrrd_extension(arguments.output);
  if (!arguments.truth.empty())
    require_nrrd_extension(arguments.truth);
  if (!arguments.truth_surface.empty())
    require_extension(arguments.truth_surface, ".vtp");
  if (arguments.truth == arguments.output)
    throw UsageError("--truth: " + arguments.truth + " is the file of --output too");
}

/// What the options ask for, with the defaults that depend on the shape.
struct Job {
  std::optional<BodyKind> body; ///< nothing: the head
  PhantomOptions options;
  NoiseOptions noise;
  PixelType type;
  std::string type_name;
};

Vec3 default_spacing(const Job &job)
{
  if (job.body && job.body != BodyKind::kCortex)
    return {1, 1, 1};
  return spacing_that_fits_the_head(job.options.size);
}

Job make_job(const Arguments &arguments)
{
  Job job;
  job.body = parse_body(arguments.shape);
  PhantomOptions &options = job.options;
  options.size = per_axis(arguments.size, "--size");
  options.spacing_mm =
      arguments.spacing_mm.empty() ? default_spacing(job) : per_axis(arguments.spacing_mm, "--spacing");
  options.bias = arguments.bias.value_or(job.body ? 0 : PhantomOptions().bias);
  options.anatomy = not_negative(arguments.anatomy, "--anatomy");
  options.with_truth = !arguments.truth.empty();
  options.offset_mm = per_axis(arguments.offset_mm, "--offset");
  if (!job.body && options.offset_mm != Vec3{})
    throw UsageError("--offset: moves single bodies; --shape head has its place");
  job.noise = parse_noise(arguments.noise, job.body ? kBodySignal - kBodySurroundings : kTissueContrast);
  job.noise.seed = not_negative(arguments.seed, "--seed");
  job.type_name = !arguments.type.empty() ? arguments.type : job.body ? "float" : "uint16";
  job.type = parse_type(job.type_name);
  return job;
}

/// What made the volume, without what does not change it: threads and file names.
std::string options_as_used(const Arguments &arguments, const Job &job)
{
  std::ostringstream text;
  const Index3 &size = job.options.size;
  const Vec3 &spacing = job.options.spacing_mm;
  if (job.body)
    text << "--shape " << arguments.shape << ' ';
  const Vec3 &offset = job.options.offset_mm;
  if (offset != Vec3{})
    text << "--offset " << offset[0] << ',' << offset[1] << ',' << offset[2] << ' ';
  text << "--size " << size[0] << ',' << size[1] << ',' << size[2] << " --spacing " << spacing[0] << ',' << spacing[1]
       << ',' << spacing[2] << " --noise " << arguments.noise << " --bias " << job.options.bias << " --seed "
       << arguments.seed << " --anatomy " << arguments.anatomy << " --type " << job.type_name;
  return text.str();
}

/// Calls write(temporary file). Its errors shall name the file that the user asked for. Throws Cancelled.
template <typename Write> void write_to(const PendingOutput &output, const Write &write)
{
  report_progress(carry_on, "write", 0);
  try {
    write(output.temporary_path());
  } catch (const OutputError &) {
    throw OutputError(output.target().string() + ": cannot be written; is the disk full?");
  }
  report_progress(carry_on, "write", 1);
}

/// Noise on top of a real scan.
void run_on_scan(const Arguments &arguments)
{
  require_nrrd_extension(arguments.output);
  InputVolume input = read_volume(arguments.scan);
  PendingOutput output(arguments.output);
  const ThreadLimit limit(static_cast<int>(not_negative(arguments.threads, "--threads")));
  const auto [low, high] = std::minmax_element(input.volume.samples.begin(), input.volume.samples.end());
  NoiseOptions noise = parse_noise(arguments.noise, static_cast<double>(*high) - *low);
  noise.seed = not_negative(arguments.seed, "--seed");
  add_noise(input.volume, noise);
  std::string options = "--noise " + arguments.noise + " --seed " + std::to_string(arguments.seed);
  if (arguments.blur_mm != 0) {
    input.volume.samples = gaussian_blur(input.volume, arguments.blur_mm);
    options += " --blur " + CLI::detail::to_string(arguments.blur_mm);
  }
  const Provenance provenance{"volsurf-phantom " VOLSURF_VERSION,
                              std::filesystem::path(arguments.scan).filename().string(), options};
  write_to(output, [&](const auto &file) { write_volume(input.volume, PixelType::float32, file, provenance); });
  output.commit();
}

/// The files of a phantom begin before the work: what cannot be written must not cost the time to make it.
struct Outputs {
  PendingOutput scan;
  std::optional<PendingOutput> truth;
  std::optional<PendingOutput> truth_surface;
};

Outputs begin_outputs(const Arguments &arguments)
{
  check_outputs(arguments);
  Outputs outputs{PendingOutput(arguments.output), {}, {}};
  if (!arguments.truth.empty())
    outputs.truth.emplace(arguments.truth);
  if (!arguments.truth_surface.empty())
    outputs.truth_surface.emplace(arguments.truth_surface);
  return outputs;
}

void write_truth_surface(const Job &job, const Grid &grid, const PendingOutput &output, const Provenance &provenance)
{
  const BodyKind body = job.body.value_or(BodyKind::kCortex);
  const Volume distances = sample_distance(body_distance(body, grid, job.options.anatomy, job.options.offset_mm), grid,
                                           refinement_for(body, grid), carry_on);
  const Mesh surface = zero_surface(distances);
  write_to(output, [&](const auto &file) { write_mesh(surface, OutputKind::vtp, file, provenance, Frame::lps); });
}

void run(const Arguments &arguments)
{
  if (!arguments.scan.empty())
    return run_on_scan(arguments);
  const Job job = make_job(arguments);
  const auto threads = not_negative(arguments.threads, "--threads");
  Outputs outputs = begin_outputs(arguments);
  const Provenance provenance{"volsurf-phantom " VOLSURF_VERSION, "none", options_as_used(arguments, job)};
  const ThreadLimit limit(static_cast<int>(threads));
  Phantom phantom =
      job.body ? make_body_phantom(*job.body, job.options, carry_on) : make_head_phantom(job.options, carry_on);
  if (outputs.truth)
    write_to(*outputs.truth, [&](const auto &file) { write_labels(phantom.truth, file, provenance); });
  phantom.truth.labels = {}; // a large volume's memory is better spent on writing it
  if (outputs.truth_surface)
    write_truth_surface(job, phantom.volume.grid, *outputs.truth_surface, provenance);
  add_noise(phantom.volume, job.noise);
  fit_to_type(phantom.volume, job.type);
  write_to(outputs.scan, [&](const auto &file) { write_volume(phantom.volume, job.type, file, provenance); });
  if (outputs.truth)
    outputs.truth->commit();
  if (outputs.truth_surface)
    outputs.truth_surface->commit();
  outputs.scan.commit();
}

} // namespace

int main(int argc, char **argv)
{
  CLI::App app("Makes phantoms: scans of known anatomy or shape, with noise by choice, and their truth.",
               "volsurf-phantom");
  Arguments arguments;
  add_options(app, arguments);
  catch_interrupts();
  try {
    app.parse(argc, argv);
    run(arguments);
    return kDone;
  } catch (const CLI::ParseError &error) {
    return app.exit(error) == 0 ? kDone : kUsage;
  } catch (const std::bad_alloc &) {
    return fail(kProgram, kUnexpected, "not enough memory for a volume of this size");
  } catch (...) {
    return fail_of_exception(kProgram);
  }
}
