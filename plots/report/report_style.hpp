// The style sheet of the report.
#pragma once

#include <string_view>

namespace delabole {

inline constexpr std::string_view report_style = R"css(:root { color-scheme: light; }
* { box-sizing: border-box; }
body {
  margin: 0; background: #fff; color: #1b1b1b;
  font: 17px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif;
  -webkit-text-size-adjust: 100%; overflow-wrap: break-word;
}
main { max-width: 82rem; margin: 0 auto; padding: 1rem; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: .5rem 0 .2rem; }
h2 { font-size: 1.3rem; line-height: 1.25; margin: 2.2rem 0 .6rem; border-bottom: 1px solid #ccc; padding-bottom: .2rem; }
h3 { font-size: 1.08rem; margin: 1.5rem 0 .4rem; }
p { margin: .6rem 0; }
p, ul { max-width: 52rem; }
.subtitle { color: #555; margin-top: 0; }
ul { padding-left: 1.3rem; }
.head { border-top: .35rem solid #56677a; padding: .8rem 0; margin: 1rem 0; border-bottom: 1px solid #ccc; display: grid; gap: 0 1.5rem; }
.head.good { border-top-color: #009e73; }
.head.bad { border-top-color: #d55e00; }
.answer p { font-size: 1.06rem; }
.answer p:first-child { font-size: 1.4rem; line-height: 1.3; font-weight: 700; }
.head figure { margin: .4rem 0 0; }
.contents ol { list-style: none; display: flex; flex-wrap: wrap; gap: .2rem 1.3rem; margin: .8rem 0; padding: 0; }
details { border: 1px solid #ccc; border-radius: .3rem; margin: 1rem 0; padding: 0 .9rem; }
summary { font-size: 1.08rem; font-weight: 600; padding: .5rem 0; cursor: pointer; }
.notice { border-left: .35rem solid #0072b2; background: #eef5fa; padding: .5rem .9rem; margin: 1rem 0; }
.notice.warning { border-color: #d55e00; background: #fdf1e7; }
.notice-title { font-weight: 700; margin: .2rem 0; }
.table { overflow-x: auto; margin: 1rem 0; }
table { border-collapse: collapse; font-size: .92rem; }
caption { text-align: left; font-weight: 600; padding-bottom: .3rem; }
th, td { padding: .3rem .65rem; text-align: left; vertical-align: top; border-bottom: 1px solid #ddd; overflow-wrap: normal; }
thead th { border-bottom: 2px solid #888; vertical-align: bottom; }
td:last-child:not(.number) { min-width: 9rem; }
.number { text-align: right; font-variant-numeric: tabular-nums; }
td.number { white-space: nowrap; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 34rem), 1fr)); gap: 0 2rem; align-items: start; }
.figures.small { grid-template-columns: repeat(auto-fit, minmax(min(100%, 21rem), 1fr)); gap: 0 1rem; }
figure { margin: 1.2rem 0; min-width: 0; }
figure svg { display: block; width: 100%; height: auto; max-width: 46rem; }
figure svg image { image-rendering: pixelated; }
figcaption { font-size: .92rem; color: #333; margin-top: .4rem; max-width: 46rem; }
.missing { border: 2px dashed #d55e00; background: #fdf1e7; padding: 1.2rem; overflow-wrap: anywhere; }
.provenance { display: grid; grid-template-columns: minmax(6rem, auto) 1fr; gap: .2rem 1rem; font-size: .9rem; }
.provenance dt { color: #555; }
.provenance dd { margin: 0; overflow-wrap: anywhere; }
@media (min-width: 60rem) {
  .head { grid-template-columns: minmax(17rem, 2fr) 3fr; }
}
@media screen {
  /* A shadow at the side on which a wide table goes on. */
  .table {
    background: linear-gradient(to right, #fff 1.5rem, #fff0 3rem) local, linear-gradient(to left, #fff 1.5rem, #fff0 3rem) local,
      linear-gradient(to right, #0003, #0000 .8rem), linear-gradient(to left, #0003, #0000 .8rem);
  }
}
@media (max-width: 30rem) {
  body { font-size: 16px; }
  main { padding: .7rem; }
  th, td { padding: .3rem .35rem; font-size: .85rem; }
  td:first-child { min-width: 7rem; }
  .provenance { grid-template-columns: 1fr; gap: 0; }
  .provenance dd { margin-bottom: .5rem; }
}
@media print {
  @page { margin: 15mm; }
  body { font-size: 9.5pt; }
  main { max-width: none; padding: 0; }
  h1 { font-size: 15pt; }
  h2, h3, summary, .notice-title, caption { break-after: avoid; }
  figure, .notice, .head, tr { break-inside: avoid; }
  thead { display: table-header-group; break-inside: avoid; break-after: avoid; }
  tbody tr:first-child { break-before: avoid; }
  p { orphans: 3; widows: 3; }
  .head { grid-template-columns: 2fr 3fr; }
  .answer p:first-child { font-size: 12pt; }
  .answer p { font-size: 10pt; }
  .figures { grid-template-columns: 1fr 1fr; gap: 0 6mm; }
  .figures:not(.small) > figure:only-child { max-width: 13cm; grid-column: span 2; }
  .figures.small { grid-template-columns: 1fr 1fr 1fr; gap: 0 4mm; }
  .contents, details:not([open]) { display: none; }
  details { border: 0; padding: 0; }
  .table { overflow: visible; }
  table { font-size: 8pt; max-width: 100%; }
  table.wide { font-size: 6.5pt; }
  /* Names as long as jointed_slope_above_fault may be broken, words of a verdict should not. */
  th, td, td:first-child, td:last-child:not(.number) { padding: .15rem .3rem; overflow-wrap: anywhere; min-width: 6.8em; }
  .number, td.number:first-child { min-width: 5.2em; }
  td.number { white-space: normal; }
}
)css";

}  // namespace delabole
