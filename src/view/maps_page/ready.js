"use strict";
window.report = {ready: true}; // nothing is drawn by scripts
