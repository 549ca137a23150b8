// panel_geometry.js: the numbers of the stages from vertex to cull.

/** What predict mode hides until the reader has answered. */
const secret = html => (state.predict && !state.answered ? '<span class="secret" role="img" aria-label="hidden">?</span>' : html);

const table = (caption, head, rows, kind = "") => `<div class="scroll"><table class="${kind}"><caption>${caption}</caption>
  <thead><tr>${head.map(h => (h ? `<th scope="col">${h}</th>` : "<td></td>")).join("")}</tr></thead>
  <tbody>${rows.map(row => `<tr${row.current ? ' class="current"' : ""}>${(row.cells || row).map((cell, i) =>
        i === 0 && cell !== "" ? `<th scope="row">${cell}</th>` : `<td>${cell}</td>`).join("")}</tr>`).join("")}</tbody></table></div>`;
const matrix = (name, rows) => `<figure class="matrix"><figcaption>${name}</figcaption><table aria-label="${name}">${rows
    .map(row => `<tr>${row.map(v => `<td>${num(v)}</td>`).join("")}</tr>`).join("")}</table></figure>`;
const column = (name, values, soft = "") => `<figure class="matrix${soft}"><figcaption>${name}</figcaption><table aria-label="${name}">${values
    .map(v => `<tr><td>${typeof v === "string" ? v : num(v)}</td></tr>`).join("")}</table></figure>`;
const formula = html => `<p class="formula">${html}</p>`;
const unreached = why => `<span class="unreached" title="${escape_html(why)}">not reached</span>`;

/** row * vector = result, with every number. */
const row_times_vector = (name, row, v, result) =>
    `${name} = ${row.map((m, k) => `${operand(m)}·${operand(v[k])}`).join(" + ")} = ${secret(`<b>${num(result)}</b>`)}`;

function panel_vertex(t, item) {
    const v = t.corners[item.corner], draw = data.draws[t.draw];
    const object = [...v.attributes.slice(0, 3), 1];
    const piece = t.clip === "inside" ? t.pieces[0] : null;
    const gone = t.clip === "inside" ? "" : "clipping changes this triangle's corners; see the stages clip and project";
    const ndc = piece ? piece.ndc[item.corner] : null, window_position = piece ? piece.window[item.corner] : null;
    const none = unreached(gone);
    const axes = ["x", "y", "z", "w"];
    const spaces = `<div class="spaces" role="group" aria-label="One corner in every space">
      ${column("object", object)}<span class="to">world_<wbr>from_<wbr>object</span>
      ${column("world", v.world)}<span class="to">eye_<wbr>from_<wbr>world</span>
      ${column("eye", v.eye)}<span class="to">clip_<wbr>from_<wbr>eye</span>
      ${column("clip", v.clip.map(c => secret(num(c))))}<span class="to">÷ w</span>
      ${column("NDC", ndc ? ndc.map(c => secret(num(c))) : [none])}<span class="to">viewport</span>
      ${column("window", window_position ? window_position.slice(0, 3).map(c => secret(num(c))) : [none])}
    </div>`;
    const arithmetic = draw.clip_from_object.map((row, k) => formula(row_times_vector(axes[k] + "<sub>clip</sub>", row, object, v.clip[k]))).join("");
    const eye = draw.eye_from_object.map((row, k) => formula(row_times_vector(axes[k] + "<sub>eye</sub>", row, object, v.eye[k]))).join("");
    const varyings = table("What the vertex hands on", ["varying", "value"], v.varyings.map((value, k) => [`<code>${draw.varyings[k]}</code>`, num(value)]));
    return `<h3>Corner v${item.corner}: vertex ${v.vertex} of the draw, in every space</h3>${spaces}
      <p>The shader multiplies once, by clip_from_object, the product of the three matrices:</p>
      <div class="matrices">${matrix("clip_from_object", draw.clip_from_object)}${column("object", object)}<span class="to">=</span>${column("clip", v.clip.map(c => secret(num(c))))}</div>
      ${arithmetic}
      <details><summary>Step by step: the matrices</summary><div class="matrices">
        ${matrix("world_from_object", data.view.world_from_object)}${matrix("eye_from_world", data.view.eye_from_world)}${matrix("clip_from_eye", data.view.clip_from_eye)}</div>${eye}</details>
      <details><summary>Varyings</summary>${varyings}</details>`;
}

function panel_assemble(t) {
    const rows = t.vertices.map((vertex, k) => [`v${k}${k === 2 ? " (provoking)" : ""}`, num(3 * t.order + k), secret(`<b>${num(vertex)}</b>`),
        t.corners[k] ? tuple(t.corners[k].attributes.slice(0, 3)) : "there is no such vertex"]);
    return `<h3>Three indices make triangle ${t.number}</h3>
      ${formula(`triangle ${t.order} of the draw: indices 3·${t.order}, 3·${t.order} + 1, 3·${t.order} + 2`)}
      ${table("Its corners", ["corner", "place in the index list", "vertex", "object position"], rows)}
      ${t.bad_index ? `<p>${no("dropped: a vertex does not exist")}</p>` : ""}
      <p class="soft">The last corner is the provoking one: flat varyings take its value.</p>`;
}

const plane_names = ["right", "left", "top", "bottom", "near", "far"];
const plane_rules = { right: "w − x", left: "w + x", top: "w − y", bottom: "w + y", near: "w + z", far: "w − z" };

function panel_clip(t, item) {
    const verdicts = { inside: yes("inside: nothing to cut"), outside: no("outside: all corners beyond one plane"),
        not_finite: no("dropped: a corner is no finite number"), clipped: t.pieces.length ? `${yes("cut")}; ${t.pieces.length} triangle${t.pieces.length === 1 ? "" : "s"} go on` : no("cut away wholly") };
    const codes = table("Which planes each corner is inside of: distance ≥ 0", ["corner", ...plane_names.map(p => `${p}<br><small>${plane_rules[p]} ≥ 0</small>`)],
        t.corners.map((v, k) => [`v${k}`, ...plane_names.map((_, bit) => secret(t.outcodes[k] >> bit & 1 ? no("out") : yes("in")))]));
    const corners = table("Clip positions", ["corner", "x", "y", "z", "w"], t.corners.map((v, k) => [`v${k}`, ...v.clip.map(num)]));
    const union = t.outcodes[0] | t.outcodes[1] | t.outcodes[2], all = t.outcodes[0] & t.outcodes[1] & t.outcodes[2];
    let cuts = "";
    if (t.planes.length) {
        const cut = t.planes[item.plane || 0];
        const before = table(`Before plane ${cut.plane}`, ["corner", "clip position", `distance ${plane_rules[cut.plane]}`, ""],
            cut.before.map((p, k) => [String(k), tuple(p.clip), num(p.distance), p.distance >= 0 ? yes("kept") : no("cut off")]));
        const after = table(`After plane ${cut.plane}`, ["corner", "clip position", "where it comes from"],
            cut.after.map((p, k) => [String(k), secret(tuple(p.clip)), secret(p.t === undefined ? "an old corner"
                : `new, on the edge ${p.from} → ${p.to}: t = d<sub>${p.from}</sub> / (d<sub>${p.from}</sub> − d<sub>${p.to}</sub>) = ${num(cut.before[p.from].distance)} / (${num(cut.before[p.from].distance)} − ${operand(cut.before[p.to].distance)}) = <b>${num(p.t)}</b>`)]));
        const fan = t.pieces.length ? `<p>What is left after all planes is drawn as a fan: ${t.pieces.map((_, k) => `(${k + 1}, ${k + 2}, 0)`).join(", ")}.</p>` : "";
        cuts = `<h3>Plane ${cut.plane}: the polygon before and after (${(item.plane || 0) + 1} of ${t.planes.length})</h3>
          <div class="pictures">${polygon_picture(cut)}</div>${before}${after}
          ${formula("new corner = from + t · (to − from), for position and varyings alike")}${fan}`;
    }
    return `<h3>${secret(verdicts[t.clip])}</h3>${codes}
      <p class="soft">Outside of one plane with all corners: ${secret(all ? plane_names.filter((_, b) => all >> b & 1).join(", ") : "none")}.
      Planes that cut: ${secret(union && !all ? plane_names.filter((_, b) => union >> b & 1).join(", ") : "none")}.</p>${cuts}${corners}`;
}

/** The polygon against one plane, with the distance upwards: what is below the line goes. */
function polygon_picture(cut) {
    const all = [...cut.before, ...cut.after];
    const axis = /right|left/.test(cut.plane) ? 1 : 0;
    const across = p => p.clip[axis], [low, high] = [Math.min(...all.map(across)), Math.max(...all.map(across))];
    const [down, up] = [Math.min(0, ...all.map(p => p.distance)), Math.max(0, ...all.map(p => p.distance))];
    const x = p => 20 + 260 * (across(p) - low) / ((high - low) || 1), y = d => 20 + 120 * (up - d) / ((up - down) || 1);
    const points = polygon => polygon.map(p => `${x(p).toFixed(1)},${y(p.distance).toFixed(1)}`).join(" ");
    return `<svg viewBox="0 0 300 160" role="img" aria-label="The polygon before and after plane ${cut.plane}">
      <rect x="0" y="${y(0)}" width="300" height="${160 - y(0)}" class="bad-area"/>
      <polygon points="${points(cut.before)}" class="before"/><polygon points="${points(cut.after)}" class="after"/>
      <line x1="0" x2="300" y1="${y(0)}" y2="${y(0)}" class="plane"/><text x="4" y="${Math.max(y(0) - 4, 12)}">inside +</text><text x="4" y="${Math.min(y(0) + 14, 156)}">outside −</text>
      ${cut.after.map((p, k) => `<circle cx="${x(p)}" cy="${y(p.distance)}" r="3.5" class="${p.t === undefined ? "old" : "new"}"/><text x="${x(p) + 6}" y="${y(p.distance) - 4}">${k}</text>`).join("")}
    </svg>`;
}

function panel_project(t, item) {
    const piece = t.pieces[item.piece], k = item.corner;
    const clip = piece.clip[k], [x, y, z, oow] = piece.window[k], ndc = piece.ndc[k], sub = piece.subpixel[k];
    const { scale, offset } = data.view;
    const rows = piece.window.map((w, i) => ({ current: i === k, cells: [`v${i}`, ...piece.ndc[i].map(c => secret(num(c))), secret(num(w[0])), secret(num(w[1])), secret(num(w[2])), secret(num(piece.subpixel[i][0])), secret(num(piece.subpixel[i][1]))] }));
    return `<h3>Corner v${k}${t.pieces.length > 1 || t.clip === "clipped" ? ` of piece ${item.piece}` : ""}: divide, viewport, snap</h3>
      ${formula(`1/w = 1 / ${operand(clip[3])} = <b>${secret(num(oow))}</b>`)}
      ${["x", "y", "z"].map((axis, i) => formula(`${axis}<sub>NDC</sub> = ${axis} · 1/w = ${operand(clip[i])} · ${secret(num(oow))} = <b>${secret(num(ndc[i]))}</b>`)).join("")}
      ${["x", "y", "z"].map((axis, i) => formula(`${axis}<sub>window</sub> = ${secret(num(ndc[i]))} · ${operand(scale[i])} + ${operand(offset[i])} = <b>${secret(num([x, y, z][i]))}</b>`)).join("")}
      <h3>Snap to the grid of 256 × 256 subpixels</h3>
      ${formula(`x: round((${secret(num(x))} − 0.5) · 256) = <b>${secret(num(sub[0]))}</b>`)}
      ${formula(`y: round((${secret(num(y))} − 0.5) · 256) = <b>${secret(num(sub[1]))}</b>`)}
      <div class="pictures">${state.predict && !state.answered ? "" : snap_picture([x, y], sub)}</div>
      ${table("All corners", ["corner", "x NDC", "y NDC", "z NDC", "x window", "y window", "z window", "x subpixel", "y subpixel"], rows)}
      <p class="soft">Row 0 is on top, so the viewport's y scale is negative. Pixel centres are the multiples of 256: whole numbers from here on, so that coverage is exact.</p>`;
}

/** Where the corner was and where it is now, a few subpixels across. */
function snap_picture([x, y], [sx, sy]) {
    const raw = [(x - 0.5) * 256 - sx, (y - 0.5) * 256 - sy];
    const at = d => 80 + d * 50;
    const lines = [-1, 0, 1].map(k => `<line x1="${at(k)}" x2="${at(k)}" y1="0" y2="160" class="grid"/><line y1="${at(k)}" y2="${at(k)}" x1="0" x2="160" class="grid"/>`).join("");
    return `<figure><svg viewBox="0 0 160 160" class="small" role="img" aria-label="The corner moves to the nearest crossing of the subpixel grid">${lines}
      <line x1="${at(raw[0])}" y1="${at(raw[1])}" x2="${at(0)}" y2="${at(0)}" class="plane"/>
      <circle cx="${at(raw[0])}" cy="${at(raw[1])}" r="5" class="old"/><rect x="${at(0) - 5}" y="${at(0) - 5}" width="10" height="10" class="new"/></svg>
      <figcaption>round: where it was; square: where it snaps to. A line apart is 1/256 pixel.</figcaption></figure>`;
}

function panel_cull(t, item) {
    const piece = t.pieces[item.piece], draw = data.draws[t.draw], s = piece.subpixel;
    const front = piece.front_facing ? "front" : "back";
    const verdict = { kept: yes("kept"), culled: no("culled"), zero_area: no("no area: dropped") }[piece.verdict];
    const winding = piece.area > 0 ? "counter-clockwise" : piece.area < 0 ? "clockwise" : "neither way";
    const would = ["none", "back", "front"].map(rule => {
        const kept = piece.area !== 0 && rule !== front;
        return { current: rule === draw.cull, cells: [`--cull ${rule}`, secret(kept ? yes("kept") : no("dropped")), rule === draw.cull ? "in force" : ""] };
    });
    return `<h3>${secret(verdict)}: ${secret(piece.area === 0 ? "no area" : `shows its ${front}`)}</h3>
      <p>Twice the signed area, in square subpixels, exact:</p>
      ${formula(`(x<sub>0</sub> − x<sub>1</sub>)(y<sub>2</sub> − y<sub>0</sub>) − (x<sub>2</sub> − x<sub>0</sub>)(y<sub>0</sub> − y<sub>1</sub>)`)}
      ${formula(`= (${num(s[0][0])} − ${operand(s[1][0])})(${num(s[2][1])} − ${operand(s[0][1])}) − (${num(s[2][0])} − ${operand(s[0][0])})(${num(s[0][1])} − ${operand(s[1][1])}) = <b>${secret(num(piece.area))}</b>`)}
      <p>On the picture the corners run ${secret(`<b>${winding}</b>`)}; the front is ${draw.front_face.replace("_", "-")}.</p>
      ${table("It would be kept if the rule were", ["rule", "outcome", ""], would)}
      ${table("Corners", ["corner", "x subpixel", "y subpixel"], s.map((p, k) => [`v${k}`, num(p[0]), num(p[1])]))}`;
}
