// panel_raster.js: the numbers of setup, coverage, depth and interpolate.

const edge_name = (setup, k) => `v${setup.order[k]} → v${setup.order[(k + 1) % 3]}`;
const kind_of_edge = e => (e.step_x > 0 ? "left" : e.step_x < 0 ? "right" : e.step_y < 0 ? "bottom" : "top");

function panel_setup(t, item) {
    const piece = t.pieces[item.piece], s = piece.setup, draw = data.draws[t.draw];
    const edges = s.edges.map((e, k) => [edge_name(s, k), num(e.step_x), num(e.step_y), num(e.origin), kind_of_edge(e),
        secret(e.opengl ? yes("owned") : no("not owned")), secret(e.direct3d ? yes("owned") : no("not owned"))]);
    const plane_row = (name, p) => [name, num(p[0]), num(p[1]), num(p[2])];
    const planes = [plane_row("depth z", s.depth), plane_row("1/w", s.oow), ...s.planes.map((p, k) => plane_row(`<code>${draw.varyings[k]}</code> / w`, p))];
    const [x0, y0, x1, y1] = s.box;
    return `<h3>Three edge functions</h3>
      ${formula("e(px, py) = origin + 256 · (step<sub>x</sub> · px + step<sub>y</sub> · py), at the centre of pixel (px, py)")}
      ${s.order[0] ? "<p>The corners run clockwise, so v0 and v1 are exchanged: the inside is left of every edge.</p>" : ""}
      ${table("Who owns a pixel centre that lies exactly on the edge", ["edge", "step<sub>x</sub> = y<sub>b</sub> − y<sub>a</sub>", "step<sub>y</sub> = x<sub>a</sub> − x<sub>b</sub>", "origin", "this is a", "OpenGL (left, bottom)", "Direct3D (left, top)"], edges)}
      <p class="soft">In force: ${draw.fill_rule === "opengl" ? "OpenGL's rule, left and bottom edges own their points" : "Direct3D's rule, left and top edges own their points"}.</p>
      <h3>Its bounding box</h3>
      <p>Pixels ${secret(`${num(x0)} to ${num(x1)} across, ${num(y0)} to ${num(y1)} down`)}: ${secret(num(s.tested))} are tested, ${secret(num(s.covered))} covered, ${secret(num(s.passed))} pass the depth test.</p>
      <h3>A plane for each value</h3>
      ${formula("value(px, py) = dady · py + (dadx · px + origin)")}
      ${table("Planes", ["value", "origin", "dadx", "dady"], planes)}`;
}

function heat_picture(piece, k) {
    const [x0, y0, width, height] = piece.setup.coverage.rect;
    const largest = largest_value(piece, k), cells = [];
    for (let y = 0; y < height; ++y)
        for (let x = 0; x < width; ++x) {
            const value = piece.setup.coverage.values[k][y * width + x];
            cells.push(`<rect x="${x}" y="${y}" width="1.02" height="1.02" fill="${heat(value, largest)}"/>`);
            if (width <= 26) cells.push(`<text x="${x + 0.5}" y="${y + 0.7}" class="sign">${value > 0 ? "+" : value < 0 ? "−" : "0"}</text>`);
        }
    const [px, py] = [state.pixel[0] - x0, state.pixel[1] - y0];
    return `<figure><svg viewBox="-0.1 -0.1 ${width + 0.2} ${height + 0.2}" class="heat" role="img" aria-label="Signs of edge ${k} around the pixel">${cells.join("")}
      <rect x="${px}" y="${py}" width="1" height="1" class="here"/></svg><figcaption>e<sub>${k}</sub>: ${edge_name(piece.setup, k)}</figcaption></figure>`;
}

function panel_coverage(t, item) {
    const piece = t.pieces[item.piece || 0], s = piece.setup;
    const { x, y } = item, edges = edges_at(piece, x, y);
    const sign = e => (e > 0 ? yes("inside") : e < 0 ? no("outside") : '<span class="tie">0 tie</span>');
    const rows = edges.map((e, k) => [`e<sub>${k}</sub> <small>${edge_name(s, k)}</small>`, `${operand(s.edges[k].origin)} + 256 · (${operand(s.edges[k].step_x)} · ${x} + ${operand(s.edges[k].step_y)} · ${y})`,
        secret(`<b>${num(e)}${e === 0 ? "*" : ""}</b>`), secret(sign(e)), e === 0 ? secret(s.edges[k].inclusive ? "owned" : "not owned") : ""]);
    const covered = covered_by(piece, edges), ties = edges.map((e, k) => k).filter(k => edges[k] === 0);
    const outcome = rule => (covered_by(piece, edges, rule) ? yes("covered") : no("not covered"));
    const tie = `<h3>Exactly on an edge: who owns it?</h3>${ties.length ? "" : '<p class="soft">No edge value is 0 here, so both rules agree. For a tie, look for a pixel marked 0.</p>'}
      ${table("The same pixel under both rules", ["rule", "owners", ...edges.map((_, k) => `e<sub>${k}</sub> is a…`), "outcome"], [["opengl", "left and bottom"], ["direct3d", "left and top"]].map(([rule, owners]) =>
        ({ current: data.draws[t.draw].fill_rule === rule, cells: [rule === "opengl" ? "OpenGL" : "Direct3D", owners, ...s.edges.map((e, k) => `${kind_of_edge(e)} edge${edges[k] === 0 ? secret(e[rule] ? ": owned" : ": not owned") : ""}`), secret(outcome(rule))] })))}`;
    return `<h3>Pixel ${x},${y}: ${secret(covered ? yes("covered") : no("not covered"))}</h3>
      ${table("Three edge functions at its centre, exact", ["edge", "origin + 256 · (step<sub>x</sub> · px + step<sub>y</sub> · py)", "value", "sign", "tie"], rows)}
      <p>Covered where all three are above 0, or 0 on an edge that owns its points.</p>
      <div class="pictures">${state.predict && !state.answered ? "" : [0, 1, 2].map(k => heat_picture(piece, k)).join("")}</div>${tie}`;
}

const compare_sign = { never: "never", less: "<", equal: "=", less_equal: "≤", greater: ">", not_equal: "≠", greater_equal: "≥", always: "always" };

/** Every triangle that touched a pixel, in the order they were drawn. */
function history_table(x, y, current) {
    const fragments = fragments_at(x, y);
    const rows = fragments.map(f => ({ current: f.triangle === current, cells: [link_to_triangle(f.triangle), num(f.z),
        `${secret(f.passed ? yes("passed") : no("failed"))} <small>${num(f.incoming)} ${compare_sign[data.draws[f.draw].depth_compare]} ${num(f.stored)}</small>`,
        f.passed ? secret(after_swatch(f)) : unreached("it failed the depth test")] }));
    const others = data.triangles.filter(t => !fragments.some(f => f.triangle === t.number)).flatMap(t => near_miss(t, x, y));
    return table(`Every fragment of pixel ${x},${y}, in submission order`, ["triangle", "z", "depth test", "colour after"], rows) +
        (others.length ? table("Looked at, and not here", ["triangle", "why"], others) : "");
}
function near_miss(t, x, y) {
    if (t.clip === "clipped" && !t.pieces.length) return [[link_to_triangle(t.number), "clipped away"]];
    for (const piece of t.pieces || []) {
        const xs = piece.window.map(w => w[0]), ys = piece.window.map(w => w[1]);
        if (x + 0.5 < Math.min(...xs) || x + 0.5 > Math.max(...xs) || y + 0.5 < Math.min(...ys) || y + 0.5 > Math.max(...ys)) continue;
        if (piece.verdict === "culled") return [[link_to_triangle(t.number), `culled: shows its ${piece.front_facing ? "front" : "back"}`]];
        const edges = edges_at(piece, x, y);
        if (!edges) continue;
        const k = edges.findIndex((e, i) => !(e > 0 || (e === 0 && piece.setup.edges[i].inclusive)));
        if (k >= 0) return [[link_to_triangle(t.number), `rejected by edge ${edge_name(piece.setup, k)}: e<sub>${k}</sub> = ${num(edges[k])}`]];
    }
    return [];
}
const link_to_triangle = number => (triangle_index.has(number)
    ? `<a href="#triangle=${number}&stage=${stages[state.s]}&pixel=${state.pixel.join(",")}">${number}</a>`
    : `<span title="not followed in this page; ${escape_html(data.command)} --triangle ${number} does">${number}°</span>`);

function panel_depth(t, item) {
    const { x, y } = item, f = fragment_of(t, item.piece || 0, x, y), d = t.pieces[item.piece || 0].setup.depth;
    const draw = data.draws[t.draw];
    const passed_last = [...fragments_at(x, y)].reverse().find(g => g.passed);
    const painted = painted_at(x, y), painter_last = painted[painted.length - 1];
    const painter = painted.length ? table("Far to near by triangle, each covers the last", ["triangle", "z at the pixel", "colour after"],
        painted.map(p => ({ current: p[2] === t.number, cells: [link_to_triangle(p[2]), num(p[3]), secret(swatch(p.slice(4)))] })))
        : '<p class="soft">The painter\'s order at this pixel was left out of the page.</p>';
    const agree = painter_last && passed_last && (painter_last[2] === passed_last.triangle
        ? yes("both show triangle " + painter_last[2]) : no(`they part: z-buffer shows ${passed_last.triangle}, painter ${painter_last[2]}`));
    const other = data.options.visibility === "painter" ? "zbuffer" : "painter";
    const apart = pictures_apart(picture_name(), other);
    const both = [[picture_name(), data.options.visibility], [other, other]].sort((a, b) => (a[1] === "zbuffer" ? -1 : b[1] === "zbuffer"));
    const side_by_side = `<h3>Both pictures, around this pixel</h3><div class="pictures">${both.map(([name, words]) =>
        crop_picture(name, words === "zbuffer" ? "z-buffer" : "painter's order", x, y, 121)).join("")}</div>
      <p>${apart ? `${num(apart.count)} of ${num(apart.pixels)} pixels differ between the two. ${apart.count ? "The pixel pane can show where: “where z-buffer and painter part”." : ""}` : ""}</p>`;
    return `<h3>Pixel ${x},${y}: ${secret(f.passed ? yes("passes") : no("fails"))}</h3>
      ${formula(`z = dady · py + (dadx · px + origin) = ${operand(d[2])} · ${y} + (${operand(d[1])} · ${x} + ${operand(d[0])}) = <b>${num(f.z)}</b>`)}
      ${formula(`as 24 bits: round(${num(f.z)} · 16 777 215) = <b>${num(f.incoming)}</b>`)}
      ${formula(`${num(f.incoming)} ${compare_sign[draw.depth_compare]} ${num(f.stored)}${f.stored === 16777215 ? " (cleared)" : ""}: ${secret(f.passed ? yes("passes; stored now") : no("fails; nothing is stored, nothing shaded"))}`)}
      <div class="side-by-side"><section><h3>Z-buffer</h3>${history_table(x, y, t.number)}</section>
      <section><h3>Painter's order</h3>${painter}<p>${agree ? secret(agree) : ""}</p></section></div>${side_by_side}`;
}

function panel_interpolate(t, item) {
    const { x, y } = item, f = fragment_of(t, item.piece || 0, x, y);
    if (!f.detailed) return `<p class="soft">This fragment's varyings were left out of the page; those nearer to pixel ${data.focus.pixel.join(",")} are in it.</p>`;
    const piece = t.pieces[item.piece || 0], order = piece.setup.order, draw = data.draws[t.draw];
    const w = order.map(k => piece.clip[k][3]);
    const weights = table("Weight of each corner", ["corner", "w", "affine (linear on the picture)", "perspective-correct"],
        order.map((k, i) => [`v${k}`, num(w[i]), num(f.affine_weights[i]), secret(`<b>${num(f.weights[i])}</b>`)]));
    const rows = f.varyings.map((value, k) => {
        const p = piece.setup.planes[k];
        return [`<code>${draw.varyings[k]}</code>`, `(${operand(p[2])} · ${y} + (${operand(p[1])} · ${x} + ${operand(p[0])})) / ${operand(f.oow)}`,
            secret(`<b>${num(value)}</b>`), num(f.affine[k])];
    });
    return `<h3>Pixel ${x},${y}: affine against perspective-correct</h3>${weights}
      <div class="pictures">${state.predict && !state.answered ? "" : weight_picture(order, f)}</div>
      <p>1/w is linear on the picture, and so is each varying divided by w. Their quotient is the varying:</p>
      ${formula(`1/w = ${num(f.oow)}`)}
      ${table("Varyings", ["varying", "(dady · py + (dadx · px + origin)) / (1/w)", "perspective-correct", "affine, which is wrong"], rows)}
      <p class="soft">The two differ where the corners' w differ. A classic mistake shows the last column.</p>`;
}

/** Two bars of weights, one above the other. */
function weight_picture(order, f) {
    const bar = (weights, y, name) => {
        let x = 0;
        return weights.map((weight, i) => {
            const part = Math.max(weight, 0) * 240, from = x;
            x += part;
            return `<rect x="${50 + from}" y="${y}" width="${part}" height="22" class="w${i}"/>` +
                (part > 24 ? `<text x="${54 + from}" y="${y + 15}" class="on">v${order[i]}</text>` : "");
        }).join("") + `<text x="0" y="${y + 15}">${name}</text>`;
    };
    return `<svg viewBox="0 0 300 60" role="img" aria-label="Weights of the corners, affine and perspective-correct">${bar(f.affine_weights, 4, "affine")}${bar(f.weights, 34, "correct")}</svg>`;
}
