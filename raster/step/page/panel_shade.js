// panel_shade.js: the numbers of fragment and blend.

/** A piece of an embedded picture around the current pixel, enlarged, with the pixel framed. */
function crop_picture(name, caption, x, y, across = 41) {
    const [x0, y0, width, height] = data.pictures.rect;
    const bytes = picture_bytes(name, x, y);
    const text = bytes ? "#" + bytes.map(b => b.toString(16).padStart(2, "0")).join("") : "outside";
    const down = Math.round(across * 0.75);
    return `<figure><svg viewBox="0 0 ${across} ${down}" class="crop" role="img" aria-label="${caption} around the pixel">
      <image href="${data.pictures[name]}" x="${(across - 1) / 2 - (x - x0)}" y="${(down - 1) / 2 - (y - y0)}" width="${width}" height="${height}"/>
      <rect x="${(across - 1) / 2 - 0.3}" y="${(down - 1) / 2 - 0.3}" width="1.6" height="1.6" class="halo"/><rect x="${(across - 1) / 2 - 0.3}" y="${(down - 1) / 2 - 0.3}" width="1.6" height="1.6" class="ring"/></svg>
      <figcaption>${caption}<br><span class="swatch" style="background:${text}"></span><code>${secret(text)}</code></figcaption></figure>`;
}

function panel_fragment(t, item) {
    const { x, y } = item, f = fragment_of(t, item.piece || 0, x, y), draw = data.draws[t.draw];
    if (!f.detailed) return `<p class="soft">This fragment's light was left out of the page; those nearer to pixel ${data.focus.pixel.join(",")} are in it.</p>
      <p>Its colour: ${secret(after_swatch(f))}</p>`;
    const terms = terms_of(f);
    const rows = !terms ? [] : Object.entries(terms).map(([name, values]) => [name, ...values.map(v => secret(num(v))), secret(swatch(values))]);
    const sum = table(terms ? "The colour is a sum" : "The colour", [terms ? "term" : "", "r", "g", "b", ""],
        [...rows, ["<b>colour</b>", ...f.outputs.slice(0, 3).map(v => `<b>${secret(num(v))}</b>`), secret(swatch(f.outputs))]]);
    const pictures = `<div class="pictures">${["ambient", "diffuse", "specular"].map(n => crop_picture(n, n, x, y)).join("")}</div>`;
    const models = `<h3>Flat, Gouraud, Phong at this pixel</h3><div class="pictures">${["flat", "gouraud", "phong"].map(n =>
        crop_picture(n, n + (n === draw.frequency ? " (in force)" : ""), x, y)).join("")}</div>
      <p class="soft">Flat lights each triangle once, Gouraud each corner, Phong each pixel. Same scene, same lights.</p>`;
    return `<h3>Pixel ${x},${y}: light on the surface</h3>${sum}${pictures}${f.shading ? light_part(f.shading, draw) : gouraud_part(t, item, f)}${models}`;
}

/** Gouraud shading: the light of the three corners, how much of each is here, and where each corner's light comes from. */
function gouraud_part(t, item, f) {
    const piece = t.pieces[item.piece || 0], order = piece.setup.order, draw = data.draws[t.draw];
    const plain = draw.level === "plain", first = plain || piece.front_facing ? 0 : 6;
    const names = plain ? ["colour r", "g", "b"] : ["diffuse r", "g", "b", "specular r", "g", "b"];
    const of_corner = k => (piece.varyings || t.corners.map(v => v.varyings))[k].slice(first, first + names.length);
    const rows = order.map((k, i) => [`v${k}`, num(f.weights[i]), ...of_corner(k).map(num)]);
    const corners = t.corners.map((v, k) => v.shading ? `<details><summary>Corner v${k}: its light</summary>${light_part(v.shading, draw)}</details>` : "").join("");
    return `<h3>Gouraud: lit at the corners, interpolated here</h3>
      ${table(plain ? "The corners' colours and their weights at this pixel" : "The corners' light and its weight at this pixel", ["corner", "weight", ...names],
        [...rows, ["<b>here</b>", "", ...f.varyings.slice(first, first + names.length).map(v => secret(`<b>${num(v)}</b>`))]])}
      ${formula(order.map((k, i) => `${num(f.weights[i])} · ${operand(of_corner(k)[0])}`).join(" + ") + ` = ${secret(`<b>${num(f.varyings[first])}</b>`)} <small>${names[0]}</small>`)}
      <p class="soft">${plain ? "No light was computed at this pixel: the vertex shader summed ambient, diffuse and specular at each corner."
        : "Light arrives here; the material's colours multiply it at the pixel."}${piece.varyings ? " Clipping made corners of this piece; their light was interpolated along the edges that were cut. Below is that of the triangle's own corners." : ""}</p>${corners}`;
}

/** (n . h)^p or (r . v)^p with its numbers, where the highlight is such a power. */
function power_formula(draw, l) {
    const [name, base, p] = draw.n_h_power !== undefined ? ["n · h", l.n_h, draw.n_h_power] : ["r · v", l.r_v, draw.r_v_power];
    if (p === undefined) return "";
    return formula(`highlight: (${name})<sup>${num(p)}</sup> = ${secret(operand(base))}<sup>${num(p)}</sup> = <b>${secret(num(l.specular[0]))}</b>${l.n_l <= 0 ? " <small>since n · l is not above 0</small>" : ""}`);
}

function light_part(s, draw) {
    const lights = s.lights.map(l => `<h4>Light ${l.light}: ${data.lighting.lights[l.light].kind}</h4>
      <div class="side-by-side"><div>
      ${formula(`n = ${tuple(s.n)}`)}${formula(`l = ${tuple(l.l)} <small>to the light</small>`)}${formula(`v = ${tuple(s.v)} <small>to the viewer</small>`)}${formula(`h = (l + v) / |l + v| = ${tuple(l.h)}`)}
      ${formula(`n · l = ${secret(`<b>${num(l.n_l)}</b>`)}, &nbsp; n · h = ${secret(`<b>${num(l.n_h)}</b>`)}, &nbsp; strength ${num(l.strength)}`)}${power_formula(draw, l)}
      ${formula(`${draw.reflectance} gives: diffuse ${secret(num(l.diffuse[0]))}, highlight ${secret(num(l.specular[0]))}`)}</div>
      <div class="pictures">${state.predict && !state.answered ? "" : vector_picture(s, l)}</div></div>`).join("");
    const c = ["r", "g", "b"].map((name, k) => [name,
        secret(`${operand(s.ambient[k])} · ${operand(s.ka[k])} = <b>${num(s.terms.ambient[k])}</b>`),
        secret(`${operand(s.sum_diffuse[k])} · ${operand(s.kd[k])} = <b>${num(s.terms.diffuse[k])}</b>`),
        secret(`${operand(s.sum_specular[k])} · ${operand(s.ks[k])} = <b>${num(s.terms.specular[k])}</b>`)]);
    return `<h3>Where the terms come from${s.where === "centroid" ? ": flat shading lights the triangle's centroid" : ""}</h3>
      <p class="soft">In eye space, at (${s.position_eye.map(num).join(", ")}).</p>${lights}
      ${table("Light times material", ["", "ambient: I<sub>a</sub> k<sub>a</sub>", "diffuse: (Σ lights) k<sub>d</sub>", "specular: (Σ lights) k<sub>s</sub>"], c)}
      ${s.agrees ? "" : `<p>${no("these differ from the shader's own bits")}</p>`}`;
}

/** n, l, v and h in the plane that n and l span, seen from the side. */
function vector_picture(s, l) {
    const up = s.n, side = unit(minus(l.l, s.n.map(c => c * l.n_l)));
    const to = v => [110 + 85 * dot(v, side), 120 - 85 * dot(v, up)];
    const arrow = (v, name, kind) => {
        const [x, y] = to(v);
        return `<line x1="110" y1="120" x2="${x}" y2="${y}" class="vector ${kind}"/><circle cx="${x}" cy="${y}" r="3" class="${kind}"/><text x="${x + 5}" y="${y - 3}">${name}</text>`;
    };
    return `<figure><svg viewBox="0 0 220 150" class="small" role="img" aria-label="The vectors n, l, v and h seen along the surface">
      <line x1="10" x2="210" y1="120" y2="120" class="surface"/>${arrow(s.n, "n", "good")}${arrow(l.l, "l", "bad")}${arrow(s.v, "v", "plain")}${arrow(l.h, "h", "soft")}</svg>
      <figcaption>seen from the side of n and l; v and h may lean towards you</figcaption></figure>`;
}

const stored_as = is_plain ? "in 8 bits" : "in floats";
const blend_words = { off: "the new colour replaces the old", source_over: `source · α + old · (1 − α), ${stored_as}`, additive: `source + old, ${stored_as}` };

function panel_blend(t, item) {
    const { x, y } = item, f = fragment_of(t, item.piece || 0, x, y), draw = data.draws[t.draw];
    if (!f.detailed) return `<p>Stored: ${secret(after_swatch(f))}</p><p class="soft">The colours before were left out of the page.</p>`;
    const hidden = state.predict && !state.answered;
    const channels = ["red", "green", "blue", "alpha"];
    const bytes = () => formula("byte = round(255 · clamp(value, 0, 1)), halves to even") +
        table("Channels", ["channel", "the shader's colour", "as a byte", "stored before", "stored after"],
            channels.map((name, k) => [name, num(f.source[k]), num(f.bytes[k]), num(byte(f.before[k])), secret(`<b>${num(byte(f.after[k]))}</b>`)]));
    const light = () => `<p>The target keeps light as floats; ${display_words}:</p>` +
        formula("byte = round(255 · clamp(encoded light, 0, 1)), halves to even") +
        table("Channels", ["channel", "the shader's light", "stored before", "stored after", "byte on the screen"],
            channels.slice(0, 3).map((name, k) => [name, num(f.source[k]), num(f.before[k]), secret(`<b>${num(f.after[k])}</b>`), secret(`<b>${num(f.shown[k])}</b>`)]));
    const patch_of = (name, color, text) => `<figure><span class="big" style="background:${color}"></span><figcaption>${name}<br>${text ? `<code>${text}</code>` : ""}</figcaption></figure>`;
    const bytes_text = color => (is_plain ? hex(color) : "");
    return `<h3>Pixel ${x},${y}: what is stored</h3>
      <p>Blending is <b>${draw.blend.replace("_", " ")}</b>: ${blend_words[draw.blend]}.</p>${is_plain ? bytes() : light()}
      <div class="pictures swatches">${patch_of("before", hex(f.before), bytes_text(f.before))}${patch_of("source", hex(f.source), bytes_text(f.source))}
      ${patch_of("after", hidden ? "none" : after_hex(f), secret(after_hex(f)))}</div>
      ${f === [...fragments_at(x, y)].reverse().find(g => g.passed) ? `<p>${yes("last to write this pixel: the picture shows it")}</p>` : `<p>${no("a later triangle covers this one")}</p>`}`;
}
