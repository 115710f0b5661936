// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/style.hpp"

namespace echoarc::report {

std::string_view style_sheet() {
  return R"(
:root { --ink: #1d232a; --soft: #5b6672; --line: #d9dee3; --page: #fcfcfa; --card: #ffffff; --head: #f1f3f1;
  --accent: #0b5f8a; --yes: #1f7a4d; --yes-bg: #e1f3e9; --no: #a8321f; --no-bg: #fbe6e1; --open: #7a6210;
  --open-bg: #f8efce; }
@media (prefers-color-scheme: dark) { :root { --ink: #e3e6e8; --soft: #98a3ad; --line: #343c44; --page: #14181c;
  --card: #1b2025; --head: #232a30; --accent: #79c0e8; --yes: #7fd6a8; --yes-bg: #17392a; --no: #f2a08f;
  --no-bg: #43211b; --open: #e6cf7a; --open-bg: #3a3214; } }
* { box-sizing: border-box; }
html { scroll-behavior: smooth; -webkit-text-size-adjust: 100%; }
body { margin: 0; background: var(--page); color: var(--ink);
  font: 16px/1.55 system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif; }
main, header, nav { max-width: 68rem; margin: 0 auto; padding: 0 1.25rem; }
header { padding-top: 2.5rem; }
h1 { font-size: 2rem; line-height: 1.2; margin: 0 0 .4rem; letter-spacing: -.01em; }
h2 { font-size: 1.5rem; line-height: 1.25; margin: 3.5rem 0 .3rem; padding-top: 1.2rem; border-top: 2px solid var(--ink); }
h3 { font-size: 1.18rem; margin: 2.4rem 0 .4rem; color: var(--accent); }
h4 { font-size: 1rem; margin: 1.6rem 0 .4rem; }
p { max-width: 46rem; margin: .6rem 0; }
p.lead { color: var(--soft); }
p.note, figcaption, .unit, .sd { color: var(--soft); font-size: .86rem; }
.unit, .sd { font-weight: 400; white-space: nowrap; }
code { font: .88em/1.4 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; background: var(--head);
  padding: .1em .35em; border-radius: 4px; }
a { color: var(--accent); }
nav ul { list-style: none; margin: .4rem 0 1rem; padding: 0; columns: 2; column-gap: 2rem; }
nav li { break-inside: avoid; margin: .15rem 0; }
nav li.paper { font-weight: 600; margin-top: .5rem; }
nav li.part { padding-left: 1rem; font-size: .94rem; }
nav a { text-decoration: none; }
nav a:hover { text-decoration: underline; }
.scroll { overflow-x: auto; margin: .5rem 0 1rem; border: 1px solid var(--line); border-radius: 8px;
  background: var(--card); }
table { border-collapse: collapse; width: 100%; font-size: .92rem; font-variant-numeric: tabular-nums; }
th, td { padding: .38rem .7rem; text-align: left; vertical-align: baseline; border-bottom: 1px solid var(--line); }
tbody tr:last-child td { border-bottom: 0; }
thead th { background: var(--head); font-weight: 600; white-space: nowrap; }
.n { text-align: right; white-space: nowrap; }
.c { text-align: center; }
.p { color: var(--soft); border-left: 1px solid var(--line); }
.matrix td:first-child { white-space: nowrap; }
.claims td:first-child { min-width: 15rem; }
.claims td:last-child { min-width: 13rem; color: var(--soft); }
.chip { display: inline-block; padding: .05rem .6rem; border-radius: 999px; font-size: .84rem; font-weight: 600;
  white-space: nowrap; }
.yes { color: var(--yes); background: var(--yes-bg); }
.no { color: var(--no); background: var(--no-bg); }
.open { color: var(--open); background: var(--open-bg); }
.figures { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 28rem), 1fr)); gap: 1rem; }
.maps { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(46%, 13.5rem), 1fr)); gap: .8rem; }
figure { margin: 0; border: 1px solid var(--line); border-radius: 8px; background: var(--card); overflow: hidden; }
figure svg { display: block; width: 100%; height: auto; background: #fff; }
figure img { display: block; width: 100%; height: auto; background: #fff; }
figcaption { padding: .45rem .7rem .55rem; }
footer { max-width: 68rem; margin: 3rem auto 2rem; padding: 0 1.25rem; color: var(--soft); font-size: .86rem; }
@media (max-width: 40rem) { body { font-size: 15px; } h1 { font-size: 1.5rem; } h2 { font-size: 1.25rem; }
  nav ul { columns: 1; } th, td { padding: .32rem .5rem; } }
@media print { .scroll { overflow: visible; border: 0; } nav { display: none; } h2 { break-before: page; } }
)";
}

}  // namespace echoarc::report
