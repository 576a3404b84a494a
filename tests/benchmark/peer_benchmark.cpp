// peer_benchmark: times what a user would use instead of volsurf, in memory; prints JSON.
#include "benchmark/peers.h"
#include "benchmark/volsurf_run.h"

#include <map>
#include <string>

namespace {

using namespace volsurf;
using namespace volsurf::bench;

struct Peer {
  Compute compute;
  bool has_volsurfs_regions; ///< it must find the same number of regions, and the same regions if it lists them
};

const std::map<std::string, Peer> &peers()
{
  static const std::map<std::string, Peer> all{
      {"vtk_surface",
       {[](const auto &volume, const auto &run) {
          return run_vtk_surface(volume, run, {true, false});
        },
        false}},
      {"vtk_surface_bare",
       {[](const auto &volume, const auto &run) {
          return run_vtk_surface(volume, run, {false, false});
        },
        false}},
      {"vtk_largest_surface",
       {[](const auto &volume, const auto &run) {
          return run_vtk_surface(volume, run, {true, true});
        },
        false}},
      {"itk_morphological_watershed",
       {[](const auto &volume, const auto &run) { return run_itk_morphological_watershed(volume, run, false); },
        false}},
      {"itk_morphological_watershed_26",
       {[](const auto &volume, const auto &run) { return run_itk_morphological_watershed(volume, run, true); }, false}},
      {"itk_watershed", {run_itk_watershed, false}},
      {"plain_kruskal", {run_plain_kruskal, true}},
      {"gudhi", {run_gudhi, true}},
  };
  return all;
}

} // namespace

int main(int argc, char **argv)
{
  CLI::App app("Times what a user would use instead of volsurf, without reading and writing.", "peer_benchmark");
  std::string name;
  RunOptions options;
  app.add_option("NAME", name, "What to time")->required()->check(CLI::IsMember(peers()));
  add_run_options(app, options);
  return run_program(app, argc, argv, [&] {
    const Peer &peer = peers().at(name);
    measure_and_print(options, peer.compute, peer.has_volsurfs_regions ? Check(require_volsurfs_regions) : Check());
  });
}
