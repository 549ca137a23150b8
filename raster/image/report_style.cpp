// report_style.cpp: the style of the report page: light and dark, blue and orange, never red against green.
#include <raster/image/report_page.h>

namespace raster::report_parts {

const char* const style = R"css(
:root {
  color-scheme: light dark;
  --ground: #f4f5f7; --panel: #ffffff; --ink: #1b1f24; --faint: #57606a; --line: #d4d9df;
  --accent: #0a58b5; --on-accent: #ffffff; --fail: #a63d00; --fail-ground: #fdebdd; --pass: #0a58b5; --pass-ground: #e3eefb;
  --check-a: #e8eaed; --check-b: #f7f8f9; --stage: #dfe3e8;
}
@media (prefers-color-scheme: dark) {
  :root:not([data-theme="light"]) {
    --ground: #14171b; --panel: #1d2126; --ink: #e9ecef; --faint: #a0a8b2; --line: #363c44;
    --accent: #7db7ff; --on-accent: #10151b; --fail: #ffab66; --fail-ground: #3a2616; --pass: #8dc1ff; --pass-ground: #182a40;
    --check-a: #2a2f36; --check-b: #22262c; --stage: #0c0e11;
  }
}
:root[data-theme="dark"] {
  color-scheme: dark;
  --ground: #14171b; --panel: #1d2126; --ink: #e9ecef; --faint: #a0a8b2; --line: #363c44;
  --accent: #7db7ff; --on-accent: #10151b; --fail: #ffab66; --fail-ground: #3a2616; --pass: #8dc1ff; --pass-ground: #182a40;
  --check-a: #2a2f36; --check-b: #22262c; --stage: #0c0e11;
}
:root[data-theme="light"] { color-scheme: light; }
* { box-sizing: border-box; }
[hidden] { display: none !important; }
html, body { height: 100%; margin: 0; }
body {
  display: flex; flex-direction: column; background: var(--ground); color: var(--ink);
  font: 14px/1.45 system-ui, -apple-system, "Segoe UI", "Noto Sans", "DejaVu Sans", sans-serif;
}
h1, h2, p, dl, ol { margin: 0; }
h1 { font-size: 15px; letter-spacing: .01em; }
h2 { font-size: 17px; overflow-wrap: anywhere; }
kbd { font: 12px ui-monospace, "DejaVu Sans Mono", monospace; padding: 0 4px; border: 1px solid var(--line);
      border-radius: 3px; color: var(--faint); }
header { display: flex; gap: 14px; align-items: center; padding: 8px 16px; background: var(--panel);
         border-bottom: 1px solid var(--line); }
.spring { flex: 1; }
#summary { color: var(--faint); }
button, .option { font: inherit; color: inherit; }
button { background: var(--panel); border: 1px solid var(--line); border-radius: 6px; padding: 3px 10px; cursor: pointer; }
button:hover { border-color: var(--accent); }
button:disabled { opacity: .45; cursor: default; border-color: var(--line); }
button[aria-pressed="true"] { background: var(--accent); color: var(--on-accent); border-color: var(--accent); }
button[aria-pressed="true"] kbd { color: inherit; border-color: currentColor; opacity: .75; }
:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }
.option { display: inline-flex; gap: 5px; align-items: center; white-space: nowrap; }
.empty { padding: 24px; }

#layout { flex: 1; min-height: 0; display: flex; }
#list { width: 250px; flex: none; overflow: auto; padding: 12px 10px; border-right: 1px solid var(--line); background: var(--panel); }
#list[hidden] { display: none; }
#list .option { padding: 0 6px 8px; color: var(--faint); }
#names { list-style: none; padding: 0; }
#names button { display: flex; gap: 8px; width: 100%; text-align: left; border-color: transparent; background: none;
                padding: 5px 6px; overflow-wrap: anywhere; }
#names button[aria-current="true"] { background: var(--ground); border-color: var(--line); font-weight: 600; }
.badge { flex: none; display: inline-block; min-width: 22px; text-align: center; border-radius: 5px; font-weight: 700;
         padding: 0 6px; color: var(--fail); background: var(--fail-ground); }
.badge.pass { color: var(--pass); background: var(--pass-ground); }

main { flex: 1; min-width: 0; display: flex; flex-direction: column; }
#facts { padding: 12px 16px 8px; }
h2 { display: flex; gap: 10px; align-items: center; }
#verdict { font-size: 14px; white-space: nowrap; }
#reason { color: var(--fail); }
#reason:empty { display: none; }
#figures { display: flex; flex-wrap: wrap; gap: 2px 26px; padding-top: 6px; }
#figures div { display: flex; flex-direction: column; }
#figures dt { color: var(--faint); font-size: 12px; }
#figures dd { margin: 0; font-variant-numeric: tabular-nums; font-weight: 600; font-size: 15px; }
#more { display: grid; grid-template-columns: max-content 1fr; gap: 1px 14px; padding-top: 6px; }
#more dt { color: var(--faint); }
#more dd { margin: 0; overflow-wrap: anywhere; }
code { font: 12.5px ui-monospace, "DejaVu Sans Mono", monospace; background: var(--panel); border: 1px solid var(--line);
       border-radius: 4px; padding: 0 5px; white-space: nowrap; }

#toolbar { display: flex; flex-wrap: wrap; gap: 6px 16px; align-items: center; padding: 6px 16px 8px; font-size: 13px; }
#toolbar button { padding: 3px 8px; }
.group { display: inline-flex; gap: 4px; align-items: center; flex-wrap: wrap; }
#zoom { min-width: 48px; text-align: center; font-variant-numeric: tabular-nums; }
#place { min-width: 60px; text-align: center; font-variant-numeric: tabular-nums; color: var(--faint); }

#stage { flex: 1; min-height: 180px; display: flex; gap: 8px; padding: 0 16px; }
.pane { position: relative; flex: 1; min-width: 0; overflow: hidden; background: var(--stage); border: 1px solid var(--line);
        border-radius: 8px; cursor: grab; touch-action: none; user-select: none; }
.pane.moving { cursor: grabbing; }
.pane img { position: absolute; left: 0; top: 0; transform-origin: 0 0; max-width: none; pointer-events: none;
            background: repeating-conic-gradient(var(--check-a) 0 25%, var(--check-b) 0 50%) 0 0 / 16px 16px; }
.pane img.opaque { background: none; }
.pane img.sharp { image-rendering: pixelated; }
.pane img.heat { filter: url(#heat); }
.caption { position: absolute; left: 8px; top: 8px; z-index: 3; padding: 1px 8px; border-radius: 5px; font-size: 12px; font-weight: 600;
           background: var(--panel); border: 1px solid var(--line); pointer-events: none; }
.caption.right { left: auto; right: 8px; }
.none { position: absolute; inset: 0; display: grid; place-items: center; color: var(--faint); }
.mark, .cross { position: absolute; z-index: 2; pointer-events: none; }
.mark { border: 2px solid #e86a00; border-radius: 3px; box-shadow: 0 0 0 1px #fff, inset 0 0 0 1px #fff; opacity: .85; }
.mark.current { border-color: #0a58b5; border-width: 3px; opacity: 1; }
.cross { border: 1px solid #000; box-shadow: 0 0 0 1px #fff; }
.handle { position: absolute; z-index: 4; top: 0; bottom: 0; width: 44px; margin-left: -22px; cursor: ew-resize; touch-action: none; }
.handle::before { content: ""; position: absolute; left: 21px; width: 2px; top: 0; bottom: 0; background: #fff; box-shadow: 0 0 0 1px #0008; }
.handle::after { content: "\2194"; position: absolute; left: 8px; top: 50%; width: 28px; height: 28px; margin-top: -14px; border-radius: 50%;
                 display: grid; place-items: center; background: var(--accent); color: var(--on-accent); box-shadow: 0 0 0 2px #fff; }
footer { white-space: pre-wrap; padding: 6px 16px 10px; font: 12.5px ui-monospace, "DejaVu Sans Mono", monospace; color: var(--faint); min-height: 34px; }
.swatch { display: inline-block; width: 11px; height: 11px; border: 1px solid var(--line); border-radius: 2px; vertical-align: -1px; }

dialog { color: inherit; background: var(--panel); border: 1px solid var(--line); border-radius: 10px; padding: 18px 22px; max-width: 560px; }
dialog::backdrop { background: #0007; }
.keys { display: grid; grid-template-columns: max-content 1fr; gap: 4px 16px; padding: 10px 0 14px; }
.keys dd { margin: 0; }

@media (max-width: 760px) {
  body { height: auto; }
  #layout { flex-direction: column; }
  #list { width: auto; border-right: 0; border-bottom: 1px solid var(--line); max-height: 30vh; }
  #stage { flex-direction: column; flex: none; }
  .pane { flex: none; height: 60vh; }
}
)css";

}  // namespace raster::report_parts
