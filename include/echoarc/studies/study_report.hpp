// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "echoarc/studies/spread.hpp"
#include "echoarc/studies/svg_chart.hpp"

/// What a study found, as plain data: no markup, no files. Hosts turn it into a page or JSON.
namespace echoarc::studies {

/// One number of a paper beside ours.
struct StudyRow {
  std::string quantity;   ///< "MAE"
  std::string condition;  ///< what it was measured on: "VT, threshold 4"
  std::string unit;       ///< "cm"; empty for counts and shares in 0..1
  double paper = std::numeric_limits<double>::quiet_NaN();
  std::string paper_text;  ///< where the paper has words or a range ("> 20 %"); stands instead of the number
  Spread ours;
  int decimals = 3;    ///< with which both are shown
  std::string remark;  ///< plain words, may be empty
};

/// How a table reads best.
enum class TableLayout : std::uint8_t {
  rows,    ///< a line per number
  matrix,  ///< a line per condition, a pair of columns (paper, ours) per quantity
};

struct StudyTable {
  std::string id;     ///< of the list of published numbers, "S2-T1"; may be empty
  std::string title;  ///< "Curved surface (Table 1)"
  std::string note;   ///< one or two sentences below, may be empty
  TableLayout layout = TableLayout::rows;
  std::vector<StudyRow> rows;
};

enum class Verdict : std::uint8_t {
  holds,      ///< on the mean over the seeds
  fails,      ///< does not hold
  undecided,  ///< cannot be told: too few seeds, or values that are no numbers
};

/// A sentence of a paper that our runs agree with or not.
struct Claim {
  std::string id;      ///< "S2-mae-curve-1"; unique within a study
  std::string text;    ///< "MAE of ATM-mod < MAE of DM, curved surface"
  std::string source;  ///< "Section 3.8"
  Verdict verdict = Verdict::undecided;
  std::uint64_t seeds = 0;     ///< runs that could tell
  std::uint64_t holds_on = 0;  ///< of those
  std::string evidence;        ///< figures: "1.69 cm against 1.96 cm"
};

/// 8-bit RGB, row by row from the top.
struct Image {
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::vector<std::uint8_t> rgb;
};

struct ChartFigure {
  std::string id;
  std::string caption;
  Chart chart;
};

struct PictureFigure {
  std::string id;
  std::string caption;
  Image image;
};

/// A part of a report; shown in this order, whatever is empty is left out.
struct StudySection {
  std::string id;  ///< short and unique within the study: an anchor
  std::string title;
  std::vector<std::string> paragraphs;
  std::vector<Claim> claims;
  std::vector<StudyTable> tables;
  std::vector<ChartFigure> charts;
  std::vector<PictureFigure> pictures;
  std::vector<std::string> remarks;  ///< paragraphs below tables and figures
};

/// One paper.
struct StudyReport {
  std::string name;    ///< as the command spells it: "barshan2007"
  std::string title;   ///< of the paper
  std::string source;  ///< authors, journal, year
  int seeds = 0;
  std::vector<std::string> summary;  ///< opening paragraphs, plain words
  std::vector<StudySection> sections;
};

}  // namespace echoarc::studies
