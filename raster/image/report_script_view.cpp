// report_script_view.cpp: the script of the report page, second part: one view (zoom, centre) that all panes share.
#include <raster/image/report_page.h>

namespace raster::report_parts {

const char* const script_view = R"js(
// ---------------------------------------------------------------------------------------------- one view for all

// From the picture's coordinates to a pane's.
function toPane(pane, x, y) {
  return [(x - view.x) * view.zoom + pane.element.clientWidth / 2, (y - view.y) * view.zoom + pane.element.clientHeight / 2];
}
function toPicture(pane, event) {
  const box = pane.element.getBoundingClientRect();
  return [(event.clientX - box.left - pane.element.clientWidth / 2) / view.zoom + view.x,
          (event.clientY - box.top - pane.element.clientHeight / 2) / view.zoom + view.y];
}
function place(element, pane, x, y, width, height, least) {
  const [left, top] = toPane(pane, x, y);
  const w = Math.max(width * view.zoom, least), h = Math.max(height * view.zoom, least);
  element.style.transform = `translate(${left - (w - width * view.zoom) / 2}px, ${top - (h - height * view.zoom) / 2}px)`;
  element.style.left = element.style.top = "0";
  element.style.width = w + "px";
  element.style.height = h + "px";
}

function drawMarks(pane) {
  const wanted = $("show-places").checked ? regions() : [];
  while (pane.marks.length < wanted.length) {
    const mark = make("div", {class: "mark"});
    pane.marks.push(mark);
    pane.element.append(mark);
  }
  while (pane.marks.length > wanted.length) pane.marks.pop().remove();
  wanted.forEach((region, i) => {
    const margin = 5 / view.zoom;
    place(pane.marks[i], pane, region.x - margin, region.y - margin, region.width + 2 * margin, region.height + 2 * margin, 12);
    pane.marks[i].classList.toggle("current", i === view.place);
  });
}

function draw() {
  for (const pane of panes) {
    const [left, top] = toPane(pane, 0, 0);
    for (const image of Object.values(pane.images)) {
      if (!image) continue;
      image.style.transform = `translate(${left}px, ${top}px) scale(${view.zoom})`;
      image.classList.toggle("sharp", view.zoom >= 1);
    }
    if (view.mode === "slider") {
      const at = view.split * pane.element.clientWidth;
      pane.handle.style.left = at + "px";
      pane.handle.setAttribute("aria-valuenow", String(Math.round(view.split * 100)));
      // In the picture's own pixels, since the clip is scaled with it.
      if (pane.images.actual) pane.images.actual.style.clipPath = `inset(0 0 0 ${Math.max((at - left) / view.zoom, 0)}px)`;
      if (pane.images.expected)
        pane.images.expected.style.clipPath = `inset(0 ${Math.max(pane.images.expected.naturalWidth - (at - left) / view.zoom, 0)}px 0 0)`;
    }
    if (view.mode === "blink") {
      for (const [which, image] of Object.entries(pane.images)) if (image) image.style.visibility = which === view.shown ? "visible" : "hidden";
      pane.caption.textContent = view.shown + (view.blinking ? "" : " (stopped)");
    }
    drawMarks(pane);
    pane.cross.hidden = !view.pixel;
    if (view.pixel) place(pane.cross, pane, view.pixel[0], view.pixel[1], 1, 1, 5);
  }
  $("zoom").textContent = view.zoom >= 0.1 ? Math.round(view.zoom * 100) + " %" : (view.zoom * 100).toFixed(1) + " %";
  const count = regions().length;
  $("place-tools").hidden = count === 0;
  $("place").textContent = view.place < 0 ? `${grouped(current().facts.region_count)} place${count === 1 ? "" : "s"}` : `${view.place + 1} of ${count}`;
}

function fit() {
  if (!panes.length) return;
  const pane = panes[0].element, [width, height] = sizeOf(current());
  view.zoom = Math.min((pane.clientWidth - 16) / width, (pane.clientHeight - 16) / height);
  if (view.zoom > 1) view.zoom = Math.min(Math.floor(view.zoom), 32);
  view.zoom = Math.max(view.zoom, 0.005);
  view.x = width / 2;
  view.y = height / 2;
  view.fitted = true;
  draw();
}

function setZoom(zoom) {
  view.zoom = Math.min(Math.max(zoom, 0.005), 64);
  view.fitted = false;
  draw();
}
function zoomAt(pane, event, factor) {
  const before = toPicture(pane, event);
  setZoom(view.zoom * factor);
  const after = toPicture(pane, event);
  view.x += before[0] - after[0];
  view.y += before[1] - after[1];
  draw();
}
function startMove(pane, event) {
  if (event.button !== 0) return;
  const start = [event.clientX, event.clientY, view.x, view.y];
  pane.element.setPointerCapture(event.pointerId);
  pane.element.classList.add("moving");
  const move = now => {
    view.x = start[2] - (now.clientX - start[0]) / view.zoom;
    view.y = start[3] - (now.clientY - start[1]) / view.zoom;
    view.fitted = false;
    draw();
  };
  const stop = () => {
    pane.element.classList.remove("moving");
    pane.element.removeEventListener("pointermove", move);
  };
  pane.element.addEventListener("pointermove", move);
  pane.element.addEventListener("pointerup", stop, {once: true});
  pane.element.addEventListener("pointercancel", stop, {once: true});
}

// ---------------------------------------------------------------------------------------------- reading pixels

const canvases = new Map();  // of the current pair only: they are large
function colorAt(which, x, y) {
  const pane = panes.find(p => p.images[which]);
  const url = current()[which];
  if (!url) return null;
  if (!canvases.has(which)) {
    const image = pane ? pane.images[which] : null;
    if (!image || !image.complete || !image.naturalWidth) return null;
    const canvas = make("canvas", {width: image.naturalWidth, height: image.naturalHeight});
    const context = canvas.getContext("2d", {willReadFrequently: true});
    context.drawImage(image, 0, 0);
    canvases.set(which, context);
  }
  const context = canvases.get(which);
  if (x >= context.canvas.width || y >= context.canvas.height) return null;
  return Array.from(context.getImageData(x, y, 1, 1).data);
}
function swatch(color) {
  const element = make("span", {class: "swatch"});
  element.style.background = `rgba(${color[0]},${color[1]},${color[2]},${color[3] / 255})`;
  return element;
}
function readPixel(pane, event) {
  const [fx, fy] = toPicture(pane, event), [width, height] = sizeOf(current());
  const x = Math.floor(fx), y = Math.floor(fy);
  view.pixel = x >= 0 && y >= 0 && x < width && y < height ? [x, y] : null;
  draw();
  if (!view.pixel) return;
  const parts = [`(${x},${y})  `];
  const colors = ["expected", "actual"].map(which => colorAt(which, x, y));
  const text = color => color.slice(0, color[3] === 255 ? 3 : 4).join(" ");
  if (colors[0]) parts.push(" expected ", swatch(colors[0]), " " + text(colors[0]));
  if (colors[1]) parts.push("   actual ", swatch(colors[1]), " " + text(colors[1]));
  if (colors[0] && colors[1]) parts.push("   difference " + colors[0].map((v, i) => colors[1][i] - v).slice(0, colors[0][3] === 255 && colors[1][3] === 255 ? 3 : 4).join(" "));
  if (/16 bits|floats/.test(current().facts.expected.shape)) parts.push("   (as 8 bits)");
  $("pixel").replaceChildren(...parts);
}

// ---------------------------------------------------------------------------------------------- going about

function choose(pair) {
  view.pair = pair;
  view.place = -1;
  view.fitted = true;
  canvases.clear();
  if (!current()[view.mode] && (view.mode === "difference" || view.mode === "flip")) view.mode = "side";
  for (const button of $("modes").children)
    button.disabled = (button.dataset.mode === "difference" || button.dataset.mode === "flip") && !current()[button.dataset.mode];
  showList();
  showFacts();
  build();
  fit();
}
function step(by) {
  const all = $("show-passing").checked;
  for (let i = view.pair + by; i >= 0 && i < pairs.length; i += by)
    if (all || fails(pairs[i])) return choose(i);
}
function setMode(mode) {
  if (["difference", "flip"].includes(mode) && !current()[mode]) return;
  view.mode = mode;
  view.blinking = true;
  build();
  if (view.fitted) fit();
}
function goToPlace(by) {
  const list = regions();
  if (!list.length || !panes.length) return;
  view.place = (view.place + by + list.length + (view.place < 0 && by < 0 ? 1 : 0)) % list.length;
  const region = list[view.place], pane = panes[0].element;
  view.x = region.x + region.width / 2;
  view.y = region.y + region.height / 2;
  const zoom = Math.min(pane.clientWidth / (region.width * 2 + 16), pane.clientHeight / (region.height * 2 + 16), 16);
  setZoom(zoom > 1 ? Math.floor(zoom) : zoom);
}
function toggleTheme() {
  const root = document.documentElement;
  const dark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  root.dataset.theme = dark ? "light" : "dark";
}
function toggleHelp() {
  if ($("help").open) $("help").close(); else $("help").showModal();
}

const keys = {
  n: () => goToPlace(1), p: () => goToPlace(-1), j: () => step(1), k: () => step(-1),
  "+": () => setZoom(view.zoom * 1.5), "=": () => setZoom(view.zoom * 1.5), "-": () => setZoom(view.zoom / 1.5),
  "0": fit, "9": () => setZoom(1), t: toggleTheme, "?": toggleHelp,
  m: () => { $("show-places").checked = !$("show-places").checked; draw(); },
  b: () => { view.blinking = true; },
};
modes.forEach(([mode], i) => { keys[String(i + 1)] = () => setMode(mode); });

document.addEventListener("keydown", event => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if ($("help").open) {
    if (event.key === "?") toggleHelp();
    return;
  }
  const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
  if (arrows[event.key]) {
    event.preventDefault();
    const far = (event.shiftKey ? 320 : 40) / view.zoom;
    view.x += arrows[event.key][0] * far;
    view.y += arrows[event.key][1] * far;
    view.fitted = false;
    return draw();
  }
  if (event.key === " " && view.mode === "blink" && event.target.tagName !== "BUTTON") {
    event.preventDefault();
    if (view.blinking) view.blinking = false; else alternate();
    return draw();
  }
  const action = keys[event.key];
  if (action) { event.preventDefault(); action(); }
});

modes.forEach(([mode, label], i) => {
  const button = make("button", {onclick: () => setMode(mode)}, label + " ", make("kbd", {}, String(i + 1)));
  button.dataset.mode = mode;
  $("modes").append(button);
});
$("zoom-in").onclick = keys["+"];
$("zoom-out").onclick = keys["-"];
$("fit").onclick = fit;
$("actual-size").onclick = keys["9"];
$("next-place").onclick = keys.n;
$("previous-place").onclick = keys.p;
$("theme").onclick = toggleTheme;
$("help-button").onclick = toggleHelp;
$("help-close").onclick = toggleHelp;
$("show-places").onchange = draw;
$("show-passing").onchange = showList;
addEventListener("resize", () => { if (view.fitted) fit(); else draw(); });

const failed = pairs.filter(fails).length;
$("summary").textContent = `${failed} of ${pairs.length} picture${pairs.length === 1 ? "" : "s"} failed`;
document.title = `${failed} failed \u2013 raster diff`;
$("list").hidden = pairs.length < 2;
if (pairs.every(fails)) $("show-passing").parentElement.hidden = true;
const [wantedPair, wantedMode] = location.hash.slice(1).split("/");
if (modes.some(([mode]) => mode === wantedMode)) view.mode = wantedMode;
const firstFailing = Math.max(pairs.findIndex(fails), 0);
if (pairs.length) choose(/^\d+$/.test(wantedPair) && Number(wantedPair) < pairs.length ? Number(wantedPair) : firstFailing);
)js";

}  // namespace raster::report_parts
