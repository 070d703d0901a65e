"use strict";

const report = {data: JSON.parse(document.getElementById("data").textContent), ready: false};

/** Charts of what is open, once. */
function draw_curves() {
  for (const element of document.querySelectorAll("[data-group]")) {
    if (element.childElementCount > 0 || element.closest("details:not([open])")) continue;
    curves.draw_group(report.data, element);
  }
}

for (const element of document.querySelectorAll("[data-glance]")) {
  glance.draw_all(report.data, element);
}
for (const element of document.querySelectorAll(".curve-keys")) {
  palette.show_keys(curves.named(report.data), element);
}
draw_curves();
for (const details of document.querySelectorAll("details")) {
  details.addEventListener("toggle", draw_curves);
}
report.ready = true;
window.report = report;
