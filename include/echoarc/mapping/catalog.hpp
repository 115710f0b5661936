// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "echoarc/mapping/method.hpp"

namespace echoarc {

/// Any mapping method behind one run-time interface: what the command, the server and the bindings hold. Programs that
/// know their method at compile time use its class directly.
class AnyMethod {
 public:
  template <MappingMethod M>
  explicit AnyMethod(M method) : model_(std::make_unique<Model<M>>(std::move(method))) {}

  [[nodiscard]] std::string_view name() const { return model_->name(); }
  [[nodiscard]] OptionMap options() const { return model_->options(); }
  void insert(std::span<const Reading> readings, Executor& executor) { model_->insert(readings, executor); }
  void finish(Executor& executor) { model_->finish(executor); }
  [[nodiscard]] Result<MapExport> export_map() const { return model_->export_map(); }
  [[nodiscard]] const InsertCounters& counters() const { return model_->counters(); }
  /// Whether it wants laser-limited readings.
  [[nodiscard]] bool takes_laser_limited() const { return model_->takes_laser_limited(); }
  /// The method's own counts; empty for most.
  [[nodiscard]] std::vector<Tally> tallies() const { return model_->tallies(); }
  /// Whether it lets others look into its history of arcs; without, the next three see nothing. See `ArcKeeping`.
  [[nodiscard]] bool keeps_arcs() const { return model_->keeps_arcs(); }
  void visit_arcs(const ArcVisitor& visitor) const { model_->visit_arcs(visitor); }
  [[nodiscard]] bool history_full() const { return model_->history_full(); }
  void watch_leaving(ArcVisitor visitor) { model_->watch_leaving(std::move(visitor)); }
  [[nodiscard]] Trace trace(const Reading& reading) const { return model_->trace(reading); }
  [[nodiscard]] bool supports(const Reading& reading, Vec2 position) const {
    return model_->supports(reading, position);
  }
  [[nodiscard]] std::vector<std::byte> save() const { return model_->save(); }

 private:
  struct Interface {
    virtual ~Interface() = default;
    [[nodiscard]] virtual std::string_view name() const = 0;
    [[nodiscard]] virtual OptionMap options() const = 0;
    virtual void insert(std::span<const Reading> readings, Executor& executor) = 0;
    virtual void finish(Executor& executor) = 0;
    [[nodiscard]] virtual Result<MapExport> export_map() const = 0;
    [[nodiscard]] virtual const InsertCounters& counters() const = 0;
    [[nodiscard]] virtual bool takes_laser_limited() const = 0;
    [[nodiscard]] virtual std::vector<Tally> tallies() const = 0;
    [[nodiscard]] virtual bool keeps_arcs() const = 0;
    virtual void visit_arcs(const ArcVisitor& visitor) const = 0;
    [[nodiscard]] virtual bool history_full() const = 0;
    virtual void watch_leaving(ArcVisitor visitor) = 0;
    [[nodiscard]] virtual Trace trace(const Reading& reading) const = 0;
    [[nodiscard]] virtual bool supports(const Reading& reading, Vec2 position) const = 0;
    [[nodiscard]] virtual std::vector<std::byte> save() const = 0;
  };

  template <MappingMethod M>
  struct Model final : Interface {
    explicit Model(M m) : method(std::move(m)) {}
    [[nodiscard]] std::string_view name() const override { return M::name; }
    [[nodiscard]] OptionMap options() const override { return option_values(method.options()); }
    void insert(std::span<const Reading> readings, Executor& executor) override { method.insert(readings, executor); }
    void finish(Executor& executor) override { method.finish(executor); }
    [[nodiscard]] Result<MapExport> export_map() const override { return method.export_map(); }
    [[nodiscard]] const InsertCounters& counters() const override { return method.counters(); }
    [[nodiscard]] bool takes_laser_limited() const override { return LaserLimited<M>; }
    [[nodiscard]] std::vector<Tally> tallies() const override {
      if constexpr (Tallying<M>)
        return method.tallies();
      else
        return {};
    }
    [[nodiscard]] bool keeps_arcs() const override { return ArcKeeping<M>; }
    void visit_arcs([[maybe_unused]] const ArcVisitor& visitor) const override {
      if constexpr (ArcKeeping<M>) method.visit_arcs(visitor);
    }
    [[nodiscard]] bool history_full() const override {
      if constexpr (ArcKeeping<M>)
        return method.history_full();
      else
        return false;
    }
    void watch_leaving([[maybe_unused]] ArcVisitor visitor) override {
      if constexpr (ArcKeeping<M>) method.watch_leaving(std::move(visitor));
    }
    [[nodiscard]] Trace trace(const Reading& reading) const override { return method.trace(reading); }
    [[nodiscard]] bool supports(const Reading& reading, Vec2 position) const override {
      return method.supports(reading, position);
    }
    [[nodiscard]] std::vector<std::byte> save() const override { return method.save(); }
    M method;
  };

  std::unique_ptr<Interface> model_;
};

/// A method as the catalogue lists it.
struct MethodEntry {
  std::string_view name;     ///< fixed; used on the command line, in files and URLs
  std::string_view title;    ///< the field's name for it
  std::string_view summary;  ///< one sentence: what it does and when to use it
  std::string_view source;   ///< paper and section
  std::vector<OptionSpec> (*specs)();
  Result<AnyMethod> (*make)(const OptionMap&);
  Result<AnyMethod> (*restore)(std::span<const std::byte>);
};

/// All methods, in the order in which they are listed.
[[nodiscard]] std::span<const MethodEntry> catalog();
/// The entry of a name, or nullptr.
[[nodiscard]] const MethodEntry* find_method(std::string_view name);
/// A method ready for readings. Errors: unknown name (lists the names), unknown option, value out of range.
[[nodiscard]] Result<AnyMethod> make_method(std::string_view name, const OptionMap& options = {});

}  // namespace echoarc
