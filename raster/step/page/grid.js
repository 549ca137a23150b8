// grid.js: the pixel pane: the picture, the sample points with the signs of the edge functions, the triangle on top.

const other_order = () => (data.options.visibility === "painter" ? "zbuffer" : "painter");
const grid_canvas = document.getElementById("grid");
const grid = { scale: 24, x: data.focus.pixel[0] + 0.5, y: data.focus.pixel[1] + 0.5, layer: "picture", chosen: false };
const layers = [["picture", "colours of the picture"], ["inside", "signs of all edges"], ["e0", "edge 0"], ["e1", "edge 1"],
    ["e2", "edge 2"], ["weights", "barycentrics of this triangle"], ["depth", "depth that is stored"], ["owner", "which triangle is seen"],
    ["count", "how many triangles cover"], [other_order(), `picture by ${other_order() === "painter" ? "painter's order" : "z-buffer"}`],
    ["orders", "where z-buffer and painter part"],
    ...(data.bug ? [["right", "the right picture"], ["wrong", "where the bug shows"]] : [])];

const images = new Map();
function image_of(name) {
    if (!images.has(name)) {
        const image = new Image();
        image.onload = () => update();
        image.src = data.pictures[name];
        images.set(name, image);
    }
    return images.get(name);
}
/** The bytes of a pixel of one of the embedded pictures, or null. */
const readers = new Map();
function picture_bytes(name, x, y) {
    const [x0, y0, width, height] = data.pictures.rect;
    const reader = reader_of(name);
    if (!reader || x < x0 || y < y0 || x >= x0 + width || y >= y0 + height) return null;
    return [...reader.getImageData(x - x0, y - y0, 1, 1).data.slice(0, 3)];
}
/** A canvas with one of the pictures on it, or null while that is being decoded. */
function reader_of(name) {
    const image = image_of(name);
    if (!image.complete || !image.naturalWidth) return null;
    if (!readers.has(name)) {
        const canvas = document.createElement("canvas");
        [, , canvas.width, canvas.height] = data.pictures.rect;
        const context = canvas.getContext("2d", { willReadFrequently: true });
        context.drawImage(image, 0, 0);
        readers.set(name, context);
    }
    return readers.get(name);
}
/** Which pixels of two pictures differ: a byte each, and how many; or null while they are being decoded. */
const apart_cache = new Map();
function pictures_apart(one, two) {
    const key = one + " " + two, a = reader_of(one), b = reader_of(two);
    if (!a || !b) return null;
    if (!apart_cache.has(key)) {
        const [, , width, height] = data.pictures.rect;
        const p = new Uint32Array(a.getImageData(0, 0, width, height).data.buffer), q = new Uint32Array(b.getImageData(0, 0, width, height).data.buffer);
        const differ = p.map((value, i) => Number(value !== q[i]));
        apart_cache.set(key, { differ, count: differ.reduce((sum, d) => sum + d, 0), pixels: p.length });
    }
    return apart_cache.get(key);
}
const picture_name = () => (data.options.visibility === "painter" ? "painter" : data.options.frequency);

/** Blue where positive, orange where negative, stronger the farther from the edge. */
function heat(value, largest) {
    const strength = 0.18 + 0.6 * Math.sqrt(Math.min(Math.abs(value) / (largest || 1), 1));
    return value > 0 ? `rgba(${css("good-rgb")},${strength})` : value < 0 ? `rgba(${css("bad-rgb")},${strength})` : css("tie");
}
const largest_value = (piece, k) => piece.setup.coverage.values[k].reduce((m, v) => Math.max(m, Math.abs(v)), 1);

function draw_grid() {
    const { context: c, width, height } = fit_canvas(grid_canvas);
    const s = grid.scale;
    const left = width / 2 - grid.x * s, top = height / 2 - grid.y * s;
    const at = (x, y) => [left + x * s, top + y * s];

    const [px0, py0, pw, ph] = data.pictures.rect;
    c.imageSmoothingEnabled = s < 1;
    const t = current_triangle(), item = current_item(), piece = current_piece();
    const layer = grid_layer();
    const image = image_of(data.pictures[layer] ? layer : picture_name());
    if (image.complete && image.naturalWidth) c.drawImage(image, ...at(px0, py0), pw * s, ph * s);
    if (layer === "orders") mark_apart(c, at, s, pictures_apart(picture_name(), other_order()));
    if (layer === "wrong") mark_apart(c, at, s, pictures_apart(picture_name(), "right"));
    const view = { x0: Math.max(region.x0, Math.floor(-left / s)), x1: Math.min(region.x1, Math.ceil((width - left) / s)),
        y0: Math.max(region.y0, Math.floor(-top / s)), y1: Math.min(region.y1, Math.ceil((height - top) / s)) };
    for (let y = view.y0; y <= view.y1; ++y)
        for (let x = view.x0; x <= view.x1; ++x) draw_pixel(c, at(x, y), s, x, y, layer, piece, t);

    if (s >= 6) {
        c.strokeStyle = css("grid-line");
        c.lineWidth = 1;
        c.beginPath();
        for (let x = view.x0; x <= view.x1 + 1; ++x) { c.moveTo(...at(x, view.y0)); c.lineTo(...at(x, view.y1 + 1)); }
        for (let y = view.y0; y <= view.y1 + 1; ++y) { c.moveTo(...at(view.x0, y)); c.lineTo(...at(view.x1 + 1, y)); }
        c.stroke();
    }
    c.strokeStyle = css("soft");
    c.lineWidth = 1.5;
    c.setLineDash([6, 4]);
    c.strokeRect(...at(region.x0, region.y0), (region.x1 - region.x0 + 1) * s, (region.y1 - region.y0 + 1) * s);
    c.setLineDash([]);

    const outline = (positions, color, thickness, dash = []) => {
        c.beginPath();
        positions.forEach((p, i) => (i ? c.lineTo(...at(...p)) : c.moveTo(...at(...p))));
        c.closePath();
        c.setLineDash(dash);
        c.strokeStyle = css("pane");
        c.lineWidth = thickness + 2;
        c.stroke();
        c.strokeStyle = color;
        c.lineWidth = thickness;
        c.stroke();
        c.setLineDash([]);
    };
    for (const [k, p] of (t.pieces || []).entries()) {
        const corners = p.subpixel.map(([x, y]) => [x / 256 + 0.5, y / 256 + 0.5]);
        outline(corners, css("accent"), k === (item.piece || 0) ? 2.5 : 1);
        if (k !== (item.piece || 0)) continue;
        corners.forEach((p, i) => {
            const [x, y] = at(...p);
            c.fillStyle = css("accent");
            c.beginPath();
            c.arc(x, y, 4, 0, 7);
            c.fill();
            text_at(c, "v" + i, x + 12, y - 8, css("accent"), 12);
        });
        if (p.setup && /^e\d$/.test(layer)) {
            const edge = Number(layer[1]), order = p.setup.order;
            const ends = [corners[order[edge]], corners[order[(edge + 1) % 3]]];
            c.strokeStyle = css("text");
            c.lineWidth = 4;
            c.beginPath();
            c.moveTo(...at(...ends[0]));
            c.lineTo(...at(...ends[1]));
            c.stroke();
        }
    }
    c.lineWidth = 3;
    c.strokeStyle = css("pane");
    c.strokeRect(...at(state.pixel[0], state.pixel[1]), s, s);
    c.strokeStyle = css("text");
    c.lineWidth = 2;
    c.strokeRect(...at(state.pixel[0], state.pixel[1]), s, s);
    document.getElementById("grid-text").textContent = describe_grid(t, piece);
}

/** The layer that is shown: the reader's choice, or what the stage is about. */
function grid_layer() {
    if (state.predict && !state.answered) return "picture";
    if (grid.chosen) return grid.layer;
    const stage = stages[state.s];
    if (stage === "coverage") return "inside";
    if (stage === "interpolate") return "weights";
    return stage === "setup" ? "inside" : stage === "depth" ? "owner" : "picture";
}

function text_at(c, text, x, y, color, size, halo = true) {
    c.font = `600 ${size}px system-ui, sans-serif`;
    c.textAlign = "center";
    c.textBaseline = "middle";
    if (halo) {
        c.lineWidth = 3;
        c.strokeStyle = css("pane");
        c.strokeText(text, x, y);
    }
    c.fillStyle = color;
    c.fillText(text, x, y);
    c.textAlign = "start";
    c.textBaseline = "alphabetic";
}

/** Pixels that differ, in orange with a sign. */
function mark_apart(c, at, s, apart) {
    if (!apart) return;
    const [x0, y0, width] = data.pictures.rect;
    apart.differ.forEach((differs, i) => {
        if (!differs) return;
        const [x, y] = at(x0 + i % width, y0 + Math.floor(i / width));
        if (x < -s || y < -s || x > grid_canvas.clientWidth || y > grid_canvas.clientHeight) return;
        c.fillStyle = `rgb(${css("bad-rgb")})`;
        c.fillRect(x, y, Math.max(s, 1), Math.max(s, 1));
        if (s >= 10) text_at(c, "≠", x + s / 2, y + s / 2, css("pane"), Math.min(s * 0.6, 16), false);
    });
}

const corner_colors = [[30, 110, 230], [235, 110, 10], [150, 70, 220]];
/** The weights of the corners v0, v1, v2 at a pixel, mixed as colours and as numbers. */
function draw_weights(c, [x0, y0], s, f, piece) {
    if (!f || !f.detailed) return;
    const weights = [0, 0, 0];
    piece.setup.order.forEach((k, i) => { weights[k] = f.weights[i]; });
    c.fillStyle = `rgb(${[0, 1, 2].map(i => Math.round(weights.reduce((sum, w, k) => sum + Math.min(Math.max(w, 0), 1) * corner_colors[k][i], 0))).join(",")})`;
    c.fillRect(x0, y0, s, s);
    if (s >= 38) weights.forEach((w, k) => text_at(c, w.toFixed(2), x0 + s / 2, y0 + s * (0.22 + 0.28 * k), "#fff", Math.min(s * 0.24, 12), false));
}
/** The stored depth, light near and dark far over the grid's own range. */
const depth_range = (() => {
    const depths = data.fragments.filter(f => f.passed).map(f => f.z);
    return depths.length ? [Math.min(...depths), Math.max(...depths)] : [0, 1];
})();
function draw_depth(c, [x0, y0], s, f) {
    const grey = f ? Math.round(230 - 190 * (f.z - depth_range[0]) / ((depth_range[1] - depth_range[0]) || 1)) : 0;
    c.fillStyle = `rgb(${grey},${grey},${grey})`;
    c.fillRect(x0, y0, s, s);
    if (s >= 34) text_at(c, f ? f.z.toFixed(3) : "1", x0 + s / 2, y0 + s / 2, grey > 128 ? "#000" : "#fff", Math.min(s * 0.26, 12), false);
}

function draw_pixel(c, [x0, y0], s, x, y, layer, piece, t) {
    const middle = [x0 + s / 2, y0 + s / 2];
    const edges = piece && edges_at(piece, x, y);
    const cover = color => { c.fillStyle = color; c.fillRect(x0, y0, s, s); };
    const fragments = fragments_at(x, y), winner = [...fragments].reverse().find(f => f.passed);
    if (layer === "weights" && piece && piece.setup) return draw_weights(c, [x0, y0], s, fragment_of(t, t.pieces.indexOf(piece), x, y), piece);
    if (layer === "depth") return draw_depth(c, [x0, y0], s, winner);
    if (layer === "owner" || layer === "count") {
        cover(css("pane"));
        if (layer === "count") {
            cover(`rgba(${css("good-rgb")},${Math.min(fragments.length * 0.18, 0.9)})`);
            if (s >= 14) text_at(c, String(fragments.length), ...middle, css("text"), Math.min(s * 0.5, 15));
        } else if (winner) {
            cover(`hsl(${winner.triangle * 137.5 % 360} 45% ${document.documentElement.dataset.dark === "yes" ? 32 : 78}%)`);
            if (s >= 22) text_at(c, String(winner.triangle), ...middle, css("text"), Math.min(s * 0.34, 12), false);
        }
        return;
    }
    if (/^(inside|e\d)$/.test(layer) && edges) {
        cover(css("pane"));
        const k = layer === "inside" ? -1 : Number(layer[1]);
        if (k >= 0) {
            cover(heat(edges[k], largest_value(piece, k)));
            if (s >= 52) text_at(c, short_text(edges[k]), middle[0], middle[1] + s * 0.28, css("text"), 10);
            if (s >= 12) text_at(c, edges[k] > 0 ? "+" : edges[k] < 0 ? "−" : "0", ...middle, css("text"), Math.min(s * 0.6, 18));
        } else {
            const inside = covered_by(piece, edges), tie = edges.some(e => e === 0) && edges.every(e => e >= 0);
            cover(`rgba(${inside ? css("good-rgb") : css("bad-rgb")},${inside ? 0.5 : 0.14})`);
            if (s >= 30) {
                const signs = edges.map(e => (e > 0 ? "+" : e < 0 ? "−" : "0")).join("");
                text_at(c, signs, ...middle, css("text"), Math.min(s * 0.3, 14));
            } else if (s >= 9) text_at(c, tie ? "0" : inside ? "+" : "−", ...middle, css("text"), s * 0.5);
        }
        return;
    }
    if (s >= 10) {
        c.fillStyle = css("text");
        c.strokeStyle = css("pane");
        c.lineWidth = 2;
        c.beginPath();
        c.arc(...middle, Math.min(s * 0.08, 3), 0, 7);
        c.stroke();
        c.fill();
    }
}

function describe_grid(t, piece) {
    const [x, y] = state.pixel;
    const bytes = picture_bytes(picture_name(), x, y);
    const fragments = fragments_at(x, y);
    const passed = fragments.filter(f => f.passed);
    let text = `Pixel ${x},${y}` + (bytes ? ` is #${bytes.map(b => b.toString(16).padStart(2, "0")).join("")}.` : ".");
    text += ` ${fragments.length} triangle${fragments.length === 1 ? " covers" : "s cover"} it` +
        (passed.length ? `; triangle ${passed[passed.length - 1].triangle} is seen.` : ".");
    if (state.predict && !state.answered) return `Pixel ${x},${y}.`;
    const edges = piece && edges_at(piece, x, y);
    if (edges) text += ` Edge values of triangle ${t.number}: ${edges.map(short_text).join(", ")}: ${covered_by(piece, edges) ? "covered" : "not covered"}.`;
    else text += ` Triangle ${t.number} was not tested there.`;
    return text;
}

function zoom_grid(by) {
    grid.scale = Math.min(Math.max(grid.scale * by, 0.5), 120);
    draw_grid();
}
function show_pixel(scale = grid.scale) {
    Object.assign(grid, { x: state.pixel[0] + 0.5, y: state.pixel[1] + 0.5, scale });
}
function show_region() {
    const box = grid_canvas.getBoundingClientRect();
    const width = region.x1 - region.x0 + 1, height = region.y1 - region.y0 + 1;
    Object.assign(grid, { x: region.x0 + width / 2, y: region.y0 + height / 2,
        scale: Math.max(Math.min(box.width / (width + 1), box.height / (height + 1)), 1) });
}
function show_picture() {
    const box = grid_canvas.getBoundingClientRect();
    const [x, y, width, height] = data.pictures.rect;
    Object.assign(grid, { x: x + width / 2, y: y + height / 2, scale: Math.min(box.width / width, box.height / height) });
}
/** Keeps the current pixel in sight. */
function follow_pixel() {
    const box = grid_canvas.getBoundingClientRect();
    const dx = Math.abs(state.pixel[0] + 0.5 - grid.x) * grid.scale, dy = Math.abs(state.pixel[1] + 0.5 - grid.y) * grid.scale;
    if (dx > box.width / 2 - 8 || dy > box.height / 2 - 8) show_pixel();
}

function set_up_grid() {
    const select = document.getElementById("layer");
    select.innerHTML = '<option value="">what the stage is about</option>' +
        layers.map(([value, text]) => `<option value="${value}">${text}</option>`).join("");
    select.addEventListener("change", () => {
        grid.chosen = select.value !== "";
        grid.layer = select.value;
        draw_grid();
    });
    const actions = { in: () => zoom_grid(1.4), out: () => zoom_grid(1 / 1.4), focus: () => { show_pixel(40); draw_grid(); },
        region: () => { show_region(); draw_grid(); }, fit: () => { show_picture(); draw_grid(); } };
    for (const button of document.querySelectorAll("[data-grid]"))
        button.addEventListener("click", actions[button.dataset.grid]);
    let held = null, moved = false;
    grid_canvas.addEventListener("pointerdown", e => { held = [e.clientX, e.clientY]; moved = false; grid_canvas.setPointerCapture(e.pointerId); });
    grid_canvas.addEventListener("pointermove", e => {
        if (!held) return;
        const dx = e.clientX - held[0], dy = e.clientY - held[1];
        if (!moved && Math.hypot(dx, dy) < 4) return;
        moved = true;
        grid.x -= dx / grid.scale;
        grid.y -= dy / grid.scale;
        held = [e.clientX, e.clientY];
        draw_grid();
    });
    grid_canvas.addEventListener("pointerup", e => {
        held = null;
        if (moved) return;
        const box = grid_canvas.getBoundingClientRect();
        go_to_pixel(Math.floor(grid.x + (e.clientX - box.left - box.width / 2) / grid.scale),
            Math.floor(grid.y + (e.clientY - box.top - box.height / 2) / grid.scale));
    });
    grid_canvas.addEventListener("wheel", e => { e.preventDefault(); zoom_grid(e.deltaY < 0 ? 1.15 : 1 / 1.15); }, { passive: false });
}
