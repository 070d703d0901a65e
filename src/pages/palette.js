"use strict";

/** Colours by the page's variables, so that light, dark and paper have their own. */
const palette = {
  /** What stands for a model, an index or "recorded", in a style. */
  colour(model) { return `var(--model-${model})`; },

  /** What a variable stands for now. */
  value(variable) {
    return getComputedStyle(document.documentElement).getPropertyValue(variable).trim();
  },

  /** Lengths of a model's dashes and the gaps between them; none of a solid line. */
  dashes(model) {
    const text = palette.value(`--dash-${model}`);
    return text === "none" ? [] : text.split(" ").map(Number);
  },

  /** Which line is which model's: `named` has [name, model]. */
  show_keys(named, element) {
    const svg = "http://www.w3.org/2000/svg";
    for (const [name, model] of named) {
      const key = document.createElement("span"), sign = document.createElementNS(svg, "svg");
      const line = document.createElementNS(svg, "path");
      sign.setAttribute("viewBox", "0 0 28 6");
      line.setAttribute("d", "M0 3h28");
      line.setAttribute("stroke", palette.colour(model));
      line.setAttribute("stroke-width", 4);
      line.setAttribute("stroke-dasharray", `var(--dash-${model})`);
      sign.append(line);
      key.append(sign, name);
      element.append(key);
    }
  },

  /** [name, model] of all models. */
  named(data) { return data.models.map((name, model) => [name, model]); },
};
