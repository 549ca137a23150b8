// panels.js: the numbers pane: what the stage does, and its panel, or why it was not reached.

const stage_words = {
    vertex: ["The vertex shader turns an object position into a clip position.", "stages/vertex.h"],
    assemble: ["Three entries of the index list become a triangle.", "stages/assemble.h"],
    clip: ["What lies outside the six planes −w ≤ x, y, z ≤ w is cut off.", "stages/clip.h"],
    project: ["Division by w, the viewport, and the snap to whole subpixels.", "stages/project.h"],
    cull: ["The sign of the area tells which side we see.", "stages/cull.h"],
    setup: ["What is computed once for the triangle: edge functions and planes.", "stages/setup.h"],
    coverage: ["Is the pixel's centre inside all three edges?", "stages/coverage.h"],
    depth: ["Is it nearer than what is stored?", "stages/depth.h"],
    interpolate: ["The varyings at this pixel, by perspective.", "stages/interpolate.h"],
    fragment: ["The fragment shader turns varyings into a colour.", "stages/fragment.h"],
    blend: ["The colour meets the stored one.", "stages/blend.h"],
};
const panel_of = { vertex: panel_vertex, assemble: panel_assemble, clip: panel_clip, project: panel_project, cull: panel_cull,
    setup: panel_setup, coverage: panel_coverage, depth: panel_depth, interpolate: panel_interpolate, fragment: panel_fragment,
    blend: panel_blend };

function draw_panel() {
    const t = current_triangle(), item = current_item(), stage = stages[state.s];
    const [words, file] = stage_words[stage];
    const why = not_reached(t, state.s, item);
    let body;
    if (why) {
        body = `<p class="unreached-box"><b>Not reached</b>: ${why}.</p>`;
        const { x, y } = item;
        if (x !== undefined && t.pieces && t.pieces.some(p => edges_at(p, x, y)) && stage !== "coverage")
            body += `<p><a href="${address().replace(/stage=\w+/, "stage=coverage")}">Look at its coverage here</a></p>`;
        if (x !== undefined && fragments_at(x, y).length) body += `<h3>What did reach this pixel</h3>${history_table(x, y, t.number)}`;
    } else {
        body = panel_of[stage](t, item);
    }
    document.getElementById("h-numbers").innerHTML = `<span class="stage-number">${state.s + 1}</span> ${stage}`;
    document.getElementById("numbers").innerHTML =
        bug_banner() + `<p class="lead">${words} <span class="soft">Source: <code>raster/${file}</code>. ${state.predict ? "" : `Triangle ${t.number} ${escape_html(t.why)}.`}</span></p>${body}`;
    // What has to be scrolled must be reachable by keyboard.
    for (const box of document.querySelectorAll("#numbers .scroll, #numbers .spaces, #numbers .matrices"))
        if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
}
