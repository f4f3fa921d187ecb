#include "style.hpp"

namespace scree::report {

const char* const style = R"css(
:root {
  color-scheme: light dark;
  --paper: #fff; --ink: #1c2024; --quiet: #5b6570; --rule: #dfe3e8; --tint: #f5f7f9;
  --accent: #0072b2; --good: #00735a; --bad: #b23c00; --open: #8a6100;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #16191d; --ink: #e4e7ea; --quiet: #9aa4ae; --rule: #343b43; --tint: #1f242a;
    --accent: #6cb8ea; --good: #4cc9a4; --bad: #ff9a62; --open: #e6bd55;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0 auto; padding: 2.5rem 1.25rem 4rem; max-width: 74rem; background: var(--paper); color: var(--ink);
  font: 1rem/1.55 system-ui, -apple-system, "Segoe UI", "Noto Sans", "DejaVu Sans", "Liberation Sans", sans-serif;
  overflow-wrap: break-word;
}
header { border-bottom: 2px solid var(--ink); margin-bottom: 1.5rem; }
header p { margin: 0 0 .9rem; color: var(--quiet); }
header p:first-child { margin: 0; font-size: .85rem; letter-spacing: .06em; text-transform: uppercase; }
h1 { margin: .15rem 0 .3rem; font-size: 1.9rem; line-height: 1.2; font-weight: 650; text-wrap: balance; }
h2 { margin: 2.6rem 0 .8rem; font-size: 1.2rem; line-height: 1.3; font-weight: 650; }
h3 { margin: 1.4rem 0 .4rem; font-size: 1rem; line-height: 1.3; font-weight: 600; }
p { margin: .6rem 0; max-width: 46rem; }
a { color: var(--accent); }
code, pre { font: .87em/1.5 ui-monospace, "DejaVu Sans Mono", "Liberation Mono", Consolas, monospace; }
pre { overflow-x: auto; padding: .9rem 1rem; background: var(--tint); border-radius: 4px; }
.good { color: var(--good); } .bad { color: var(--bad); } .open { color: var(--open); }
.verdict { margin: .35rem 0; padding: .15rem 0 .15rem .8rem; border-left: 4px solid currentColor; font-weight: 600; }
.lead { font-size: 1.08rem; }
.note { color: var(--quiet); }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 30rem), 1fr)); gap: 1.5rem; margin: 1rem 0; }
figure { margin: 0; break-inside: avoid; }
figure svg, figure img {
  display: block; width: 100%; height: auto; background: #fff; border: 1px solid var(--rule); border-radius: 4px;
}
figcaption { margin-top: .4rem; color: var(--quiet); font-size: .88rem; line-height: 1.4; }
.figures > figure:only-child { max-width: 50rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .92rem; line-height: 1.4; font-variant-numeric: tabular-nums; }
th, td { padding: .38rem 1.1rem .38rem 0; text-align: left; vertical-align: top; border-bottom: 1px solid var(--rule); }
th { color: var(--quiet); font-weight: 600; vertical-align: bottom; }
th.number, td.number { text-align: right; }
td.number { white-space: nowrap; }
dl { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 30rem), 1fr)); gap: 0 2.5rem; margin: 0; }
dl > div { display: flex; gap: 1rem; padding: .38rem 0; border-bottom: 1px solid var(--rule); font-size: .95rem; }
dt { flex: 0 0 11rem; color: var(--quiet); }
dd { flex: 1; margin: 0; min-width: 0; font-variant-numeric: tabular-nums; }
ul { margin: .4rem 0; padding-left: 1.2rem; }
ul.plain { margin: 0; padding: 0; list-style: none; }
details { margin: 1rem 0; }
summary { cursor: pointer; color: var(--accent); }
footer { margin-top: 3.5rem; padding-top: .8rem; border-top: 1px solid var(--rule); color: var(--quiet); font-size: .85rem; }
@media (max-width: 34rem) {
  body { padding: 1.25rem .9rem 3rem; }
  h1 { font-size: 1.5rem; }
  dl > div { display: block; }
}
@page { margin: 15mm; }
@media print {
  :root {
    color-scheme: light; font-size: 9pt;
    --paper: #fff; --ink: #000; --quiet: #444; --rule: #bbb; --tint: #fff;
    --accent: #000; --good: #00573f; --bad: #8f3000; --open: #6b4b00;
  }
  body { max-width: none; padding: 0; }
  h2, h3 { break-after: avoid; }
  .figures { grid-template-columns: 1fr 1fr; }
  .figures > figure:only-child { max-width: none; grid-column: 1 / 3; width: 75%; }
  dl { grid-template-columns: 1fr 1fr; }
  tr, dl > div { break-inside: avoid; }
  .wide { overflow: visible; }
  table { font-size: .85rem; }
  pre { white-space: pre-wrap; border: 1px solid var(--rule); }
}
)css";

}  // namespace scree::report
