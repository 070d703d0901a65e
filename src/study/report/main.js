"use strict";

const report = {data: JSON.parse(document.getElementById("data").textContent), ready: false};

/** Charts of conditions that are open. */
function draw_lines() {
  for (const element of document.querySelectorAll("details[open] [data-series]")) {
    lines.draw(report.data, element);
  }
}

palette.show_keys(palette.named(report.data), document.getElementById("model-keys"));
distributions.draw_all(report.data, document.getElementById("distribution-charts"));
gaps.draw_all(report.data);
draw_lines();
for (const details of document.querySelectorAll("details.condition")) {
  details.addEventListener("toggle", draw_lines);
}
scenes.prepare(JSON.parse(document.getElementById("scene-pages").textContent));

addEventListener("beforeprint", draw_lines); // after the appendix is made: what it shows is drawn
report.ready = true;
window.report = report;
