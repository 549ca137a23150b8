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

const output_names = ["color.r", "color.g", "color.b", "alpha", "normal.x", "normal.y", "normal.z", "triangle + 1",
    "ambient.r", "ambient.g", "ambient.b", "diffuse.r", "diffuse.g", "diffuse.b", "specular.r", "specular.g", "specular.b",
    "emission.r", "emission.g", "emission.b"];
const term = (f, first) => f.outputs.slice(first, first + 3);

function panel_fragment(t, item) {
    const { x, y } = item, f = fragment_of(t, item.piece || 0, x, y);
    if (!f.detailed) return `<p class="soft">This fragment's light was left out of the page; those nearer to pixel ${data.focus.pixel.join(",")} are in it.</p>
      <p>Its colour: ${secret(swatch(f.after))}</p>`;
    const terms = [["emission", 17], ["ambient", 8], ["diffuse", 11], ["specular", 14]];
    const sum = table("The colour is a sum", ["term", "r", "g", "b", ""],
        [...terms.map(([name, first]) => [name, ...term(f, first).map(v => secret(num(v))), secret(swatch(term(f, first)))]),
            ["<b>colour</b>", ...f.outputs.slice(0, 3).map(v => `<b>${secret(num(v))}</b>`), secret(swatch(f.outputs))]]);
    const pictures = `<div class="pictures">${["ambient", "diffuse", "specular"].map(n => crop_picture(n, n, x, y)).join("")}</div>`;
    const models = `<h3>Flat, Gouraud, Phong at this pixel</h3><div class="pictures">${["flat", "gouraud", "phong"].map(n =>
        crop_picture(n, n + (n === data.draws[t.draw].frequency ? " (in force)" : ""), x, y)).join("")}</div>
      <p class="soft">Flat lights each triangle once, Gouraud each corner, Phong each pixel. Same scene, same lights.</p>`;
    return `<h3>Pixel ${x},${y}: light on the surface</h3>${sum}${pictures}${f.shading ? light_part(f) : `<p class="soft">Gouraud shading computes light at the corners; here it only arrives as the varyings front and back, which interpolation gave.</p>`}${models}`;
}

function light_part(f) {
    const s = f.shading;
    const lights = s.lights.map(l => `<h4>Light ${l.light}: ${data.lighting.lights[l.light].kind}</h4>
      <div class="side-by-side"><div>
      ${formula(`n = ${tuple(s.n)}`)}${formula(`l = ${tuple(l.l)} <small>to the light</small>`)}${formula(`v = ${tuple(s.v)} <small>to the viewer</small>`)}${formula(`h = (l + v) / |l + v| = ${tuple(l.h)}`)}
      ${formula(`n · l = ${secret(`<b>${num(l.n_l)}</b>`)}, &nbsp; n · h = ${secret(`<b>${num(l.n_h)}</b>`)}, &nbsp; strength ${num(l.strength)}`)}
      ${formula(`${data.draws[f.draw].reflectance} gives: diffuse ${secret(num(l.diffuse[0]))}, highlight ${secret(num(l.specular[0]))}`)}</div>
      <div class="pictures">${state.predict && !state.answered ? "" : vector_picture(s, l)}</div></div>`).join("");
    const c = ["r", "g", "b"].map((name, k) => [name,
        secret(`${operand(s.ambient[k])} · ${operand(s.ka[k])} = <b>${num(f.outputs[8 + k])}</b>`),
        secret(`${operand(s.sum_diffuse[k])} · ${operand(s.kd[k])} = <b>${num(f.outputs[11 + k])}</b>`),
        secret(`${operand(s.sum_specular[k])} · ${operand(s.ks[k])} = <b>${num(f.outputs[14 + k])}</b>`)]);
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

const blend_words = { off: "the new colour replaces the old", source_over: "source · α + old · (1 − α), in 8 bits", additive: "source + old, in 8 bits" };

function panel_blend(t, item) {
    const { x, y } = item, f = fragment_of(t, item.piece || 0, x, y), draw = data.draws[t.draw];
    if (!f.detailed) return `<p>Stored: ${secret(swatch(f.after))}</p><p class="soft">The colours before were left out of the page.</p>`;
    const rows = ["red", "green", "blue", "alpha"].map((name, k) => [name, num(f.source[k]), num(f.bytes[k]), num(byte(f.before[k])), secret(`<b>${num(byte(f.after[k]))}</b>`)]);
    return `<h3>Pixel ${x},${y}: what is stored</h3>
      <p>Blending is <b>${draw.blend.replace("_", " ")}</b>: ${blend_words[draw.blend]}.</p>
      ${formula("byte = round(255 · clamp(value, 0, 1)), halves to even")}
      ${table("Channels", ["channel", "the shader's colour", "as a byte", "stored before", "stored after"], rows)}
      <div class="pictures swatches"><figure><span class="big" style="background:${hex(f.before)}"></span><figcaption>before<br><code>${hex(f.before)}</code></figcaption></figure>
      <figure><span class="big" style="background:${hex(f.source)}"></span><figcaption>source<br><code>${hex(f.source)}</code></figcaption></figure>
      <figure><span class="big" style="background:${state.predict && !state.answered ? "none" : hex(f.after)}"></span><figcaption>after<br><code>${secret(hex(f.after))}</code></figcaption></figure></div>
      ${f === [...fragments_at(x, y)].reverse().find(g => g.passed) ? `<p>${yes("last to write this pixel: the picture shows it")}</p>` : `<p>${no("a later triangle covers this one")}</p>`}`;
}
