// scrubber.js: the four levels below the panes, each with its place and two buttons.

const scrubber = document.getElementById("scrubber");

function item_name(t, s, item) {
    if (item.x !== undefined) return `pixel ${item.x},${item.y}`;
    if (item.corner !== undefined) return `corner v${item.corner}`;
    if (item.plane !== undefined) return `plane ${t.planes[item.plane].plane}`;
    return item.piece ? `piece ${item.piece}` : "whole";
}

function set_up_scrubber() {
    scrubber.innerHTML = level_names.map((name, level) => `<div class="level" data-level="${level}">
      <button class="name" aria-pressed="false" title="Arrow keys step this level">${name}</button>
      <button class="back" aria-label="previous ${name}">←</button>
      <input type="range" min="0" aria-label="${name}" step="1">
      <button class="on" aria-label="next ${name}">→</button>
      <output></output></div>`).join("");
    for (const row of scrubber.children) {
        const level = Number(row.dataset.level);
        row.querySelector(".name").addEventListener("click", () => { state.level = level; update(); });
        row.querySelector(".back").addEventListener("click", () => step(-1, level));
        row.querySelector(".on").addEventListener("click", () => step(1, level));
        row.querySelector("input").addEventListener("input", event => scrub(level, Number(event.target.value)));
    }
}

function scrub(level, value) {
    if (level === 0) go(data.triangles.findIndex(t => t.draw === draws_shown()[value]), state.s);
    else if (level === 1) go(value, state.s);
    else if (level === 2) go(state.t, value);
    else go(state.t, state.s, value);
}
const draws_shown = () => [...new Set(data.triangles.map(t => t.draw))];

function draw_scrubber() {
    const t = current_triangle(), items = items_of(state.t, state.s), draws = draws_shown();
    const place = [[draws.indexOf(t.draw), draws.length, `${t.draw} of ${data.draws.length}: ${escape_html(data.draws[t.draw].material)}`],
        [state.t, data.triangles.length, `${t.number} of ${data.model.triangles}`],
        [state.s, stages.length, `${state.s + 1} ${stages[state.s]}`],
        [Math.max(state.i, 0), items.length, item_name(t, state.s, current_item()) + (state.i < 0 ? " (not reached)" : "")]];
    for (const [level, row] of [...scrubber.children].entries()) {
        const [value, count, text] = place[level];
        const range = row.querySelector("input");
        range.max = Math.max(count - 1, 0);
        range.value = value;
        range.disabled = count < 2;
        range.setAttribute("aria-valuetext", row.querySelector("output").textContent = text);
        row.querySelector("output").innerHTML = text;
        row.querySelector(".back").disabled = !neighbour(level, -1);
        row.querySelector(".on").disabled = !neighbour(level, 1);
        row.classList.toggle("current", state.level === level);
        row.querySelector(".name").setAttribute("aria-pressed", String(state.level === level));
    }
}
