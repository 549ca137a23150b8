// question.js: one question for each step, whose answer and reason come from what the renderer recorded.

const choice = (text, options, answer, why) => ({ kind: "choice", text, options, answer, why });
const number = (text, answer, why) => ({ kind: "number", text, answer, why });
const in_out = v => v.map((d, k) => `e${k} = ${short_text(d)}`).join(", ");

/** The question of a step, or null where there is nothing to ask. */
function question_of(t, s, item) {
    if (data.bug) return bug_question();
    if (not_reached(t, s, item)) return null;
    const piece = (t.pieces || [])[item.piece || 0];
    switch (stages[s]) {
        case "vertex": {
            const [x, y, z, w] = t.corners[item.corner].clip;
            const inside = Math.abs(x) <= w && Math.abs(y) <= w && Math.abs(z) <= w;
            return choice(`Will corner v${item.corner} (vertex ${t.corners[item.corner].vertex}) lie inside the view volume?`, ["inside", "outside"],
                inside ? "inside" : "outside", `Its clip position is (${[x, y, z, w].map(short_text).join(", ")}), and inside means −w ≤ x, y, z ≤ w.`);
        }
        case "assemble":
            return number(`Triangle ${t.number} is triangle ${t.order} of its draw. At which place of the index list does its provoking corner stand?`,
                3 * t.order + 2, `A list of triangles takes three indices each, and the last corner is the provoking one: 3 · ${t.order} + 2.`);
        case "clip": {
            if (!t.planes.length)
                return choice(`What will clipping do with triangle ${t.number}?`, ["keep it as it is", "cut it", "drop it"],
                    t.clip === "inside" ? "keep it as it is" : "drop it", t.clip === "inside" ? "All three outcodes are 0: no corner is outside of any plane."
                        : "All three corners are beyond one plane, so nothing of it can be inside.");
            const cut = t.planes[item.plane || 0];
            return number(`The polygon has ${cut.before.length} corners. How many are left after plane ${cut.plane}?`, cut.after.length,
                `${cut.before.filter(p => p.distance >= 0).length} corners have a distance of 0 or more and stay; each edge that changes sides adds one.`);
        }
        case "project": {
            const x = piece.window[item.corner][0];
            return number(`Corner v${item.corner} of triangle ${t.number} has clip x = ${short_text(piece.clip[item.corner][0])} and w = ${short_text(piece.clip[item.corner][3])}; the picture is ${data.view.width} pixels wide. In which column of pixels does the corner lie?`,
                Math.floor(x), `x / w = ${short_text(piece.ndc[item.corner][0])}, times ${short_text(data.view.scale[0])} plus ${short_text(data.view.offset[0])} is ${short_text(x)}.`);
        }
        case "cull": {
            const answer = piece.area > 0 ? "counter-clockwise" : piece.area < 0 ? "clockwise" : "no area";
            return choice(`Which way do the corners of triangle ${t.number} run on the picture?`, ["counter-clockwise", "clockwise", "no area"], answer,
                `Twice its signed area is ${short_text(piece.area)}, so it ${piece.area === 0 ? "has none" : "shows its " + (piece.front_facing ? "front" : "back")}.`);
        }
        case "setup": {
            const k = Math.abs(t.number) % 3, e = piece.setup.edges[k], owned = e[data.draws[t.draw].fill_rule];
            return choice(`Does edge ${edge_name(piece.setup, k)} own the pixel centres that lie exactly on it?`, ["yes", "no"], owned ? "yes" : "no",
                `It is a ${kind_of_edge(e)} edge, and the rule in force lets ${data.draws[t.draw].fill_rule === "opengl" ? "left and bottom" : "left and top"} edges own their points.`);
        }
        case "coverage": {
            const edges = edges_at(piece, item.x, item.y), tie = edges.some(e => e === 0);
            return choice(`Does triangle ${t.number} cover the centre of pixel ${item.x},${item.y}?`, ["covered", "not covered"],
                covered_by(piece, edges) ? "covered" : "not covered", `${in_out(edges)}. ${tie ? "A 0 counts only on an edge that owns its points." : "All three must be above 0."}`);
        }
        case "depth": {
            const f = fragment_of(t, item.piece || 0, item.x, item.y), draw = data.draws[t.draw];
            return choice(`At pixel ${item.x},${item.y} the z-buffer holds ${short_text(f.stored)}; triangle ${t.number} brings ${short_text(f.incoming)}. Does it pass the test ${compare_sign[draw.depth_compare]}?`,
                ["passes", "fails"], f.passed ? "passes" : "fails", `${short_text(f.incoming)} ${compare_sign[draw.depth_compare]} ${short_text(f.stored)} is ${f.passed}.`);
        }
        case "interpolate": {
            const f = fragment_of(t, item.piece || 0, item.x, item.y);
            if (!f.detailed) return null;
            const k = f.weights[0] === f.affine_weights[0] ? -1 : 0, order = piece.setup.order;
            const answer = k < 0 ? "the same" : f.weights[0] > f.affine_weights[0] ? "larger" : "smaller";
            return choice(`The affine weight of corner v${order[0]} at pixel ${item.x},${item.y} is ${short_text(f.affine_weights[0])}. Its perspective-correct weight is …`,
                ["larger", "smaller", "the same"], answer, `It is ${short_text(f.weights[0])}. The corners' w are ${order.map(c => `v${c}: ${short_text(piece.clip[c][3])}`).join(", ")}; nearer corners (smaller w) get more.`);
        }
        case "fragment": {
            const f = fragment_of(t, item.piece || 0, item.x, item.y);
            if (!f.detailed) return null;
            const terms = terms_of(f);
            if (!terms) {
                const corners = piece.setup.order.map((k, i) => ["v" + k, f.weights[i]]).sort((a, b) => b[1] - a[1]);
                return choice(`Gouraud shading mixes the colours of the corners. Which corner gives most at pixel ${item.x},${item.y}?`, ["v0", "v1", "v2"], corners[0][0],
                    corners.map(([name, weight]) => `${name} ${short_text(weight)}`).join(", ") + ": the weights there.");
            }
            const sums = ["ambient", "diffuse", "specular"].map(name => [name, terms[name][0] + terms[name][1] + terms[name][2]]);
            sums.sort((a, b) => b[1] - a[1]);
            if (sums[0][1] === sums[1][1]) return null;
            return choice(`Which term is the largest part of the colour at pixel ${item.x},${item.y}?`, ["ambient", "diffuse", "specular"], sums[0][0],
                sums.map(([name, sum]) => `${name} ${short_text(sum)}`).join(", ") + " (red, green and blue added).");
        }
        case "blend": {
            const f = fragment_of(t, item.piece || 0, item.x, item.y);
            if (!f.detailed || !is_plain) return null;
            return number(`The shader gives red = ${short_text(f.source[0])}, the target holds ${byte(f.before[0])}, and blending is ${data.draws[t.draw].blend.replace("_", " ")}. Which red byte is stored at pixel ${item.x},${item.y}?`,
                byte(f.after[0]), `${short_text(f.source[0])} · 255 rounded is ${f.bytes[0]}; ${blend_words[data.draws[t.draw].blend]}.`);
        }
    }
    return null;
}

/** What a question on paper must say besides, since no panel stands beside it. */
function givens_of(t, s, item) {
    const piece = (t.pieces || [])[item.piece || 0];
    const point = values => `(${values.map(short_text).join(", ")})`;
    switch (stages[s]) {
        case "vertex": {
            const rows = data.draws[t.draw].clip_from_object.map(point).join(", ");
            return `Its object position is ${point(t.corners[item.corner].attributes.slice(0, 3))}; the rows of clip_from_object are ${rows}.`;
        }
        case "clip":
            if (t.planes.length) return `Clip positions: ${t.planes[item.plane || 0].before.map(p => point(p.clip)).join(", ")}.`;
            return `Clip positions of its corners: ${t.corners.map(v => point(v.clip)).join(", ")}.`;
        case "cull": return `In subpixels, y down: ${piece.subpixel.map((p, k) => `v${k} ${point(p)}`).join(", ")}.`;
        case "setup": return `In subpixels, y down: ${piece.subpixel.map((p, k) => `v${k} ${point(p)}`).join(", ")}; the corners run counter-clockwise in the order ${piece.setup.order.map(k => "v" + k).join(", ")}.`;
        case "coverage": return piece.setup.edges.map((e, k) => `e${k} = ${short_text(e.origin)} + 256 · (${short_text(e.step_x)} · x + ${short_text(e.step_y)} · y)`).join("; ") + ".";
        case "interpolate": return `The corners' w: ${piece.setup.order.map(k => `v${k} ${short_text(piece.clip[k][3])}`).join(", ")}.`;
        case "fragment": {
            const f = fragment_of(t, item.piece || 0, item.x, item.y).shading;
            if (!f) return "";
            return `In red, green, blue: ambient light ${point(f.ambient)} on k_a ${point(f.ka)}; diffuse light ${point(f.sum_diffuse)} on k_d ${point(f.kd)}; highlight ${point(f.sum_specular)} on k_s ${point(f.ks)}.`;
        }
    }
    return "";
}

const is_right = (question, given) => (question.kind === "number" ? Number(given) === question.answer : given === question.answer);

/** The question box of predict mode. */
function draw_question() {
    const box = document.getElementById("question");
    const question = state.predict ? question_of(current_triangle(), state.s, current_item()) : null;
    if (state.predict && !question) state.answered = true;
    box.hidden = !state.predict;
    if (!state.predict) return;
    if (!question) {
        box.innerHTML = "<p>Nothing to predict at this step. Step on.</p>";
        return;
    }
    if (state.answered && state.verdict) {
        const { right, given } = state.verdict;
        box.innerHTML = `<p class="verdict ${right ? "right" : "wrong"}" role="status"><b>${right ? "+ Right" : "− Not so"}</b>: you said ${escape_html(given)}${right ? "" : `; it is <b>${short_text(question.answer)}</b>`}. ${escape_html(question.why)}</p>
          <p>${state.score.right} of ${state.score.asked} right so far. Step on for the next.</p>`;
        return;
    }
    const answers = question.kind === "choice"
        ? question.options.map(option => `<button type="submit" value="${option}">${option}</button>`).join(" ")
        : `<label>Your answer <input name="answer" inputmode="numeric" autocomplete="off" required></label> <button type="submit">Check</button>`;
    box.innerHTML = `<form><p><b>Predict:</b> ${escape_html(question.text)}</p><p class="answers">${answers} <button type="button" class="plain" id="show-answer">Show me</button></p></form>`;
    const answer = given => {
        const right = is_right(question, given);
        state.score.asked += 1;
        state.score.right += right;
        state.verdict = { right, given };
        state.answered = true;
        update(false);
    };
    box.querySelector("form").addEventListener("submit", event => {
        event.preventDefault();
        answer(question.kind === "choice" ? event.submitter.value : box.querySelector("input").value.trim().replace("−", "-"));
    });
    document.getElementById("show-answer").addEventListener("click", () => {
        state.answered = true;
        state.verdict = null;
        update(false);
    });
}
