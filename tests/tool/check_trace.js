// check_trace.js MODULES SCHEMA TRACE...: every line is valid, every kind of line occurs, and spoilt lines are refused.
const fs = require("fs");
const [modules, schemaPath, ...traces] = process.argv.slice(2);
const loaded = require(modules + "/ajv");
const Ajv = loaded.default || loaded;
const validate = new Ajv({ allErrors: false }).compile(JSON.parse(fs.readFileSync(schemaPath, "utf8")));

let failures = 0;
const fail = (what) => {
  failures += 1;
  if (failures < 10) console.error(what);
};
const kinds = new Set();
for (const path of traces) {
  const lines = fs.readFileSync(path, "utf8").split("\n");
  if (lines.pop() !== "") fail(path + ": the last line has no end");
  lines.forEach((line, i) => {
    const event = JSON.parse(line);
    const kind = event.stage || event.format;
    if (!validate(event)) fail(`${path}:${i + 1}: ${JSON.stringify(validate.errors[0])} ${line}`);
    if (kinds.has(kind)) return;
    kinds.add(kind);
    // The schema is strict: without a member, with one too many, or with a word for a number a line is refused.
    for (const key of Object.keys(event)) {
      const without = { ...event };
      delete without[key];
      if (validate(without)) fail(`${kind} without ${key} is accepted`);
      if (validate({ ...event, [key]: { no: 1 } }) && key !== "conventions") fail(`${kind} with an object as ${key} is accepted`);
    }
    if (validate({ ...event, more: 1 })) fail(`${kind} with one member more is accepted`);
  });
}
const expected = ["raster-trace", "draw", "vertex", "assemble", "clip_plane", "clip", "project", "cull", "setup",
  "coverage", "depth", "interpolate", "fragment", "blend", "end"];
for (const kind of expected) if (!kinds.has(kind)) fail(`no line of kind ${kind} occurred`);
process.exit(failures ? 1 : 0);
