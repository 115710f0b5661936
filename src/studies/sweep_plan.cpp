// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "studies/sweep_plan.hpp"

#include <algorithm>
#include <utility>

#include "echoarc/mapping/catalog.hpp"

namespace echoarc::studies {
namespace {

Error bad_sweep(std::string message, std::string where, std::string remedy) {
  return {ErrorCode::bad_value, std::move(message), std::move(where), std::move(remedy)};
}

/// Whether the sweep has anything that the group's options belong to.
bool is_reached(const SweepRequest& request, std::string_view group) {
  if (is_scene_group(group)) return std::holds_alternative<StudyScene>(request.subject);
  return group == "method" || group == "sensing" || std::ranges::find(request.methods, group) != request.methods.end();
}

Result<void> check_axis(const SweepRequest& request, std::size_t index) {
  const SweepAxis& axis = request.axes[index];
  const auto before = std::span(request.axes).first(index);
  if (!is_reached(request, axis.group))
    return bad_sweep(axis.key() + " belongs to nothing in this sweep", "--option",
                     "give an option of its methods, of sensing, or of its scene");
  if (axis.values.empty()) return bad_sweep(axis.key() + " has no value", "--option", "give at least one");
  if (std::ranges::find(before, axis.key(), &SweepAxis::key) != before.end())
    return bad_sweep(axis.key() + " is given twice", "--option", "give all its values at once, as v1,v2");
  const bool of_one_method = axis.group != "method" && find_method(axis.group) != nullptr;
  if (of_one_method && axis.values.size() > 1 && request.methods.size() > 1)
    return bad_sweep(axis.key() + " varies an option of one method among several", "--option",
                     "sweep " + axis.group + " alone, or write " + axis.option + " if all methods have it");
  return {};
}

}  // namespace

SweepStage stage_of(const SweepAxis& axis) {
  if (is_scene_group(axis.group)) return SweepStage::drive;
  return axis.group == "sensing" ? SweepStage::sensing : SweepStage::mapping;
}

Combinations::Combinations(std::span<const SweepAxis> axes, SweepStage stage) {
  for (std::size_t k = 0; k < axes.size(); ++k) {
    if (stage_of(axes[k]) != stage) continue;
    axes_.push_back(k);
    sizes_.push_back(axes[k].values.size());
    count_ *= axes[k].values.size();
  }
}

void Combinations::write(std::size_t index, std::span<std::size_t> places) const {
  for (std::size_t k = axes_.size(); k-- > 0;) {
    places[axes_[k]] = index % sizes_[k];
    index /= sizes_[k];
  }
}

std::size_t combination_index(std::span<const SweepAxis> axes, std::span<const std::size_t> places) {
  std::size_t index = 0;
  for (std::size_t k = 0; k < axes.size(); ++k) index = index * axes[k].values.size() + places[k];
  return index;
}

Result<StudyScene> scene_of(const StudyScene& scene, std::span<const SweepAxis> axes,
                            std::span<const std::size_t> places) {
  StudyScene changed = scene;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    if (stage_of(axes[k]) != SweepStage::drive) continue;
    if (const Result<void> set = set_scene_option(changed, axes[k], axes[k].values[places[k]]); !set)
      return set.error();
  }
  return changed;
}

Result<SensingOptions> sensing_of(std::span<const SweepAxis> axes, std::span<const std::size_t> places) {
  OptionMap values;
  for (std::size_t k = 0; k < axes.size(); ++k)
    if (stage_of(axes[k]) == SweepStage::sensing) values[axes[k].option] = axes[k].values[places[k]];
  return make_options<SensingOptions>(values);
}

MethodSpec method_of(const std::string& method, std::span<const SweepAxis> axes, std::span<const std::size_t> places) {
  MethodSpec spec{.label = method, .method = method, .options = {}};
  for (std::size_t k = 0; k < axes.size(); ++k)
    if (axes[k].group == "method" || axes[k].group == method) spec.options[axes[k].option] = axes[k].values[places[k]];
  return spec;
}

Result<void> check(const SweepRequest& request, std::size_t seeds) {
  if (request.methods.empty()) return bad_sweep("the sweep has no method", "--method", "give one, as --method vt");
  double maps = double(seeds) * double(request.methods.size());
  for (auto name = request.methods.begin(); name != request.methods.end(); ++name) {
    if (const Result<AnyMethod> made = echoarc::make_method(*name); !made)
      return bad_sweep(made.error().message, "--method", made.error().remedy);
    if (std::find(request.methods.begin(), name, *name) != name)
      return bad_sweep("method " + *name + " is given twice", "--method", "give it once");
  }
  for (std::size_t k = 0; k < request.axes.size(); ++k) {
    if (Result<void> checked = check_axis(request, k); !checked) return checked;
    maps *= double(request.axes[k].values.size());
  }
  if (maps <= double(max_sweep_maps)) return {};
  return Error{ErrorCode::too_large, "the sweep has more than " + std::to_string(max_sweep_maps) + " maps", "--option",
               "take fewer values, methods or seeds"};
}

}  // namespace echoarc::studies
