// Charts of the explorer, one for each input, in the pixels of the page.
const HEIGHT = 196, LEFT = 54, RIGHT = 36, TOP = 12; // of a chart

function heights() { // the errors that all charts of a formula have room for
  const all = formula.at.flatMap((a) => a.error.flatMap((e, n) => (e === null ? [] : [e - a.U[n], e + a.U[n]])));
  const low = Math.min(0, ...all), high = Math.max(0, ...all), room = Math.max(0.08 * (high - low), 1e-9);
  return [low - room, high + room];
}

function curve(axis, q) { // answers over one input, the others as typed, or as in the case where these have none
  const has = (course) => course && one.studies[course.study].axes.some((a) => a.name === axis.name);
  const course = [q.course, ...formula.at].find(has), study = one.studies[course.study];
  const k = study.axes.findIndex((a) => a.name === axis.name), others = axes.filter((a) => a.name !== axis.name && !is_central(a, study));
  const free = study.star ? !others.length : others.every((a) => study.axes.some((b) => b.name === a.name));
  return { t: study.ticks[k], free, at: (x) => between(study, course, study.axes.map((a, j) => (j === k ? x : free ? position(a) : a.nominal))) };
}

function places(axis, t, width, [low, high]) { // pixels of an input's value and of an error
  const [a, b] = [t[0], t.at(-1)].map((x) => scaled(axis, x)), pad = 0.07 * (b - a) || 1, length = width - LEFT - RIGHT;
  const inside = (x) => Math.min(b + pad, Math.max(a - pad, axis.log && x <= 0 ? a - pad : scaled(axis, x)));
  return [(x) => LEFT + (length * (inside(x) - a + pad)) / (b - a + 2 * pad),
    (e) => TOP + ((HEIGHT - TOP) * (high - Math.min(high, Math.max(low, e)))) / (high - low)];
}

function ground(t, width, [low, high], X, Y) { // sides, limits, scales
  const right = width - RIGHT, ten = 10 ** Math.floor(Math.log10((high - low) / 5)), parts = [];
  const block = (css, x, y, w, h) => parts.push(`<rect class="${css}" x="${x}" y="${y}" width="${w}" height="${h}"/>`);
  const across = (css, e) => parts.push(`<path class="${css}" d="M${LEFT},${Y(e)}H${right}"/>`);
  const text = (x, y, anchor, words) => parts.push(`<text x="${x}" y="${y}" text-anchor="${anchor}">${words}</text>`);
  if (formula.safe > 0) block("unsafe", LEFT, Y(0), right - LEFT, HEIGHT - Y(0));
  if (formula.safe < 0) block("unsafe", LEFT, TOP, right - LEFT, Y(0) - TOP);
  block("none", LEFT, TOP, X(t[0]) - LEFT, HEIGHT - TOP);
  block("none", X(t.at(-1)), TOP, right - X(t.at(-1)), HEIGHT - TOP);
  const step = [1, 2, 5, 10].find((m) => m * ten >= (high - low) / 5) * ten;
  for (let n = Math.ceil(low / step); n * step <= high; n++) {
    across(n ? "grid" : "zero", n * step);
    text(LEFT - 6, Y(n * step) + 4, "end", n ? signed(n * step) : "0");
  }
  let last = Infinity;
  for (const limit of LIMITS.slice(1).flatMap((l) => [-l, l]).filter((l) => l > low && l < high).sort((p, q) => p - q)) {
    across("limit", limit);
    if (last - Y(limit) > 12) text(right + 4, (last = Y(limit)) + 4, "start", `${percent(limit)} %`);
  }
  last = -Infinity;
  for (const x of t) if (X(x) - last > 44) text((last = X(x)), HEIGHT + 15, "middle", digits(x));
  return parts.join("");
}

function line({ t, free, at }, axis, X, Y) { // stored points, and what lies between them
  const found = t.map(at), place = (x, e) => `${X(x)},${Y(e)}`;
  const pieces = t.slice(1).map((end, i) => {
    const start = t[i], [p, q] = [found[i].e, found[i + 1].e], { u } = at(axis.log ? Math.sqrt(start * end) : (start + end) / 2);
    if (u === undefined) return "";
    const band = [[start, p + u], [end, q + u], [end, q - u], [start, p - u]].map(([x, e]) => place(x, e));
    return `<path class="band" d="M${band.join("L")}z"/><path class="course" d="M${place(start, p)}L${place(end, q)}"/>`;
  });
  const dots = t.map((x, i) => "e" in found[i] ? `<path class="bar" d="M${place(x, found[i].e - found[i].u)}L${place(x, found[i].e + found[i].u)}"/>` +
    (found[i].stored ? `<circle class="point" cx="${X(x)}" cy="${Y(found[i].e)}" r="3.6"/>` : "") : "");
  return `<g class="${free ? "free" : "faint"}">${pieces.join("")}${dots.join("")}</g>`;
}

function chart(axis, q, range) {
  const room = $("charts").clientWidth, width = Math.max(280, room > 840 ? (room - 32) / 2 : room);
  const course = curve(axis, q), [X, Y] = places(axis, course.t, width, range), x = X(position(axis)), late = x > width / 2;
  const mark = "e" in q ? `<path class="your" d="M${x},${Y(q.e - q.u)}V${Y(q.e + q.u)}"/><circle class="your" cx="${x}" cy="${Y(q.e)}" r="7"/>`
    : `<path class="your" stroke-dasharray="4 4" d="M${x},${TOP}V${HEIGHT}"/>`;
  const word = `<text class="your" x="${x + (late ? -11 : 11)}" y="${Math.max(TOP + 12, ("e" in q ? Y(q.e) : 0) - 9)}" text-anchor="${late ? "end" : "start"}">your part${"e" in q ? "" : ": no data"}</text>`;
  return `<figure><h3>Error [%] over ${axis.symbol}${axis.unit && ` [${axis.unit}]`}</h3><svg class="explored" viewBox="0 0 ${width} ${HEIGHT + 22}" role="img" aria-label="error over ${plain(axis.name)}">` +
    `${ground(course.t, width, range, X, Y)}${line(course, axis, X, Y)}${mark}${word}</svg><figcaption>${course.free ? "" : "Grey: all other inputs as in the case."}</figcaption></figure>`;
}
