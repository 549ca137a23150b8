// state.js: where the reader is (triangle, stage, item), how steps go, and the address that names a step.

const level_names = ["draw", "triangle", "stage", "pixel"];
const state = { t: 0, s: 0, i: 0, pixel: [...data.focus.pixel], level: 2, predict: false };

const item_cache = new Map();

/** The steps within a stage of a triangle: corners, planes, pieces or pixels. Never empty. */
function items_of(t, s) {
    const key = t * 16 + s;
    if (!item_cache.has(key)) {
        const items = make_items(data.triangles[t], stages[s]);
        item_cache.set(key, items.length ? items : [{}]);
    }
    return item_cache.get(key);
}
function make_items(t, stage) {
    const pieces = t.pieces || [];
    const per_piece = make => pieces.flatMap((piece, number) => make(piece, number));
    const pixels = wanted => data.fragments.filter(f => f.triangle === t.number && wanted(f))
        .map(f => ({ piece: f.piece, x: f.x, y: f.y }));
    switch (stage) {
        case "vertex": return t.corners.map((_, corner) => ({ corner }));
        case "clip": return (t.planes || []).map((_, plane) => ({ plane }));
        case "project": return per_piece((_, piece) => [0, 1, 2].map(corner => ({ piece, corner })));
        case "cull":
        case "setup": return per_piece((_, piece) => [{ piece }]);
        case "coverage": return per_piece((p, piece) => {
            if (!p.setup) return [];
            const [x0, y0, width, height] = p.setup.coverage.rect;
            return Array.from({ length: width * height }, (_, k) =>
                ({ piece, x: x0 + k % width, y: y0 + Math.floor(k / width) }));
        });
        case "depth": return pixels(() => true);
        case "interpolate":
        case "fragment":
        case "blend": return pixels(f => f.passed);
    }
    return [];
}

const is_pixel_stage = s => s >= first_pixel_stage;

/** The current item; in a stage of pixels that this triangle does not reach there, the pixel alone. */
function current_item() {
    if (state.i >= 0) return items_of(state.t, state.s)[state.i];
    return { piece: 0, x: state.pixel[0], y: state.pixel[1] };
}
const current_triangle = () => data.triangles[state.t];
function current_piece() {
    const pieces = current_triangle().pieces || [];
    return pieces[current_item().piece || 0];
}

/** The same corner, piece or pixel in another stage or triangle; a pixel that is not among the items stays. */
function keep_place(old) {
    const items = items_of(state.t, state.s);
    if (is_pixel_stage(state.s)) {
        state.i = items.findIndex(item => item.x === state.pixel[0] && item.y === state.pixel[1]);
        return;
    }
    const same = items.findIndex(item => item.corner === old.corner && (item.piece || 0) === (old.piece || 0));
    state.i = Math.max(same, 0);
}
function go(t, s, i) {
    const old = current_item();
    state.t = t;
    state.s = s;
    if (i === undefined) keep_place(old);
    else state.i = i;
    const item = current_item();
    if (item.x !== undefined) state.pixel = [item.x, item.y];
    update();
}

/** Where a step of a level leads, or null at the end. */
function neighbour(level, by) {
    const { t, s, i } = state;
    const last = data.triangles.length - 1;
    if (level === 3) {
        const to = i + by;
        if (to >= 0 && to < items_of(t, s).length) return { t, s, i: to };
        let next_s = s + by, next_t = t;
        if (next_s < 0 || next_s >= stages.length) next_t += by, next_s = by > 0 ? 0 : stages.length - 1;
        if (next_t < 0 || next_t > last) return null;
        return { t: next_t, s: next_s, i: by > 0 ? 0 : items_of(next_t, next_s).length - 1 };
    }
    if (level === 2) {
        if (s + by >= 0 && s + by < stages.length) return { t, s: s + by };
        if (t + by < 0 || t + by > last) return null;
        return { t: t + by, s: by > 0 ? 0 : stages.length - 1 };
    }
    if (level === 1) return t + by < 0 || t + by > last ? null : { t: t + by, s };
    const draw = data.triangles[t].draw;
    const others = data.triangles.map((other, k) => k).filter(k => data.triangles[k].draw === draw + by);
    return others.length ? { t: others[0], s } : null;
}
function step(by, level = state.level) {
    const to = neighbour(level, by);
    if (to) go(to.t, to.s, to.i);
    else say(by > 0 ? "This is the last step." : "This is the first step.");
}
function change_level(by) {
    state.level = Math.min(Math.max(state.level + by, 0), 3);
    update();
}

/** A click on a pixel, or a step up or down. */
function go_to_pixel(x, y) {
    if (x < 0 || y < 0 || x >= data.view.width || y >= data.view.height) return;
    if (!in_region(x, y)) {
        say(`Pixel ${x},${y} is not in this page. To get one: ${data.command} --pixel ${x},${y}`);
        return;
    }
    state.pixel = [x, y];
    if (is_pixel_stage(state.s)) keep_place({});
    else { state.s = first_pixel_stage; keep_place({}); }
    update();
}

/** The address of a step: #triangle=41&stage=coverage&pixel=120,88 */
function address() {
    const item = current_item();
    const parts = ["draw=" + current_triangle().draw, "triangle=" + current_triangle().number, "stage=" + stages[state.s]];
    if (item.piece) parts.push("piece=" + item.piece);
    if (item.corner !== undefined) parts.push("corner=" + item.corner);
    if (item.plane !== undefined) parts.push("plane=" + current_triangle().planes[item.plane].plane);
    parts.push("pixel=" + state.pixel.join(","));
    return "#" + parts.join("&");
}
function restore(hash) {
    const words = new Map(hash.replace(/^#/, "").split("&").map(part => part.split("=")));
    const whole = name => (/^\d+$/.test(words.get(name) || "") ? Number(words.get(name)) : undefined);
    if (words.has("triangle")) {
        const found = triangle_index.get(whole("triangle"));
        if (found === undefined) {
            say(`Triangle ${words.get("triangle")} is not in this page. To get it: ${data.command} --triangle ${words.get("triangle")}`);
        } else state.t = found;
    }
    const s = stages.indexOf(words.get("stage"));
    if (s >= 0) state.s = s;
    const at = /^(\d+),(\d+)$/.exec(words.get("pixel") || "");
    if (at && in_region(Number(at[1]), Number(at[2]))) state.pixel = [Number(at[1]), Number(at[2])];
    const t = current_triangle();
    const plane = (t.planes || []).findIndex(p => p.plane === words.get("plane"));
    const items = items_of(state.t, state.s);
    state.i = items.findIndex(item =>
        (item.piece || 0) === (whole("piece") || 0) &&
        (item.x === undefined || (item.x === state.pixel[0] && item.y === state.pixel[1])) &&
        (item.corner === undefined || item.corner === (whole("corner") || 0)) &&
        (item.plane === undefined || item.plane === Math.max(plane, 0)));
    if (state.i < 0 && !is_pixel_stage(state.s)) state.i = 0;
}

/** Why the pipeline did not get to this step; empty if it did. */
function not_reached(t, s, item) {
    const stage = stages[s];
    if (s <= stages.indexOf("assemble")) return "";
    if (t.bad_index) return "the triangle names a vertex that does not exist, so assembly dropped it";
    if (stage === "clip") return "";
    if (t.clip === "not_finite") return "a corner's clip position is no finite number, so clipping dropped the triangle";
    if (t.clip === "outside") return "the triangle lies wholly outside one clip plane";
    if (!t.pieces.length) return "clipping left nothing of the triangle";
    if (s <= stages.indexOf("cull")) return "";
    const piece = t.pieces[item.piece || 0];
    if (piece.verdict === "culled") return "the triangle was culled: it shows the side that is left out";
    if (piece.verdict === "zero_area") return "the triangle has no area on the subpixel grid";
    if (stage === "setup") return "";
    if (item.x === undefined) {
        const where = piece.setup.covered === 0 ? "it covers no pixel centre" : "none of its pixels is in the grid";
        return stage === "coverage" || piece.setup.covered === 0 ? where : "no pixel of the grid got this far";
    }
    const edges = edges_at(piece, item.x, item.y);
    if (!edges) return "the pixel lies outside the triangle's bounding box";
    if (stage === "coverage") return "";
    if (!covered_by(piece, edges)) return "the triangle does not cover this pixel's centre";
    const fragment = fragment_of(t, item.piece || 0, item.x, item.y);
    if (stage === "depth" || !fragment) return "";
    return fragment.passed ? "" : "the fragment failed the depth test";
}
