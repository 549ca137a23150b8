// view3d.js: the scene pane: model, view volume, current triangle and vectors. It draws; its numbers are shown nowhere.

const scene_canvas = document.getElementById("scene");
const orbit_start = { yaw: -0.7, pitch: 0.35, zoom: 1, close: false };
const orbit = { ...orbit_start, view: "scene" };

const times = (m, v) => m.map(row => row[0] * v[0] + row[1] * v[1] + row[2] * v[2] + row[3] * v[3]);
const divided = v => v.slice(0, 3).map(c => c / v[3]);
const minus = (a, b) => a.map((c, i) => c - b[i]);
const plus = (a, b, t = 1) => a.map((c, i) => c + t * b[i]);
const dot = (a, b) => a.reduce((sum, c, i) => sum + c * b[i], 0);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = a => { const l = Math.hypot(...a) || 1; return a.map(c => c / l); };

const world_of_clip = clip => divided(times(data.view.world_from_clip, clip));
const world_of_eye = eye => times(data.view.world_from_eye, [...eye, 1]).slice(0, 3);
const clip_of_world = p => times(data.view.clip_from_eye, times(data.view.eye_from_world, [...p, 1]));

function bytes_of(base64) {
    const text = atob(base64);
    return Uint8Array.from(text, c => c.charCodeAt(0)).buffer;
}
const mesh = (() => {
    const { min, max, world_from_object } = data.mesh;
    const raw = new Uint16Array(bytes_of(data.mesh.positions));
    const positions = [];
    for (let i = 0; i < raw.length; i += 3) {
        const p = [0, 1, 2].map(k => min[k] + (max[k] - min[k]) * raw[i + k] / 65535);
        positions.push(times(world_from_object, [...p, 1]).slice(0, 3));
    }
    return { positions, triangles: new Uint16Array(bytes_of(data.mesh.triangles)) };
})();
const mesh_middle = mesh.positions.length
    ? mesh.positions.reduce((a, p) => plus(a, p, 1 / mesh.positions.length), [0, 0, 0]) : [0, 0, 0];
const eye_world = world_of_eye([0, 0, 0]);
const corner_signs = [[-1, -1], [1, -1], [1, 1], [-1, 1]];
const near_corners = corner_signs.map(([x, y]) => world_of_clip([x, y, -1, 1]));
const far_corners = corner_signs.map(([x, y]) => world_of_clip([x, y, 1, 1]));
const plane_faces = {
    left: [0, 3], right: [1, 2], bottom: [0, 1], top: [3, 2],
};
function plane_polygon(name) {
    if (name === "near") return near_corners;
    if (name === "far") return far_corners;
    const [a, b] = plane_faces[name];
    return [near_corners[a], near_corners[b], far_corners[b], far_corners[a]];
}

/** The sphere that the view from outside shows: the triangle with its surroundings, or everything. */
function framed() {
    const around = (points, factor) => {
        const middle = points.reduce((a, p) => plus(a, p, 1 / points.length), [0, 0, 0]);
        return { middle, radius: factor * Math.max(...points.map(p => Math.hypot(...minus(p, middle))), 1e-6) };
    };
    const corners = current_triangle().corners.map(v => v.world.slice(0, 3));
    if (orbit.close && corners.length === 3) return around(corners, 3);
    const eye = data.view.perspective ? [eye_world] : [];
    const reach = points => Math.max(0, ...points.map(p => Math.hypot(...minus(p, eye_world))));
    const whole = reach(far_corners) < 4 * reach(mesh.positions.length < 5000 ? mesh.positions : mesh.positions.slice(0, 5000));
    return around([...near_corners, ...eye, ...(whole ? far_corners : [...mesh.positions.slice(0, 500), mesh_middle])], 1);
}

/** A function from world space to the canvas: [x, y, depth], or null where it cannot be shown. */
function projector(width, height) {
    const size = Math.min(width, height);
    if (orbit.view === "camera") {
        const scale = Math.min(width / data.view.width, height / data.view.height) * 0.92 * orbit.zoom;
        return p => {
            const clip = clip_of_world(p);
            if (clip[3] <= 1e-6) return null;
            return [width / 2 + clip[0] / clip[3] * data.view.width / 2 * scale,
                height / 2 - clip[1] / clip[3] * data.view.height / 2 * scale, clip[3]];
        };
    }
    const { middle, radius } = orbit.view === "ndc" ? { middle: [0, 0, 0], radius: 1.75 } : framed();
    // Turned around the camera's up, so that the picture's up is up.
    const up = orbit.view === "ndc" ? [0, 1, 0] : unit(minus(near_corners[3], near_corners[0]));
    const ahead = orbit.view === "ndc" ? [0, 0, 1] : unit(minus(far_corners.reduce((a, p) => plus(a, p, 0.25), [0, 0, 0]),
        near_corners.reduce((a, p) => plus(a, p, 0.25), [0, 0, 0])));
    const side = orbit.view === "ndc" ? [1, 0, 0] : unit(cross(ahead, up));
    const [sy, cy, sp, cp] = [Math.sin(orbit.yaw), Math.cos(orbit.yaw), Math.sin(orbit.pitch), Math.cos(orbit.pitch)];
    const fitting = radius * (orbit.view === "ndc" ? 1 : 0.93);
    const scale = size * 0.5 / fitting * orbit.zoom;
    const back = orbit.view === "ndc" ? 1 : -1;
    return world => {
        let p = world;
        if (orbit.view === "ndc") {
            const clip = clip_of_world(world);
            if (clip[3] <= 1e-6) return null;
            p = divided(clip);
            p = [p[0], p[1], -p[2]];
        }
        const d = minus(p, middle);
        const x = dot(d, side), y = dot(d, up), z = back * dot(d, ahead);
        const rx = cy * x + sy * z, rz = -sy * x + cy * z;
        const ry = cp * y - sp * rz, depth = sp * y + cp * rz;
        return [width / 2 + rx * scale, height / 2 - ry * scale, -depth];
    };
}

function fit_canvas(canvas) {
    const box = canvas.getBoundingClientRect();
    const ratio = window.devicePixelRatio || 1;
    const width = Math.max(Math.round(box.width), 10), height = Math.max(Math.round(box.height), 10);
    if (canvas.width !== width * ratio || canvas.height !== height * ratio) {
        canvas.width = width * ratio;
        canvas.height = height * ratio;
    }
    const context = canvas.getContext("2d");
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    return { context, width, height };
}
const css_cache = new Map();
function css(name) {
    if (!css_cache.has(name)) css_cache.set(name, getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim());
    return css_cache.get(name);
}

function draw_scene() {
    const { context: c, width, height } = fit_canvas(scene_canvas);
    const place = projector(width, height);
    const path = (points, closed = true) => {
        const placed = points.map(place);
        if (placed.some(p => !p)) return false;
        c.beginPath();
        placed.forEach((p, i) => (i ? c.lineTo(p[0], p[1]) : c.moveTo(p[0], p[1])));
        if (closed) c.closePath();
        return true;
    };
    const line = (points, color, thickness = 1, dash = [], closed = true) => {
        if (!path(points, closed)) return;
        c.setLineDash(dash);
        c.strokeStyle = color;
        c.lineWidth = thickness;
        c.stroke();
        c.setLineDash([]);
    };
    const fill = (points, color, alpha) => {
        if (!path(points)) return;
        c.globalAlpha = alpha;
        c.fillStyle = color;
        c.fill();
        c.globalAlpha = 1;
    };
    const label = (p, text, color) => {
        const at = place(p);
        if (!at) return;
        c.font = "600 12px system-ui, sans-serif";
        c.lineWidth = 3;
        c.strokeStyle = css("pane");
        c.strokeText(text, at[0] + 6, at[1] - 6);
        c.fillStyle = color;
        c.fillText(text, at[0] + 6, at[1] - 6);
    };
    const arrow = (from, way, length, color, text) => {
        const to = plus(from, way, length);
        line([from, to], color, 2.5, [], false);
        label(to, text, color);
    };

    draw_mesh(c, place);
    for (const face of [near_corners, far_corners]) line(face, css("soft"), 1.2);
    for (let k = 0; k < 4; ++k) line([near_corners[k], far_corners[k]], css("soft"), 1.2, [], false);
    if (orbit.view === "scene" && data.view.perspective) {
        for (const corner of near_corners) line([eye_world, corner], css("soft"), 0.7, [3, 3], false);
        label(eye_world, "eye", css("text"));
        label(near_corners[3], "near", css("soft"));
        label(far_corners[2], "far", css("soft"));
    }

    const t = current_triangle(), item = current_item(), stage = stages[state.s];
    if (t.corners.length === 3) {
        const corners = t.corners.map(v => v.world.slice(0, 3));
        fill(corners, css("accent"), 0.55);
        line(corners, css("accent"), 2);
        const placed = corners.map(place).filter(Boolean);
        const spread = placed.length ? Math.max(...[0, 1].map(i => Math.max(...placed.map(p => p[i])) - Math.min(...placed.map(p => p[i])))) : 0;
        if (spread < 30 && placed.length && !t.planes?.length) {  // too small to see: a ring around it
            c.strokeStyle = css("accent");
            c.lineWidth = 1.5;
            c.beginPath();
            c.arc(placed[0][0], placed[0][1], 18, 0, 7);
            c.stroke();
            label(corners[0], " \u2002 triangle " + t.number, css("accent"));
        } else corners.forEach((p, k) => label(p, stage === "vertex" && item.corner !== k ? "" : "v" + k, css("accent")));
    }
    if (stage === "clip" && item.plane !== undefined && t.planes.length) {
        const cut = t.planes[item.plane];
        fill(plane_polygon(cut.plane), css("bad"), 0.18);
        line(plane_polygon(cut.plane), css("bad"), 1.5);
        line(cut.before.map(p => world_of_clip(p.clip)), css("bad"), 1.5, [5, 3]);
        const after = cut.after.map(p => world_of_clip(p.clip));
        if (after.length) {
            fill(after, css("good"), 0.45);
            line(after, css("good"), 2.5);
            after.forEach((p, k) => label(p, cut.after[k].t !== undefined ? "new " + k : String(k), css("good")));
        }
    }
    if (is_pixel_stage(state.s)) {
        const px = (state.pixel[0] + 0.5) / data.view.width * 2 - 1, py = 1 - (state.pixel[1] + 0.5) / data.view.height * 2;
        line([world_of_clip([px, py, -1, 1]), world_of_clip([px, py, 1, 1])], css("text"), 1, [4, 3], false);
        const f = fragment_of(t, item.piece || 0, state.pixel[0], state.pixel[1]);
        if (f && f.shading && stage === "fragment") {
            const from = world_of_eye(f.shading.position_eye);
            const length = Math.hypot(...minus(far_corners[2], far_corners[0])) * 0.25 / orbit.zoom;
            const way = v => minus(world_of_eye(v), eye_world);
            arrow(from, way(f.shading.n), length, css("good"), "n");
            arrow(from, way(f.shading.v), length, css("text"), "v");
            for (const l of f.shading.lights) {
                arrow(from, way(l.l), length, css("bad"), "l" + (f.shading.lights.length > 1 ? l.light : ""));
                arrow(from, way(l.h), length * 0.8, css("soft"), "h");
            }
        }
    }
    document.getElementById("scene-text").textContent = describe_scene(t, stage);
}

/** All triangles from far to near, plainly shaded: the setting, not the renderer's picture. */
function draw_mesh(c, place) {
    const points = mesh.positions.map(place);
    const faces = [];
    for (let i = 0; i < mesh.triangles.length; i += 3) {
        const [a, b, d] = [0, 1, 2].map(k => points[mesh.triangles[i + k]]);
        if (!a || !b || !d) continue;
        const area = (b[0] - a[0]) * (d[1] - a[1]) - (b[1] - a[1]) * (d[0] - a[0]);
        if (Math.abs(area) < 0.02) continue;
        faces.push([a[2] + b[2] + d[2], a, b, d, i]);
    }
    faces.sort((p, q) => q[0] - p[0]);
    const dark = document.documentElement.dataset.dark === "yes";
    for (const [, a, b, d, i] of faces) {
        const w = [0, 1, 2].map(k => mesh.positions[mesh.triangles[i + k]]);
        const n = unit(cross(minus(w[1], w[0]), minus(w[2], w[0])));
        const light = Math.abs(dot(n, unit([0.4, 0.8, 0.45])));
        const grey = dark ? 50 + 60 * light : 150 + 80 * light;
        c.fillStyle = c.strokeStyle = `rgb(${grey},${grey},${grey + 6})`;
        c.beginPath();
        c.moveTo(a[0], a[1]); c.lineTo(b[0], b[1]); c.lineTo(d[0], d[1]);
        c.closePath();
        c.fill();
        c.lineWidth = 0.5;
        c.stroke();
    }
}

function describe_scene(t, stage) {
    if (state.predict && !state.answered) return `Triangle ${t.number}; where it lies is for you to say.`;
    const what = { inside: "wholly inside the view volume", outside: "wholly outside the view volume",
        clipped: "partly inside the view volume", not_finite: "at no finite place" }[t.clip] || "not placed";
    let text = `Triangle ${t.number} is ${what}.`;
    if (t.corners.length === 3)
        text += " Its corners in world space: " + t.corners.map((v, k) => `v${k} (${v.world.slice(0, 3).map(short_text).join(", ")})`).join(", ") + ".";
    if (stage === "clip" && t.planes && t.planes.length) {
        const cut = t.planes[current_item().plane || 0];
        text += ` Plane ${cut.plane} makes ${cut.after.length} corners of ${cut.before.length}.`;
    }
    return text;
}

function set_up_scene() {
    for (const button of document.querySelectorAll("[data-view]"))
        button.addEventListener("click", () => {
            orbit.view = button.dataset.view;
            for (const other of document.querySelectorAll("[data-view]"))
                other.setAttribute("aria-pressed", String(other === button));
            draw_scene();
        });
    const turns = { left: () => (orbit.yaw -= 0.2), right: () => (orbit.yaw += 0.2), up: () => (orbit.pitch += 0.15),
        down: () => (orbit.pitch -= 0.15), in: () => (orbit.zoom *= 1.3), out: () => (orbit.zoom /= 1.3),
        close: () => Object.assign(orbit, { close: !orbit.close, zoom: 1 }),
        reset: () => Object.assign(orbit, orbit_start) };
    for (const button of document.querySelectorAll("[data-orbit]"))
        button.addEventListener("click", () => {
            turns[button.dataset.orbit]();
            document.querySelector("[data-orbit=close]").setAttribute("aria-pressed", String(orbit.close));
            draw_scene();
        });
    let held = null;
    scene_canvas.addEventListener("pointerdown", e => { held = [e.clientX, e.clientY]; scene_canvas.setPointerCapture(e.pointerId); });
    scene_canvas.addEventListener("pointermove", e => {
        if (!held) return;
        orbit.yaw += (e.clientX - held[0]) * 0.008;
        orbit.pitch = Math.min(Math.max(orbit.pitch + (e.clientY - held[1]) * 0.008, -1.5), 1.5);
        held = [e.clientX, e.clientY];
        draw_scene();
    });
    scene_canvas.addEventListener("pointerup", () => (held = null));
    scene_canvas.addEventListener("wheel", e => { e.preventDefault(); orbit.zoom *= e.deltaY < 0 ? 1.1 : 1 / 1.1; draw_scene(); }, { passive: false });
}
