// main.js: puts the parts together: keys, buttons, theme, the address, and one function that draws everything anew.

state.score = { right: 0, asked: 0 };
state.answered = false;
state.verdict = null;
let written_address = "";
let drawn_step = "";

function say(text) {
    document.getElementById("where").textContent = text;
}

/** Everything anew. `moved` is false when only an answer or a display option has changed. */
function update(moved = true) {
    const here = address();
    if (moved && here !== drawn_step) {
        state.answered = false;
        state.verdict = null;
        const t = current_triangle();
        say(`Triangle ${t.number}, stage ${state.s + 1} ${stages[state.s]}, ${item_name(t, state.s, current_item())}`);
        document.getElementById("numbers").scrollTop = 0;
    }
    drawn_step = here;
    draw_question();
    draw_panel();
    draw_scrubber();
    if (is_pixel_stage(state.s)) follow_pixel();
    draw_grid();
    draw_scene();
    if (here !== written_address) {
        written_address = here;
        history.replaceState(null, "", here);
    }
}

function toggle_predict() {
    state.predict = !state.predict;
    state.answered = false;
    state.verdict = null;
    document.getElementById("predict").setAttribute("aria-pressed", String(state.predict));
    update(false);
}
function toggle_digits() {
    all_digits = !all_digits;
    document.getElementById("digits").setAttribute("aria-pressed", String(all_digits));
    update(false);
}

const dark_wish = matchMedia("(prefers-color-scheme: dark)");
let theme = "system";
function show_theme() {
    const dark = theme === "dark" || (theme === "system" && dark_wish.matches);
    document.documentElement.dataset.dark = dark ? "yes" : "no";
    document.getElementById("theme").textContent = "Theme: " + theme;
    css_cache.clear();
}

function on_key(event) {
    const dialog = document.getElementById("help-dialog");
    if (event.ctrlKey || event.metaKey || event.altKey || dialog.open || !document.getElementById("worksheet").hidden) return;
    const target = event.target;
    if (target.matches("input:not([type=range]), select")) return;
    if (target.matches("input[type=range]") && /^Arrow/.test(event.key) && !event.shiftKey) return;
    const row = by => is_pixel_stage(state.s) && go_to_pixel(state.pixel[0], state.pixel[1] + by);
    const actions = {
        ArrowRight: () => step(1, event.shiftKey ? Math.max(state.level - 1, 0) : state.level),
        ArrowLeft: () => step(-1, event.shiftKey ? Math.max(state.level - 1, 0) : state.level),
        ArrowUp: () => (event.shiftKey ? change_level(-1) : row(-1)),
        ArrowDown: () => (event.shiftKey ? change_level(1) : row(1)),
        p: toggle_predict, d: toggle_digits, "+": () => zoom_grid(1.4), "-": () => zoom_grid(1 / 1.4), "?": () => dialog.showModal(),
    };
    const action = actions[event.key];
    if (!action) return;
    if (/^Arrow(Up|Down)$/.test(event.key) && !event.shiftKey && !is_pixel_stage(state.s)) return;
    action();
    event.preventDefault();
}

function set_up() {
    document.getElementById("model-name").textContent = data.model.name;
    const c = data.counts;
    document.getElementById("about").innerHTML = `<p>${escape_html(data.model.name)}: ${group(String(c.submitted))} triangles submitted, ${group(String(c.drawn))} drawn, ${group(String(c.culled))} culled, ${group(String(c.outside))} outside, ${group(String(c.zero_area))} without area; ${data.view.width} × ${data.view.height} pixels.
        All numbers are the renderer's own, from one observed draw. Made by <code>${escape_html(data.command)} --pixel ${data.focus.pixel.join(",")}</code></p>` +
        (data.left_out.length ? `<details><summary>What was left out of this page</summary><ul>${data.left_out.map(text => `<li>${escape_html(text)}</li>`).join("")}</ul></details>` : "");
    set_up_scene();
    set_up_grid();
    set_up_scrubber();
    const on = (id, action) => document.getElementById(id).addEventListener("click", action);
    const dialog = document.getElementById("help-dialog");
    on("predict", toggle_predict);
    on("digits", toggle_digits);
    on("help", () => dialog.showModal());
    on("close-help", () => dialog.close());
    document.getElementById("open-worksheet").hidden = Boolean(data.bug);
    on("open-worksheet", () => open_worksheet(data.questions || 10));
    on("theme", () => {
        theme = { system: "light", light: "dark", dark: "system" }[theme];
        show_theme();
        update(false);
    });
    dark_wish.addEventListener("change", () => { show_theme(); update(false); });
    addEventListener("keydown", on_key);
    addEventListener("beforeprint", () => {  // on white paper, whatever the screen
        document.documentElement.dataset.dark = "no";
        css_cache.clear();
        draw_grid();
        draw_scene();
    });
    addEventListener("afterprint", () => { show_theme(); update(false); });
    addEventListener("resize", () => { draw_grid(); draw_scene(); });
    addEventListener("hashchange", () => {
        if (location.hash === written_address) return;
        if (!document.getElementById("worksheet").hidden) close_worksheet();
        restore(location.hash);
        update();
    });

    const focus = triangle_index.get(data.focus.triangle);
    if (focus !== undefined) state.t = focus;
    state.s = Math.max(stages.indexOf(data.focus.stage || (data.bug && data.bug.first ? stage_of_event(data.bug.first.stage) : "")), 0);
    keep_place({});
    show_theme();
    show_pixel();
    const asked = location.hash;
    if (asked) restore(asked);
    update();
    if (data.questions > 0 && !asked) open_worksheet(data.questions);
}

if (data.triangles.length) set_up();
else document.getElementById("numbers").textContent = "The model has no triangles, so there is nothing to step through.";
