// report_body.cpp: the markup of the report page; the script fills it.
#include <raster/image/report_page.h>

namespace raster::report_parts {

const char* const body = R"html(
<header>
  <h1>raster diff</h1>
  <p id="summary"></p>
  <span class="spring"></span>
  <button id="theme" title="Light or dark (t)">Light / dark</button>
  <button id="help-button" title="Keys (?)">Keys <kbd>?</kbd></button>
</header>
<noscript><p class="empty">This page needs JavaScript to show its pictures. They are also in its folder, as *.triptych.png and
*.diff.png; the figures are in diff.json.</p></noscript>
<div id="layout">
  <nav id="list" aria-label="Pictures">
    <label class="option"><input type="checkbox" id="show-passing"> also those that pass</label>
    <ol id="names"></ol>
  </nav>
  <main>
    <section id="facts" aria-live="polite">
      <h2><span id="verdict"></span> <span id="name"></span></h2>
      <p id="reason"></p>
      <dl id="figures"></dl>
      <dl id="more"></dl>
    </section>
    <div id="toolbar" role="toolbar" aria-label="View">
      <span class="group" id="modes"></span>
      <span class="group">
        <button id="zoom-out" title="Zoom out (-)" aria-label="Zoom out">&minus;</button>
        <output id="zoom"></output>
        <button id="zoom-in" title="Zoom in (+)" aria-label="Zoom in">+</button>
        <button id="fit" title="Fit into the window (0)">Fit</button>
        <button id="actual-size" title="One pixel is one pixel (9)">100 %</button>
      </span>
      <span class="group" id="place-tools">
        <button id="previous-place" title="Previous place that differs (p)" aria-label="Previous place">&lsaquo;</button>
        <output id="place"></output>
        <button id="next-place" title="Next place that differs (n)" aria-label="Next place">&rsaquo;</button>
        <label class="option"><input type="checkbox" id="show-places" checked> mark <kbd>m</kbd></label>
      </span>
    </div>
    <div id="stage"></div>
    <footer><output id="pixel">Point at a pixel to read it.</output></footer>
  </main>
</div>
<dialog id="help" aria-labelledby="help-title">
  <h2 id="help-title">Keys</h2>
  <dl class="keys">
    <dt><kbd>1</kbd> &hellip; <kbd>5</kbd></dt><dd>side by side, slider, blink, difference, FLIP</dd>
    <dt><kbd>n</kbd> <kbd>p</kbd></dt><dd>next, previous place that differs</dd>
    <dt><kbd>j</kbd> <kbd>k</kbd></dt><dd>next, previous picture</dd>
    <dt><kbd>+</kbd> <kbd>-</kbd></dt><dd>zoom; the mouse wheel too, where the pointer is</dd>
    <dt><kbd>0</kbd> <kbd>9</kbd></dt><dd>fit, 100 %</dd>
    <dt>arrows</dt><dd>move the picture (with shift: farther); in the slider view, its handle when focused</dd>
    <dt><kbd>space</kbd></dt><dd>in the blink view: stop, then change by hand; <kbd>b</kbd> goes on blinking</dd>
    <dt><kbd>m</kbd></dt><dd>mark the places that differ</dd>
    <dt><kbd>t</kbd></dt><dd>light or dark</dd>
    <dt><kbd>?</kbd></dt><dd>this list; <kbd>esc</kbd> closes it</dd>
  </dl>
  <button id="help-close">Close</button>
</dialog>
<svg width="0" height="0" aria-hidden="true" style="position:absolute">
  <filter id="heat" color-interpolation-filters="sRGB">
    <feComponentTransfer>
      <feFuncR type="table" tableValues="0 .11 .32 .52 .72 .91 .98 1 .99"/>
      <feFuncG type="table" tableValues="0 .07 .07 .15 .22 .32 .53 .76 .99"/>
      <feFuncB type="table" tableValues="0.02 .26 .49 .51 .48 .38 .38 .53 .75"/>
    </feComponentTransfer>
  </filter>
</svg>
)html";

}  // namespace raster::report_parts
