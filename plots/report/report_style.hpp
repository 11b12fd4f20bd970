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
main { max-width: 52rem; margin: 0 auto; padding: 1rem; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: .5rem 0 .2rem; }
h2 { font-size: 1.3rem; line-height: 1.25; margin: 2.2rem 0 .6rem; border-bottom: 1px solid #ccc; padding-bottom: .2rem; }
h3 { font-size: 1.08rem; margin: 1.5rem 0 .4rem; }
p { margin: .6rem 0; }
.subtitle { color: #555; margin-top: 0; }
ul { padding-left: 1.3rem; }
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
figure { margin: 1.4rem 0; }
figure svg { display: block; width: 100%; height: auto; max-width: 42rem; margin: 0 auto; }
figure svg image { image-rendering: pixelated; }
figcaption { font-size: .92rem; color: #333; margin-top: .4rem; }
.missing { border: 2px dashed #d55e00; background: #fdf1e7; padding: 1.2rem; overflow-wrap: anywhere; }
.provenance { display: grid; grid-template-columns: minmax(6rem, auto) 1fr; gap: .2rem 1rem; font-size: .9rem; }
.provenance dt { color: #555; }
.provenance dd { margin: 0; overflow-wrap: anywhere; }
@media (max-width: 30rem) {
  body { font-size: 16px; }
  main { padding: .7rem; }
  th, td { padding: .3rem .35rem; font-size: .85rem; }
  td:first-child { min-width: 7rem; }
  .provenance { grid-template-columns: 1fr; gap: 0; }
  .provenance dd { margin-bottom: .5rem; }
}
@media print {
  body { font-size: 10pt; }
  main { max-width: none; padding: 0; }
  h2, h3 { break-after: avoid; }
  figure, .notice, tr { break-inside: avoid; }
  figure svg { max-width: 15cm; }
  .table { overflow: visible; }
}
)css";

}  // namespace delabole
