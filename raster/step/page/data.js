// data.js: what the renderer told, ready to look up; and numbers as text.

const data = JSON.parse(document.getElementById("data").textContent);
const stages = ["vertex", "assemble", "clip", "project", "cull", "setup", "coverage", "depth", "interpolate",
    "fragment", "blend"];
const first_pixel_stage = stages.indexOf("coverage");
const region = { x0: data.region[0], y0: data.region[1], x1: data.region[2], y1: data.region[3] };
const in_region = (x, y) => x >= region.x0 && x <= region.x1 && y >= region.y0 && y <= region.y1;

const triangle_index = new Map(data.triangles.map((t, i) => [t.number, i]));

/** Runs of equal steps (start, step, count, ...) back into the values that were recorded. */
function from_runs(runs) {
    const values = [];
    for (let i = 0; i < runs.length; i += 3)
        for (let k = 0; k < runs[i + 2]; ++k) values.push(runs[i] + k * runs[i + 1]);
    return values;
}
for (const t of data.triangles)
    for (const piece of t.pieces || [])
        if (piece.setup) piece.setup.coverage.values = piece.setup.coverage.runs.map(from_runs);

/** The three recorded edge values at a pixel, or null where the renderer did not look. */
function edges_at(piece, x, y) {
    if (!piece.setup) return null;
    const [x0, y0, width, height] = piece.setup.coverage.rect;
    if (x < x0 || y < y0 || x >= x0 + width || y >= y0 + height) return null;
    const i = (y - y0) * width + (x - x0);
    return piece.setup.coverage.values.map(values => values[i]);
}

/** Whether edge values mean covered, under the ownership that `rule` names: inclusive, opengl or direct3d. */
const covered_by = (piece, edges, rule = "inclusive") =>
    edges.every((e, k) => e > 0 || (e === 0 && piece.setup.edges[k][rule]));

const fragments_by_pixel = new Map();
for (const f of data.fragments) {
    const key = f.x + "," + f.y;
    if (!fragments_by_pixel.has(key)) fragments_by_pixel.set(key, []);
    fragments_by_pixel.get(key).push(f);
}
const fragments_at = (x, y) => fragments_by_pixel.get(x + "," + y) || [];
const fragment_of = (t, piece, x, y) => fragments_at(x, y).find(f => f.triangle === t.number && f.piece === piece);
const painted_at = (x, y) => data.painted.filter(p => p[0] === x && p[1] === y);

const escape_html = text => String(text).replace(/[&<>"]/g, c => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" }[c]));

let all_digits = false;
const with_minus = text => text.replace(/-/g, "−");

/** A number as people read it: five digits, or all of them. Whole numbers are never cut. */
function short_text(value) {
    if (typeof value === "string") return value;
    if (all_digits || Number.isInteger(value)) return with_minus(group(String(value)));
    const size = Math.abs(value);
    const text = size < 1e-4 || size >= 1e6 ? value.toExponential(3) : String(Number(value.toPrecision(5)));
    return with_minus(text);
}
function group(text) {
    return /^-?\d{5,}$/.test(text) ? text.replace(/\B(?=(\d{3})+$)/g, "\u202f") : text;
}
/** The same as HTML, with every digit in the tip. */
const num = value => `<span class="n" title="${escape_html(value)}">${short_text(value)}</span>`;
/** In a formula, negative operands in brackets. */
const operand = value => (value < 0 ? `(${num(value)})` : num(value));
const list = values => values.map(num).join(", ");
const tuple = values => `(${list(values)})`;

/** What becomes of the stored light on the screen. */
const is_plain = !data.display.srgb && data.display.exposure === 0;
function on_screen(light) {
    const value = light * 2 ** data.display.exposure;
    return !data.display.srgb ? value : value <= 0.0031308 ? value * 12.92 : 1.055 * value ** (1 / 2.4) - 0.055;
}
const display_words = `the screen gets light${data.display.exposure ? ` · 2^${data.display.exposure}` : ""}${data.display.srgb ? ", encoded by the transfer function of sRGB" : ""}`;

const byte = value => Math.round(Math.min(Math.max(value, 0), 1) * 255);
const hex_of_bytes = bytes => "#" + bytes.slice(0, 3).map(b => b.toString(16).padStart(2, "0")).join("");
const hex = color => hex_of_bytes(color.slice(0, 3).map(c => byte(is_plain ? c : on_screen(c))));
const patch = color => `<span class="swatch" style="background:${color}"></span>`;
/** A colour as the screen shows it; its bytes too where they are the renderer's own. */
const swatch = color => patch(hex(color)) + (is_plain ? `<code>${hex(color)}</code>` : "");
/** What a fragment left behind. */
const after_hex = f => (f.shown ? hex_of_bytes(f.shown) : hex(f.after));
const after_swatch = f => patch(after_hex(f)) + `<code>${after_hex(f)}</code>`;
/** The summands of a fragment's colour, or null where the shader had their sum alone. */
function terms_of(f) {
    if (f.terms) return f.terms;
    if (!f.outputs || f.outputs.length < 20) return null;
    const from = first => f.outputs.slice(first, first + 3);
    return { emission: from(17), ambient: from(8), diffuse: from(11), specular: from(14) };
}
const mark = good => (good ? '<span class="good">+ ' : '<span class="bad">− ');
const yes = text => `${mark(true)}${text}</span>`;
const no = text => `${mark(false)}${text}</span>`;
