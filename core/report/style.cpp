#include "core/report/style.hpp"

namespace analogon {

const char* reportStyle() {
    return R"css(
:root {
  color-scheme: light dark;
  --page: #f5f6f8; --card: #ffffff; --edge: #e1e4e9; --text: #1b2027; --soft: #5b6572; --faint: #8a93a0;
  --measured: #98a1ad; --before: #d9730d; --after: #1763c6; --grid: #eceef2;
  --good: #17734a; --good-back: #e0f3e9; --warn: #8a5a00; --warn-back: #fdf0d5; --bad: #a4262c; --bad-back: #fbe4e4;
  --note: #1763c6; --note-back: #e3edfb;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #14171b; --card: #1c2026; --edge: #30363f; --text: #e6e9ee; --soft: #a5aeba; --faint: #7a8492;
    --measured: #737d8a; --before: #f0953c; --after: #62a5ff; --grid: #292e36;
    --good: #6fd3a2; --good-back: #163427; --warn: #efc05c; --warn-back: #3a2e12; --bad: #ff9a9a; --bad-back: #431f22;
    --note: #86b8ff; --note-back: #182c47;
  }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--text); line-height: 1.5;
  font: 15px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; }
main { max-width: 1040px; margin: 0 auto; padding: 36px 24px 64px; }
h1 { font-size: 27px; line-height: 1.2; margin: 0; letter-spacing: -0.01em; overflow-wrap: anywhere; }
h2 { font-size: 18px; margin: 44px 0 12px; }
h3 { font-size: 15px; margin: 0 0 6px; }
p { margin: 0 0 10px; }
code { font: 0.92em ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; overflow-wrap: break-word; }
sup { line-height: 0; }
small, .soft { color: var(--soft); }
.kicker { color: var(--faint); font-size: 12px; letter-spacing: 0.08em; text-transform: uppercase; margin: 0 0 6px; }
.heading { display: flex; gap: 14px; align-items: center; flex-wrap: wrap; margin-bottom: 14px; }
.summary { font-size: 17px; max-width: 46em; margin: 0 0 22px; }
.chip { display: inline-block; padding: 2px 10px; border-radius: 999px; font-size: 13px; font-weight: 600;
  white-space: nowrap; background: var(--note-back); color: var(--note); }
.chip.good { background: var(--good-back); color: var(--good); }
.chip.warn { background: var(--warn-back); color: var(--warn); }
.chip.bad { background: var(--bad-back); color: var(--bad); }
.chip.plain { background: var(--grid); color: var(--soft); }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(250px, 1fr)); gap: 14px; }
.figure { background: var(--card); border: 1px solid var(--edge); border-radius: 10px; padding: 14px 18px; }
.figure .name { color: var(--soft); font-size: 13px; }
.figure .value { font-size: 23px; font-weight: 600; font-variant-numeric: tabular-nums; white-space: nowrap; }
.figure .value .old { color: var(--faint); font-weight: 400; }
.card { background: var(--card); border: 1px solid var(--edge); border-radius: 10px; padding: 18px 20px;
  margin: 0 0 14px; }
.table { overflow-x: auto; padding: 4px 0; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; font-size: 14px; }
th { text-align: left; font-weight: 600; color: var(--soft); font-size: 12.5px; white-space: nowrap;
  vertical-align: bottom; }
th, td { padding: 7px 12px; border-bottom: 1px solid var(--edge); }
td { vertical-align: top; }
th:first-child, td:first-child { padding-left: 20px; }
th:last-child, td:last-child { padding-right: 20px; }
tr:last-child > td { border-bottom: 0; }
.n { text-align: right; white-space: nowrap; }
tr.total td { font-weight: 600; }
tr.group td { border-top: 2px solid var(--edge); }
td.name { white-space: nowrap; }
td .chip { margin-right: 4px; }
.better { color: var(--good); }
.worse { color: var(--bad); }
.legend { display: flex; gap: 20px; flex-wrap: wrap; color: var(--soft); font-size: 13px; margin: 0 0 10px; }
.legend i { display: inline-block; width: 22px; height: 0; border-top: 3px solid; margin-right: 7px;
  vertical-align: middle; border-radius: 2px; }
.i-measured { border-color: var(--measured) !important; }
.i-before { border-color: var(--before) !important; }
.i-after { border-color: var(--after) !important; }
.plothead { display: flex; justify-content: space-between; gap: 12px; flex-wrap: wrap; align-items: baseline; }
.plot { display: block; width: 100%; height: auto; font: 12px system-ui, "DejaVu Sans", sans-serif; }
.plot .grid { stroke: var(--grid); stroke-width: 1; }
.plot .frame { fill: none; stroke: var(--edge); }
.plot .zero { stroke: var(--faint); stroke-width: 1; }
.plot .tick { fill: var(--soft); }
.plot .axis { fill: var(--soft); font-weight: 600; }
.plot .trace { fill: none; stroke-linejoin: round; stroke-width: 1.4; }
.plot .measured { stroke: var(--measured); stroke-width: 2; }
.plot .before { stroke: var(--before); }
.plot .after { stroke: var(--after); }
.plot .residual .trace { stroke-width: 1; }
.profiles { display: flex; flex-wrap: wrap; gap: 20px; }
.plot .band { stroke: none; fill: var(--after); fill-opacity: 0.14; }
.plot .band.noise { fill-opacity: 0.09; }
.plot .limit { stroke: var(--after); stroke-width: 1; stroke-dasharray: 3 3; }
.plot .estimate { fill: var(--after); }
.legend i.i-band { height: 11px; border-top: 0; background: var(--after); opacity: 0.3; border-radius: 0; }
.legend i.i-band.noise { opacity: 0.12; }
.profiles > div { width: 300px; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 4px 20px; margin: 10px 0 0; }
dt { color: var(--soft); }
dd { margin: 0; font-variant-numeric: tabular-nums; }
ul { margin: 0; padding-left: 20px; }
li { margin: 3px 0; }
details > summary { cursor: pointer; color: var(--soft); padding: 12px 20px; }
footer { color: var(--faint); font-size: 13px; margin-top: 44px; border-top: 1px solid var(--edge); padding-top: 14px; }
@media print {
  :root { --page: #fff; --card: #fff; --edge: #ccc; --text: #000; --soft: #444; --faint: #666; --grid: #e6e6e6;
    --measured: #999; --before: #c25f00; --after: #0b57c0; }
  body { font-size: 10.5pt; }
  main { max-width: none; padding: 0; }
  .card, .figure, tr, .plot { break-inside: avoid; }
  h2, h3 { break-after: avoid; }
}
)css";
}

}  // namespace analogon
