// bug.js: a page of a pipeline with a bug: what is wrong, where the runs part, and the pictures side by side.

/** An event's members as paths and values. */
function flattened(value, path = "", into = new Map()) {
    if (value !== null && typeof value === "object")
        for (const [key, inner] of Object.entries(value)) flattened(inner, Array.isArray(value) ? `${path}[${key}]` : path ? `${path}.${key}` : key, into);
    else into.set(path, value);
    return into;
}
const stage_of_event = stage => (stage === "clip_plane" ? "clip" : stage);
const first_wrong = () => data.bug.first;

/** The address of the first event that differs. */
function first_wrong_address() {
    const first = first_wrong();
    const parts = [`triangle=${first.triangle || data.focus.triangle}`, `stage=${stage_of_event(first.stage)}`];
    parts.push(`pixel=${(first.pixel || data.focus.pixel).join(",")}`);
    return "#" + parts.join("&");
}
function first_wrong_words() {
    const first = first_wrong();
    return `${stage_of_event(first.stage)}${first.triangle ? ` of triangle ${first.triangle}` : ""}${first.pixel ? ` at pixel ${first.pixel.join(",")}` : ""}`;
}
const is_at_first_wrong = () => first_wrong() && stages[state.s] === stage_of_event(first_wrong().stage) &&
    (!first_wrong().triangle || current_triangle().number === first_wrong().triangle);

function first_wrong_table() {
    const { right, wrong } = first_wrong();
    if (!right) return `<p>The right run has ended here: this event is one too many.</p>`;
    if (!wrong) return `<p>The wrong run ends here; the right one goes on.</p>`;
    const a = flattened(right), b = flattened(wrong);
    const paths = [...new Set([...a.keys(), ...b.keys()])].filter(path => a.get(path) !== b.get(path));
    const shown = value => (value === undefined ? "–" : typeof value === "number" ? num(value) : escape_html(value));
    return table("The first event that differs", ["number", "right", "wrong"],
        paths.slice(0, 12).map(path => [`<code>${path}</code>`, shown(a.get(path)), `<b>${shown(b.get(path))}</b>`])) +
        (paths.length > 12 ? `<p class="soft">and ${paths.length - 12} more numbers</p>` : "");
}

/** On top of each step of such a page. Predict mode asks for the stage and hides it until then. */
function bug_banner() {
    if (!data.bug) return "";
    if (state.predict && !state.answered) return `<div class="bug-box"><p><b>One classic mistake</b> is in this pipeline. Where?</p></div>`;
    const { name, mistake, symptom } = data.bug, count = data.pictures.differing;
    const whole = (picture, caption) => `<figure><img src="${data.pictures[picture]}" alt="${caption}"><figcaption>${caption}</figcaption></figure>`;
    const pictures = `<details${is_at_first_wrong() ? " open" : ""}><summary>Right, wrong and difference</summary>
      <div class="pictures wide">${whole("right", "right")}${whole(picture_name(), "with the bug")}${whole("difference", "difference: orange")}</div></details>`;
    return `<div class="bug-box"><p><b>Bug ${name}</b>: ${escape_html(mistake)}. <span class="soft">In general: ${escape_html(symptom)}.</span></p>
      <p>${num(count)} pixel${count === 1 ? "" : "s"} of the picture differ${count === 1 ? "s" : ""}. ${first_wrong()
        ? `The runs part at <a href="${first_wrong_address()}">${first_wrong_words()}</a>, after ${num(first_wrong().event)} equal events.` : "No step differs in this scene."}
      The numbers below are those of the wrong run; the formulas are the right ones.</p>
      ${is_at_first_wrong() ? first_wrong_table() : ""}${pictures}</div>`;
}

function bug_question() {
    if (!first_wrong()) return null;
    return choice("This picture was drawn with one classic mistake. In which stage do the runs part?", stages, stage_of_event(first_wrong().stage),
        `${data.bug.name}: ${data.bug.mistake}. The first event that differs is ${first_wrong_words()}.`);
}
