// report_script.cpp: the script of the report page, first part: what is shown, the facts, the list, the panes.
#include <raster/image/report_page.h>

namespace raster::report_parts {

const char* const script_panes = R"js(
"use strict";
const $ = id => document.getElementById(id);
const report = JSON.parse($("data").textContent);
const pairs = report.pairs;
const fails = pair => !pair.facts.passes;
const glyphs = {same: "=", tolerated: "\u2248", different: "\u2260", "size mismatch": "\u2922", "type mismatch": "\u2260",
                "not a number": "NaN", unreadable: "!", missing: "\u2212", added: "+"};
const modes = [["side", "Side by side"], ["slider", "Slider"], ["blink", "Blink"], ["difference", "Difference"], ["flip", "FLIP"]];
const pictures = {expected: "expected", actual: "actual", difference: "difference", flip: "FLIP: how visible, dark to light"};

// What is shown. zoom is screen pixels a picture pixel; x, y is the picture's point in the middle of each pane.
const view = {pair: 0, mode: "side", zoom: 1, x: 0, y: 0, fitted: true, split: 0.5, shown: "expected", blinking: true, place: -1, pixel: null};
let panes = [];
let blinkTimer = 0;

const make = (tag, attributes = {}, ...children) => {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes))
    if (name === "class") element.className = value;
    else if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value);
  element.append(...children);
  return element;
};
const grouped = n => String(n).replace(/\B(?=(\d{3})+$)/g, ",");
const current = () => pairs[view.pair];
const regions = () => current().facts.regions;

// ---------------------------------------------------------------------------------------------- facts

function number(value, digits) {
  if (value === null) return "\u221e";
  return digits === undefined ? String(value) : value.toFixed(digits);
}
function significant(value) {
  if (value === null) return "\u221e";
  return value === 0 ? "0" : Number(value.toPrecision(4)).toString();
}

function showFacts() {
  const facts = current().facts, figures = facts.figures;
  const verdict = $("verdict");
  verdict.textContent = glyphs[facts.verdict] + " " + facts.verdict;
  verdict.className = facts.passes ? "badge pass" : "badge";
  $("name").textContent = facts.name;
  $("reason").textContent = facts.reason;
  const cells = [];
  if (figures) {
    const share = 100 * figures.differing / figures.compared;
    cells.push(["differing pixels", `${grouped(figures.differing)} of ${grouped(figures.compared)} (${significant(share)} %)`]);
    if (figures.failing !== figures.differing) cells.push(["beyond the gates", grouped(figures.failing)]);
    cells.push(["max", figures.differing ? `${number(figures.max)} at (${figures.max_at})` : "0"], ["mean", significant(figures.mean)],
               ["RMS", significant(figures.rms)], ["PSNR", number(figures.psnr, 2) + " dB"],
               ["SSIM", (Math.floor(figures.ssim * 1e4) / 1e4).toFixed(4)],
               ["FLIP", figures.flip < 0.0005 ? String(figures.flip) : figures.flip.toFixed(3)]);
  }
  $("figures").replaceChildren(...cells.map(([name, value]) => make("div", {}, make("dt", {}, name), make("dd", {}, value))));
  const lines = [];
  const code = text => make("code", {}, text);
  if (figures) lines.push(["gates", [code(facts.gates.options)]]);
  if (facts.would_pass.length)
    lines.push(["tightest that pass", facts.would_pass.flatMap((gates, i) => [i ? " or " : "", code(gates.options)])]);
  for (const text of facts.warnings) lines.push(["warning", [text]]);
  for (const text of facts.notes) lines.push(["note", [text]]);
  const side = file => [file.path || "(in memory)", file.shape ? "  \u2013  " + file.shape : ""];
  if (facts.expected.path || facts.expected.shape) lines.push(["expected", side(facts.expected)]);
  if (facts.actual.path || facts.actual.shape) lines.push(["actual", side(facts.actual)]);
  if (facts.approvable) lines.push(["if it is right", [code("raster approve " + report.folder)]]);
  $("more").replaceChildren(...lines.flatMap(([name, parts]) => [make("dt", {}, name), make("dd", {}, ...parts)]));
}

function showList() {
  const all = $("show-passing").checked;
  const items = [];
  pairs.forEach((pair, i) => {
    if (!all && !fails(pair) && i !== view.pair) return;
    const badge = make("span", {class: fails(pair) ? "badge" : "badge pass", title: pair.facts.verdict}, glyphs[pair.facts.verdict]);
    const button = make("button", {onclick: () => choose(i)}, badge, make("span", {}, pair.facts.name));
    if (i === view.pair) button.setAttribute("aria-current", "true");
    items.push(make("li", {}, button));
  });
  $("names").replaceChildren(...items);
}

// ---------------------------------------------------------------------------------------------- panes

const hasPictures = pair => Boolean(pair.expected || pair.actual);
const sizeOf = pair => [Math.max(pair.facts.width, 1), Math.max(pair.facts.height, 1)];

function addPicture(pane, which) {
  const url = current()[which];
  if (!url) {
    const verdict = current().facts.verdict;
    const why = verdict === "missing" || verdict === "added" ? "no " + which + " picture" : "no " + pictures[which].split(":")[0] + " picture here";
    pane.append(make("div", {class: "none"}, why));
    return null;
  }
  const image = make("img", {alt: "", draggable: "false"});
  image.addEventListener("load", () => { if (view.fitted) fit(); else draw(); });
  image.src = url;
  if (which === "flip") image.classList.add("heat");
  if (which === "difference" || which === "flip") image.classList.add("opaque");
  pane.append(image);
  return image;
}

function addPane(parts, caption) {
  const element = make("div", {class: "pane", tabindex: "0", role: "img", "aria-label": caption + " picture of " + current().facts.name});
  const pane = {element, images: {}, marks: [], caption: null};
  for (const which of parts) pane.images[which] = addPicture(element, which);
  pane.caption = make("span", {class: "caption"}, caption);
  pane.cross = make("div", {class: "cross", hidden: ""});
  element.append(pane.caption, pane.cross);
  element.addEventListener("wheel", event => { event.preventDefault(); zoomAt(pane, event, Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015))); }, {passive: false});
  element.addEventListener("dblclick", event => zoomAt(pane, event, 2));
  element.addEventListener("pointerdown", event => startMove(pane, event));
  element.addEventListener("pointermove", event => readPixel(pane, event));
  element.addEventListener("pointerleave", () => { view.pixel = null; draw(); });
  panes.push(pane);
  $("stage").append(element);
  return pane;
}

function build() {
  clearInterval(blinkTimer);
  panes = [];
  $("stage").replaceChildren();
  $("toolbar").hidden = !hasPictures(current());
  if (!hasPictures(current())) {
    const text = fails(current()) ? "There is no picture to show." : "Pictures that pass are not in this report.";
    $("stage").append(make("p", {class: "empty"}, text));
    return;
  }
  if (view.mode === "side") {
    addPane(["expected"], "expected");
    addPane(["actual"], "actual");
    if (current().difference) addPane(["difference"], "difference");
  } else if (view.mode === "slider") {
    const pane = addPane(["expected", "actual"], "expected");
    pane.element.append(make("span", {class: "caption right"}, "actual"));
    addHandle(pane);
  } else if (view.mode === "blink") {
    addPane(["expected", "actual"], "expected");
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    view.blinking = view.blinking && !still;
    blinkTimer = setInterval(() => { if (view.blinking) alternate(); }, 600);
  } else {
    addPane([view.mode], pictures[view.mode]);
  }
  for (const button of $("modes").children) button.setAttribute("aria-pressed", String(button.dataset.mode === view.mode));
  history.replaceState(null, "", "#" + view.pair + "/" + view.mode);
  draw();
}

function alternate() {
  view.shown = view.shown === "expected" ? "actual" : "expected";
  draw();
}

function addHandle(pane) {
  const handle = make("div", {class: "handle", role: "slider", tabindex: "0", "aria-label": "How much of the expected picture is shown",
                              "aria-valuemin": "0", "aria-valuemax": "100"});
  const set = split => { view.split = Math.min(Math.max(split, 0), 1); draw(); };
  handle.addEventListener("pointerdown", event => {
    event.stopPropagation();
    handle.setPointerCapture(event.pointerId);
    handle.onpointermove = move => {
      const box = pane.element.getBoundingClientRect();
      set((move.clientX - box.left) / box.width);
    };
  });
  handle.addEventListener("pointerup", () => { handle.onpointermove = null; });
  handle.addEventListener("keydown", event => {
    const step = {ArrowLeft: -0.02, ArrowRight: 0.02, Home: -1, End: 1}[event.key];
    if (step === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    set(view.split + step * (event.shiftKey ? 5 : 1));
  });
  pane.handle = handle;
  pane.element.append(handle);
}
)js";

}  // namespace raster::report_parts
