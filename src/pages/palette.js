"use strict";

/** Colours by the style sheet's variables, so that light, dark and paper have their own. */
const palette = {
  colours: 5, // but for the reference's, which is grey

  /** The variable of a model's colour. */
  variable(data, model) {
    const others = data.models.filter((name) => name !== data.reference);
    const index = others.indexOf(data.models[model]);
    return `--model-${index < 0 ? 0 : 1 + (index % palette.colours)}`;
  },

  /** What a variable stands for now: a canvas does not know variables. */
  value(variable) {
    return getComputedStyle(document.documentElement).getPropertyValue(variable).trim();
  },

  /** Which colour is which model's. */
  show_keys(data, element) {
    const svg = "http://www.w3.org/2000/svg";
    data.models.forEach((name, model) => {
      const key = document.createElement("span"), sign = document.createElementNS(svg, "svg");
      const line = document.createElementNS(svg, "path");
      sign.setAttribute("viewBox", "0 0 16 6");
      line.setAttribute("d", "M0 1h16v4h-16z");
      line.setAttribute("fill", `var(${palette.variable(data, model)})`);
      sign.append(line);
      key.append(sign, name);
      element.append(key);
    });
  },
};
