"use strict";

const report = {data: JSON.parse(document.getElementById("data").textContent), ready: false};

palette.show_keys(palette.named(report.data), document.getElementById("model-keys"));
for (const element of document.querySelectorAll("[data-test]")) {
  charts.draw_test(report.data, element);
}
report.ready = true;
window.report = report;
