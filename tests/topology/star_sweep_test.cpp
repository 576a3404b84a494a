#include "volsurf/topology/star_sweep.h"

#include "support/fields.h"
#include "support/merge_of_field.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace volsurf;
using namespace volsurf::support;

namespace {

/// Two nodes that a face joins, lower first. A cell may meet the exterior over several faces, which are all the same.
using Link = std::pair<std::size_t, std::size_t>;

Link link(std::size_t a, std::size_t b)
{
  return {std::min(a, b), std::max(a, b)};
}

Link link_of_step(const CellGrid &cells, CellId cell, Step step)
{
  const CellId to = step == kToExterior ? cells.count() : cell + cells.offset(step);
  return link(static_cast<std::size_t>(cell), static_cast<std::size_t>(to));
}

struct SweepLinks {
  std::set<Link> steps;
  std::set<Link> saddles;
};

SweepLinks links_of(const Field &field, const StarSweep &sweep)
{
  const CellGrid cells({field.size[0] - 1, field.size[1] - 1, field.size[2] - 1});
  SweepLinks links;
  for (CellId cell = 0; cell < cells.count(); ++cell)
    if (sweep.codes[cell] != step_code(kNoStep))
      links.steps.insert(link_of_step(cells, cell, step_of(sweep.codes[cell])));
  for (const StripStars &strip : sweep.strips)
    for (std::size_t z = 0; z < strip.saddles.size(); ++z) {
      const StripFaces faces(cells, strip.rows, static_cast<std::int64_t>(z));
      for (const Saddle &saddle : strip.saddles[z])
        links.saddles.insert(link_of_step(cells, faces.cell(saddle.face), StripFaces::step(saddle.face)));
    }
  return links;
}

StarSweep sweep_of(const Field &field, Exterior exterior)
{
  return sweep_stars(field.size, planes_of(field), exterior, {2, 2}, {});
}

Exterior either_exterior()
{
  return *rc::gen::element(Exterior::none, Exterior::infinite);
}

} // namespace

// Far more telling than the partition, which shows a wrong face only where a part of a star has several basins.
RC_GTEST_PROP(StarSweep, StepsAndSaddleFacesHoldTheEdgesOfTheTree, ())
{
  const Field field = *random_field();
  const Exterior exterior = either_exterior();
  const SweepLinks links = links_of(field, sweep_of(field, exterior));
  std::set<Link> weak;
  for (const TreeEdge &edge : naive_tree(field, exterior)) {
    RC_ASSERT(links.steps.count(link(edge.a, edge.b)) + links.saddles.count(link(edge.a, edge.b)) >= 1U);
    if (edge.persistence == 0)
      weak.insert(link(edge.a, edge.b));
  }
  RC_ASSERT(std::includes(weak.begin(), weak.end(), links.steps.begin(), links.steps.end()));
}

RC_GTEST_PROP(StarSweep, RootsAreTheCellsWithoutAStepInAscendingOrder, ())
{
  const Field field = *random_field();
  const StarSweep sweep = sweep_of(field, either_exterior());
  std::vector<CellId> without_step;
  for (CellId cell = 0; cell < sweep.codes.size(); ++cell)
    if (sweep.codes[cell] == step_code(kNoStep))
      without_step.push_back(cell);
  std::vector<CellId> roots;
  const auto max_vertex = naive_max_vertices(field);
  for (std::size_t plane = 0; plane + 1 < static_cast<std::size_t>(field.size[2]); ++plane)
    for (const StripStars &strip : sweep.strips)
      for (const Root &root : strip.roots[plane]) {
        roots.push_back(root.cell);
        RC_ASSERT(root.value == field.values[max_vertex[root.cell]]);
      }
  RC_ASSERT(roots == without_step);
}
