// Colours: Okabe and Ito's, which people with colour-blindness tell apart; lighter ones of them on
// dark ground. Lines differ in their dashes, too.
#include "validation/page_parts.hpp"

namespace pedzone::page {

// No '<' and '&' in here: the page is well-formed XML.
std::string_view style() {
  return R"css(
:root {
  color-scheme: light dark;
  --ground: #ffffff; --ink: #1a1a1a; --faint: #5f6368; --rule: #d5d8dc; --panel: #f4f5f7;
  --recorded: #000000; --main: #d55e00; --plain: #0072b2; --straight: #00805a;
  --constant: #8a6d00; --other: #a94c84;
}
@media (prefers-color-scheme: dark) {
  :root {
    --ground: #15181c; --ink: #eceff1; --faint: #a7adb5; --rule: #3a4048; --panel: #20252b;
    --recorded: #ffffff; --main: #e69f00; --plain: #56b4e9; --straight: #14b88a;
    --constant: #f0e442; --other: #cc79a7;
  }
}
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1rem; max-width: 90rem; background: var(--ground);
  color: var(--ink); font: 1rem/1.5 system-ui, sans-serif; overflow-wrap: anywhere; }
h1 { font-size: 1.8rem; line-height: 1.2; margin: 0.5rem 0; }
h2 { margin: 2.5rem 0 0.5rem; border-bottom: 2px solid var(--rule); }
h3 { margin: 1.5rem 0 0.3rem; }
h3 small, .sub { color: var(--faint); font-weight: normal; }
p { max-width: 50rem; }
nav a { margin-right: 1.2rem; color: var(--plain); white-space: nowrap; }
summary { cursor: pointer; font-weight: 600; padding: 0.5rem 0; color: var(--plain); }
details { border-top: 1px solid var(--rule); }
.tiles { display: flex; flex-wrap: wrap; gap: 0.8rem; padding: 0; list-style: none; }
.tiles li { background: var(--panel); border-radius: 6px; padding: 0.5rem 1rem; min-width: 8rem; }
.tiles b { display: block; font-size: 1.7rem; line-height: 1.2; }
.meanings { columns: 22rem; padding: 0; list-style: none; font-size: 0.9rem; }
.meanings li { break-inside: avoid; margin: 0 0 0.4rem; }
.scroll { overflow-x: auto; margin: 0.3rem 0 1.2rem; }
table { border-collapse: collapse; font-size: 0.88rem; font-variant-numeric: tabular-nums; }
.figures th, .figures td { padding: 0.25rem 0.5rem; text-align: right; vertical-align: top;
  white-space: nowrap; overflow-wrap: normal; border-bottom: 1px solid var(--rule); }
.figures thead th { font-weight: 600; vertical-align: bottom; }
.figures thead small { display: block; font-weight: normal; color: var(--faint); }
.figures .first { border-left: 1px solid var(--rule); }
.figures .block { text-align: center; }
.figures tbody th, .figures .corner { text-align: left; position: sticky; left: 0;
  background: var(--ground); max-width: 11rem; white-space: normal; overflow-wrap: anywhere; }
.figures tbody th { font-weight: normal; min-width: 8.2rem; }
.figures td small { display: block; color: var(--faint); font-size: 0.72rem; }
.figures .row-recorded > *, .figures .row-recorded th { background: var(--panel); }
.figures .row-main td, .figures .row-main th { font-weight: 700; }
.figures .row-main td small { font-weight: normal; }
.key { display: inline-flex; align-items: center; gap: 0.4rem; }
.key svg { flex: none; width: 26px; height: 10px; }
.legend { display: flex; flex-wrap: wrap; gap: 0.3rem 1.4rem; margin: 0.4rem 0; }
.grid { display: grid; gap: 1rem; grid-template-columns: repeat(auto-fill, minmax(16.5rem, 1fr)); }
.cases { grid-template-columns: repeat(auto-fill, minmax(min(100%, 26rem), 1fr)); gap: 1.5rem; }
figure { margin: 0; min-width: 0; }
figure > svg { display: block; width: 100%; height: auto; }
figcaption { font-size: 0.88rem; }
figcaption .legend { gap: 0.1rem 1rem; }
.case > svg { background: var(--panel); border-radius: 6px; }
.case table { width: 100%; }
.case td, .case th { text-align: right; padding: 0.1rem 0.3rem; font-weight: normal; }
.case th:first-child { text-align: left; }
.case thead th { color: var(--faint); white-space: nowrap; overflow-wrap: normal; }
.glance { grid-template-columns: repeat(auto-fill, minmax(min(100%, 20rem), 1fr)); }
.glance table { width: 100%; table-layout: fixed; }
.glance tbody th { width: 10.5rem; }
.glance td, .glance th { padding: 0.1rem 0.3rem 0.1rem 0; text-align: left; font-weight: normal; }
.glance .wide svg { display: block; width: 100%; height: auto; }
.glance .value { width: 3rem; text-align: right; }
.glance caption { text-align: left; font-weight: 600; }
.glance .axis span { display: flex; justify-content: space-between; }
.glance .axis small { color: var(--faint); }
.clock { display: inline-block; width: 8rem; height: 0.6rem; border-radius: 3px;
  background: linear-gradient(to right, #1e88cd, #cc79a7, #e69f00); }
svg text { font-family: system-ui, sans-serif; fill: var(--ink); }
svg .tick { fill: var(--faint); font-size: 11px; }
svg .title { font-size: 12px; }
svg .mark { font-size: 11px; paint-order: stroke; stroke: var(--panel); stroke-width: 3px;
  stroke-linejoin: round; }
svg .grid-line { stroke: var(--rule); stroke-width: 1; fill: none; }
svg .axis { stroke: var(--faint); stroke-width: 1; fill: none; }
svg .line { fill: none; stroke-width: 1.8; stroke-linejoin: round; }
svg .dot { stroke: none; }
svg .band { fill: var(--recorded); opacity: 0.12; stroke: none; }
svg .vehicle { fill: none; stroke-width: 1.4; }
svg .place { stroke: var(--ink); stroke-width: 0.8; }
svg .place.walked { stroke: var(--main); stroke-width: 1.4; }
svg .driven { font-weight: 700; }
svg .foot { fill: var(--panel); stroke: none; }
svg .ends { fill: var(--ground); stroke: var(--ink); stroke-width: 1.6; }
svg .scale { stroke: var(--ink); stroke-width: 2; fill: none; }
.recorded { stroke: var(--recorded); fill: var(--recorded); }
.main { stroke: var(--main); fill: var(--main); }
.plain { stroke: var(--plain); fill: var(--plain); }
.straight { stroke: var(--straight); fill: var(--straight); }
.constant { stroke: var(--constant); fill: var(--constant); }
.other { stroke: var(--other); fill: var(--other); }
svg .line.recorded { stroke-width: 3; }
svg .line.plain { stroke-dasharray: 7 3; }
svg .line.straight { stroke-dasharray: 2 2.5; }
svg .line.constant { stroke-dasharray: 9 3 2 3; }
svg .line.walked { stroke-dasharray: 6 3.5; stroke-width: 2.2; }
@media print { body { max-width: none; } }
)css";
}

}  // namespace pedzone::page
