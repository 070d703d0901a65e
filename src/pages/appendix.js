"use strict";

/** On paper, what is folded on the screen is an appendix at the end of the page. */
const appendix = {
  moved: [], // [details, the mark in its place]

  make() {
    const main = document.querySelector("main");
    const folded = [...main.querySelectorAll("details:not([open]):not(.screen-only)")];
    if (folded.length === 0 || appendix.moved.length > 0) return;
    const section = document.createElement("section"), heading = document.createElement("h2");
    section.id = "appendix";
    heading.textContent = "Appendix";
    section.append(heading);
    for (const details of folded) {
      const mark = document.createComment("");
      details.replaceWith(mark);
      details.open = true;
      section.append(details);
      appendix.moved.push([details, mark]);
    }
    main.append(section);
  },

  undo() {
    for (const [details, mark] of appendix.moved.splice(0)) {
      details.open = false;
      mark.replaceWith(details);
    }
    document.getElementById("appendix")?.remove();
  },
};
addEventListener("beforeprint", appendix.make);
addEventListener("afterprint", appendix.undo);
