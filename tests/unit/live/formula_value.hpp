// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>
#include <cstdlib>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/mapping/method.hpp"

namespace echoarc::live::test {

/// Works out a formula's tree by its JSON text; of an equation its right side. NaN: it is not a tree of these rules.
class FormulaReader {
 public:
  FormulaReader(std::string_view text, std::span<const Term> terms) : text_(text), terms_(terms) {}

  double value() {
    if (!take('[')) return nan;
    const std::string operation = word();
    if (operation == "num") {
      (void)take(',');
      return number();
    }
    if (operation == "sym" || operation == "val") {
      (void)take(',');
      const std::string name = word();
      (void)take(']');
      if (operation == "sym") return nan;
      for (const Term& term : terms_)
        if (term.name == name) return term.value;
      return nan;
    }
    std::vector<double> parts;
    while (take(',')) parts.push_back(value());
    (void)take(']');
    return applied(operation, parts);
  }

 private:
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

  static double applied(const std::string& operation, const std::vector<double>& parts) {
    double result = parts.at(0);
    if (operation == "eq") return parts.at(1);
    if (operation == "neg") return -result;
    if (operation == "exp") return std::exp(result);
    if (operation == "ln") return std::log(result);
    if (operation == "frac") return result / parts.at(1);
    if (operation == "pow") return std::pow(result, parts.at(1));
    if (operation == "sub") return result - parts.at(1);
    for (std::size_t k = 1; k < parts.size(); ++k) {
      if (operation == "add") result += parts[k];
      if (operation == "mul") result *= parts[k];
    }
    return operation == "add" || operation == "mul" ? result : nan;
  }
  bool take(char c) {
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  std::string word() {
    if (!take('"')) return "";
    const std::size_t end = text_.find('"', at_);
    const std::string found(text_.substr(at_, end - at_));
    at_ = end + 1;
    return found;
  }
  double number() {
    const std::size_t end = text_.find(']', at_);
    const double found = std::strtod(std::string(text_.substr(at_, end - at_)).c_str(), nullptr);
    at_ = end + 1;
    return found;
  }

  std::string_view text_;
  std::span<const Term> terms_;
  std::size_t at_ = 0;
};

inline double formula_value(std::string_view tree, std::span<const Term> terms) {
  return FormulaReader(tree, terms).value();
}

}  // namespace echoarc::live::test
