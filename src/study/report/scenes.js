"use strict";

/** Animations, each in a frame that may run its own scripts and nothing else. */
const scenes = {
  play(figure, page) {
    const frame = document.createElement("iframe");
    frame.setAttribute("sandbox", "allow-scripts");
    frame.title = figure.querySelector("figcaption").textContent;
    frame.srcdoc = page;
    figure.querySelector(".still").hidden = true;
    figure.querySelector("button").replaceWith(frame);
    figure.classList.add("played");
    frame.scrollIntoView({block: "nearest"}); // what is not to be seen does not play
  },

  prepare(pages) {
    for (const figure of document.querySelectorAll(".scene")) {
      figure.querySelector("button").addEventListener(
        "click", () => scenes.play(figure, pages[Number(figure.dataset.scene)]));
    }
  },
};
