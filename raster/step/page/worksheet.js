// worksheet.js: questions about this draw on paper, and the answers on a sheet of their own.

/** N questions, spread over stages and triangles; the same for the same page. */
function worksheet_questions(count) {
    const asked = [], seen = new Set();
    let seed = 1;
    const next = below => { seed = (seed * 48271) % 2147483647; return seed % below; };
    const order = [6, 7, 4, 3, 9, 2, 8, 10, 0, 5, 1];
    for (let round = 0; asked.length < count && round < 40; ++round)
        for (const s of order) {
            if (asked.length === count) break;
            const start = next(data.triangles.length);
            for (let k = 0; k < data.triangles.length; ++k) {
                const t = (start + k) % data.triangles.length, items = items_of(t, s), item = items[next(items.length)];
                const question = question_of(data.triangles[t], s, item);
                if (!question || seen.has(question.text)) continue;
                seen.add(question.text);
                asked.push({ ...question, s, given: givens_of(data.triangles[t], s, item), address: address_of(t, s, item) });
                break;
            }
        }
    return asked.sort((a, b) => a.s - b.s);
}
function address_of(t, s, item) {
    const kept = { t: state.t, s: state.s, i: state.i, pixel: state.pixel };
    Object.assign(state, { t, s, i: items_of(t, s).indexOf(item), pixel: item.x === undefined ? state.pixel : [item.x, item.y] });
    const text = address();
    Object.assign(state, kept);
    return text;
}

function open_worksheet(count) {
    const sheet = document.getElementById("worksheet");
    const questions = worksheet_questions(count);
    const blank = q => (q.kind === "choice" ? q.options.map(o => `<span class="box"></span> ${o}`).join(" &nbsp; ") : '<span class="line"></span>');
    sheet.innerHTML = `<div class="tools no-print"><button id="close-worksheet">Back to the steps</button> <button id="print-worksheet">Print</button>
        <label>Questions <input id="worksheet-count" type="number" min="1" max="100" value="${count}"></label></div>
      <div class="sheet"><h2 id="h-worksheet">${escape_html(data.model.name)}: ${questions.length} questions</h2><p>Name <span class="line"></span></p>
      <div class="pictures">${crop_picture(picture_name(), "the picture around pixel " + data.focus.pixel.join(","), ...data.focus.pixel, 101).replace(/<br>.*<\/code>/, "")}</div>
      <ol>${questions.map(q => `<li><p><span class="soft">${stages[q.s]}.</span> ${escape_html(q.text)} <span class="given">${q.given}</span></p><p>${blank(q)}</p></li>`).join("")}</ol></div>
      <div class="sheet key"><h2>Answers</h2><ol>${questions.map(q => `<li><p><b>${short_text(q.answer)}</b>. ${escape_html(q.why)} <a href="${q.address}">Step there</a></p></li>`).join("")}</ol></div>`;
    sheet.hidden = false;
    document.getElementById("stepper").hidden = scrubber.hidden = true;
    document.getElementById("close-worksheet").addEventListener("click", close_worksheet);
    document.getElementById("print-worksheet").addEventListener("click", () => print());
    document.getElementById("worksheet-count").addEventListener("change", e => open_worksheet(Math.min(Math.max(Number(e.target.value) || 1, 1), 100)));
}
function close_worksheet() {
    document.getElementById("worksheet").hidden = true;
    document.getElementById("stepper").hidden = scrubber.hidden = false;
    update();
}
