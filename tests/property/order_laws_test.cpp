// What is proved about the region merge whatever the order of tied faces: docs/method.md, T1, T2 and T7.
#include "support/fields.h"
#include "support/gudhi_persistence.h"
#include "support/merge_of_field.h"
#include "support/sample_tree.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

using namespace volsurf;
using namespace volsurf::support;

namespace {

Exterior either_exterior()
{
  return *rc::gen::element(Exterior::none, Exterior::infinite);
}

/// The component of each cell in the dual graph's superlevel set, by the edges of the tree; a cell below has itself.
std::vector<std::size_t> dual_components(const Field &field, float level)
{
  std::vector<std::size_t> component(node_count(field, Exterior::none));
  std::iota(component.begin(), component.end(), std::size_t{0});
  for (const OrderedFace &face : naive_order(field, Exterior::none)) {
    if (face.value < level)
      continue;
    const std::size_t from = component[face.b];
    const std::size_t to = component[face.a];
    std::replace(component.begin(), component.end(), from, to);
  }
  return component;
}

/// Requires that samples above the level are in one component exactly if the cells around them are.
void require_same_connectivity(const Field &field, float level)
{
  const auto of_sample = superlevel_components(field, level);
  const auto of_cell = dual_components(field, level);
  std::map<SampleId, std::size_t> cell_component;
  std::map<std::size_t, SampleId> sample_component;
  for_each_sample({field.size[0] - 1, field.size[1] - 1, field.size[2] - 1}, [&](const Index3 &p, CellId cell) {
    for_each_sample({2, 2, 2}, [&](const Index3 &corner, SampleId) {
      const SampleId component = of_sample[sample_at(field, {p[0] + corner[0], p[1] + corner[1], p[2] + corner[2]})];
      if (component < 0)
        return;
      RC_ASSERT(cell_component.emplace(component, of_cell[cell]).first->second == of_cell[cell]);
      RC_ASSERT(sample_component.emplace(of_cell[cell], component).first->second == component);
    });
  });
}

/// The field with its axes in another order.
Field transposed(const Field &field, const std::array<std::size_t, 3> &axes)
{
  Field result{{field.size[axes[0]], field.size[axes[1]], field.size[axes[2]]}, {}};
  for_each_sample(result.size, [&](const Index3 &p, SampleId) {
    Index3 q{};
    for (std::size_t i = 0; i < 3; ++i)
      q[axes[i]] = p[i];
    result.values.push_back(field.values[sample_at(field, q)]);
  });
  return result;
}

Field mirrored(const Field &field, int axis)
{
  Field result{field.size, {}};
  for_each_sample(field.size, [&](Index3 p, SampleId) {
    p[axis] = field.size[axis] - 1 - p[axis];
    result.values.push_back(field.values[sample_at(field, p)]);
  });
  return result;
}

} // namespace

RC_GTEST_PROP(OrderLaws, T1FirstFaceOfACellIsATreeEdgeOfPersistenceZero, ())
{
  const Field field = *random_field(5);
  const Exterior exterior = either_exterior();
  const auto max_vertex = naive_max_vertices(field);
  std::map<std::int64_t, float> persistence;
  for (const TreeEdge &edge : naive_tree(field, exterior))
    persistence[edge.face] = edge.persistence;
  std::set<std::size_t> seen;
  for (const OrderedFace &face : naive_order(field, exterior))
    for (const std::size_t cell : {face.a, face.b}) {
      if (cell == max_vertex.size() || !seen.insert(cell).second)
        continue;
      // Where border faces join nothing, the face that attains the maximum may be one of those.
      const float value = field.values[max_vertex[cell]];
      RC_ASSERT(face.value == value || (exterior == Exterior::none && face.value < value));
      if (face.value == value) {
        RC_ASSERT(persistence.count(face.face) == 1U);
        RC_ASSERT(persistence[face.face] == 0.0F);
      }
    }
}

RC_GTEST_PROP(OrderLaws, T2SuperlevelSetsOfTheDualGraphAreThoseOfTheSamples, ())
{
  const Field field = *random_field(4);
  for (const float level : std::set<float>(field.values.begin(), field.values.end()))
    require_same_connectivity(field, level);
}

RC_GTEST_PROP(OrderLaws, T2PositivePersistencesAreThoseOfTheSamplesJoinTree, ())
{
  const Field field = *random_field(7);
  const Exterior exterior = either_exterior();
  RC_ASSERT(positive_persistences(merge_of(field, exterior).hierarchy) == sample_persistences(field, exterior));
}

RC_GTEST_PROP(OrderLaws, GudhiFindsTheSamePositivePersistences, ())
{
  const Field field = *random_field();
  RC_ASSERT(positive_persistences(merge_of(field, Exterior::none).hierarchy) == gudhi_persistences(field));
}

RC_GTEST_PROP(OrderLaws, T7PersistencesDoNotDependOnHowTiesAreBroken, ())
{
  const Field field = *random_field(7);
  const Exterior exterior = either_exterior();
  const auto persistences = positive_persistences(merge_of(field, exterior).hierarchy);
  for (int axis = 0; axis < 3; ++axis)
    RC_ASSERT(positive_persistences(merge_of(mirrored(field, axis), exterior).hierarchy) == persistences);
  for (const std::array<std::size_t, 3> &axes :
       {std::array<std::size_t, 3>{1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}})
    RC_ASSERT(positive_persistences(merge_of(transposed(field, axes), exterior).hierarchy) == persistences);
}
