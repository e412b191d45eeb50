// The error of a formula at the inputs of a part: form, sentence, charts, address.
const DATA = JSON.parse(document.getElementById("explorer-data").textContent);
const LIMITS = [0.01, 0.02, 0.05, 0.1], SMALL = 0.02; // an error on the unsafe side that a conservative formula may have
const STEPS = 500, SNAP = 4; // SNAP: steps of a slider to a stored value
const HEIGHT = 196, LEFT = 54, RIGHT = 36, TOP = 12; // of a chart, in pixels
const $ = (name) => document.getElementById(`explorer-${name}`);
const plain = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
const percent = (x) => (Math.abs(x) >= 1e-6 ? digits(100 * Math.abs(x), 2) : x ? "< 0.0001" : "0");
const signed = (x) => (x < 0 ? "−" : "+") + digits(100 * Math.abs(x), 3);
const link = (target, words) => `<a href=${JSON.stringify(target)}>${plain(words)}</a>`;
let one, formula, axes, sizes, values; // case, its formula and inputs, what ratios divide by, numbers by name

// ---------- the part: numbers that a user types, and where they lie on the axes of the case
const product = (axis, number) => axis.per.reduce((all, p) => all * number(p) ** p.power, 1);
const larger = (axis) => product(axis, (p) => (sizes.some((s) => s.name === p.name) ? values[p.name] / p.own : 1));
const position = (axis) => values[axis.name] / larger(axis);
const divisor = (axis) => product(axis, (p) => values[p.name] ?? p.own) / axis.factor;
const is_own = (axis) => Math.abs(position(axis) - axis.own) <= SAME * Math.abs(axis.own);
const stored = (axis) => formula.at.flatMap(({ study }) =>
  one.studies[study].axes.flatMap((a, k) => (a.name === axis.name ? one.studies[study].ticks[k] : [])));
const ends = (axis) => [Math.min(...stored(axis)), Math.max(...stored(axis))].map((x) => scaled(axis, x));

function described(axis) {
  const ratio = axis.ratio ? ` (${axis.ratio} = ${digits(values[axis.name] / divisor(axis))})` : "";
  return with_unit(axis, values[axis.name]) + ratio;
}

// ---------- the answer
function asked(course) { // of one study
  const study = one.studies[course.study], moved = axes.filter((a) => !is_own(a));
  const broken = axes.find((a) => a.whole && !Number.isInteger(values[a.name]));
  if (broken) return { why: `${broken.symbol} takes whole numbers` };
  const held = moved.filter((a) => !study.axes.some((b) => b.name === a.name)), names = (list) => list.map((a) => a.symbol).join(" and ");
  if (held.length) return { why: `not compared with another ${names(held)}${moved.length > held.length ? " at the same time" : ""}` };
  if (study.star && moved.length > 1) return { why: `${names(moved)} were changed one at a time: not compared together` };
  return between(study, course, study.axes.map(position));
}

function best() { // of all studies: the one whose points are nearest, then one at the case's own inputs
  const found = formula.at.map((course) => ({ ...asked(course), course }));
  const rank = (q) => [q.apart, one.studies[q.course.study].held ? 1 : 0];
  const order = (p, q) => rank(p).map((v, k) => v - rank(q)[k]).find((v) => v) ?? 0;
  return found.filter((q) => "e" in q).sort(order)[0] ?? { why: [...new Set(found.map((q) => q.why))].join("; ") };
}

function judged(q) { // class, side and words of an error
  const size = Math.abs(q.e) + q.u, limit = LIMITS.find((l) => size <= l), decided = Math.abs(q.e) > q.u;
  const side = decided && formula.safe ? (q.e * formula.safe > 0 ? "safe" : "unsafe") : "";
  const head = limit ? `Within ${100 * limit} %` : Math.abs(q.e) - q.u > 0.1 ? "Beyond 10 %" : "Not certain to be within 10 %";
  const way = `the formula is too ${q.e > 0 ? "high" : "low"}, ${side ? `the ${side} side` : "and neither side is safe"}`;
  return {
    css: limit <= 0.05 ? "good" : limit || side === "safe" ? "fair" : "bad", head: head + (side && size > SMALL ? `, on the ${side} side` : ""),
    words: decided ? way : "whether it is too high or too low is within the bar",
  };
}

function with_bar(e, u) { // no more decimals than the bar has with two digits, nor than three digits of the error
  const decimals = (x, n) => n - 1 - Math.floor(Math.log10(Math.max(100 * Math.abs(x), 1e-4)));
  const count = Math.min(6, Math.max(0, Math.min(decimals(u, 2), Math.max(decimals(e, 3), decimals(u, 1)))));
  const bar = (100 * u).toFixed(count);
  return `${e < 0 ? "−" : "+"}${(100 * Math.abs(e)).toFixed(count)} % ± ${+bar ? bar : `< ${(10 ** -count).toFixed(count)}`} %`;
}

function answer(q) {
  const box = $("answer"), where = axes.map(described).join(", ");
  Object.assign(box.dataset, { error: q.e ?? "", bar: q.u ?? "", bent: q.bent ?? "" });
  box.className = "e" in q ? judged(q).css : "";
  if (!("e" in q)) {
    box.innerHTML = `<b>No data</b><p>At ${where}: ${q.why}. Nothing is extrapolated. <code>freewheel init ${one.id} &gt; my.toml</code>, then <code>freewheel check --fem my.toml</code> computes it.</p>`;
    return;
  }
  const { head, words } = judged(q), held = one.studies[q.course.study].held;
  const from = q.stored ? "a stored point" : `between stored points; ±${percent(q.bent)} % of the bar is interpolation`;
  const error = `error ${with_bar(q.e, q.u)}${formula.of ? ` of ${plain(formula.of)}` : ""} (${from}); ${words}`;
  const factor = `Reference = formula × <strong>${digits(1 / (1 + q.e))}</strong> (${digits(1 / (1 + q.e + q.u))} to ${digits(1 / (1 + q.e - q.u))}).`;
  const verdict = (v) => `<p>Verdict of ${link(`../report.html#${v.place}`, v.name)}: <span class="state verdict-${v.css}">${v.verdict}</span>${v.instead && `. Use instead: ${v.instead}`}.</p>`;
  box.innerHTML = `<b>${head}</b><p>At ${where}${held && `, stored for ${plain(held)}`}: ${error}.</p>` +
    (!formula.no_factor && q.e - q.u > -1 ? `<p>${factor}</p>` : "") + (formula.verdicts ?? []).map((n) => verdict(DATA.verdicts[n])).join("");
}

// ---------- charts, in the pixels of the page
function heights() { // the errors that all charts of a formula have room for
  const all = formula.at.flatMap((a) => a.error.flatMap((e, n) => (e === null ? [] : [e - a.U[n], e + a.U[n]])));
  const low = Math.min(0, ...all), high = Math.max(0, ...all), room = Math.max(0.08 * (high - low), 1e-9);
  return [low - room, high + room];
}

function curve(axis, q) { // answers over one input, the others as typed, or as in the case where these have none
  const has = (course) => course && one.studies[course.study].axes.some((a) => a.name === axis.name);
  const course = [q.course, ...formula.at].find(has), study = one.studies[course.study];
  const k = study.axes.findIndex((a) => a.name === axis.name), others = axes.filter((a) => a.name !== axis.name && !is_own(a));
  const free = study.star ? !others.length : others.every((a) => study.axes.some((b) => b.name === a.name));
  return { t: study.ticks[k], free, at: (x) => between(study, course, study.axes.map((a, j) => (j === k ? x : free ? position(a) : a.own))) };
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
    `${ground(course.t, width, range, X, Y)}${line(course, axis, X, Y)}${mark}${word}</svg><figcaption>${course.free ? "" : "Grey: at the case’s own other inputs."}</figcaption></figure>`;
}

// ---------- form and address
function form() {
  const number = (a, kind, symbol, unit) => `<label>${symbol} <input type="number" step="any" data-name="${plain(a.name)}" data-kind="${kind}" aria-label="${plain(a.name)}${kind === "ratio" ? ", dimensionless" : ""}"> ${unit}</label>`;
  const slider = (a) => `<input type="range" data-name="${plain(a.name)}" data-kind="slide" aria-label="${plain(a.name)}" min="${a.whole ? ends(a)[0] : 0}" max="${a.whole ? ends(a)[1] : STEPS}">`;
  const group = (title, numbers, more) => `<fieldset><legend>${title}</legend><div class="numbers">${numbers.join("")}</div>${more}</fieldset>`;
  const inputs = axes.map((a) => group(`${a.symbol}, ${plain(a.what)}`, [number(a, "value", a.symbol, a.unit), a.ratio ? number(a, "ratio", a.ratio, "") : ""], slider(a)));
  const size = sizes.length ? group("Size of your part", sizes.map((p) => number(p, "value", p.symbol, p.unit)), "") : "";
  $("inputs").innerHTML = inputs.join("") + size + `<div><button type="button">The case’s own inputs</button></div>`;
}

function fill(input) {
  const { name, kind } = input.dataset, axis = axes.find((a) => a.name === name);
  if (kind !== "slide") {
    input.value = +(kind === "ratio" ? values[name] / divisor(axis) : values[name]).toPrecision(6);
    return;
  }
  const [p, q] = ends(axis);
  input.value = axis.whole ? position(axis) : (STEPS * (scaled(axis, position(axis)) - p)) / (q - p);
  input.ariaValueText = digits(position(axis));
}

function slid(axis, x) { // the value at a step of a slider, a stored one where that is near
  if (axis.whole) return x;
  const [p, q] = ends(axis), at = p + ((q - p) * x) / STEPS;
  const near = stored(axis).find((v) => Math.abs(scaled(axis, v) - at) <= (SNAP * (q - p)) / STEPS);
  return near ?? (axis.log ? Math.exp(at) : at);
}

function show(typed) {
  for (const input of $("inputs").querySelectorAll("input")) if (input !== typed) fill(input);
  const q = best(), range = heights(), dates = [...new Set(formula.at.map((a) => one.studies[a.study].date))].join(", ");
  answer(q);
  $("charts").innerHTML = axes.map((a) => chart(a, q, range)).join("");
  const shaded = formula.safe ? ` Shaded: the unsafe side, too ${formula.safe > 0 ? "low" : "high"}.` : "";
  $("source").innerHTML = `Reference: ${plain(formula.by ?? "finite elements")}; measured ${dates}. Row ${link(`${one.id}.html#${formula.row}`, `${one.id}/${formula.name}`)}.${shaded} Hatched: nothing is stored. The address of this page holds the inputs.`;
  const state = new URLSearchParams({ case: one.id, formula: formula.name });
  for (const [name, value] of Object.entries(values)) state.set(name, +value.toPrecision(8));
  history.replaceState(null, "", `#${state}`);
}

function pick(id, name) { // a case and one of its formulas, at the case's own inputs
  one = DATA.cases.find((c) => c.id === id) ?? DATA.cases[0];
  one.studies.forEach(prepare);
  const groups = [["with a verdict", one.formulas.filter((f) => f.verdicts)], ["other comparisons", one.formulas.filter((f) => !f.verdicts)]];
  formula = one.formulas.find((f) => f.name === name) ?? groups[0][1][0] ?? one.formulas[0];
  const unique = (list) => [...new Map(list.map((a) => [a.name, a])).values()];
  axes = unique(formula.at.flatMap((a) => one.studies[a.study].axes));
  sizes = axes.every((a) => a.scales) ? unique(axes.flatMap((a) => a.per)).filter((p) => !axes.some((a) => a.name === p.name)) : [];
  values = Object.fromEntries([...axes, ...sizes].map((a) => [a.name, a.own]));
  const options = (list) => list.map((f) => `<option>${plain(f.name)}</option>`).join("");
  $("formula").innerHTML = groups.filter(([, list]) => list.length).map(([label, list]) => `<optgroup label="${label}">${options(list)}</optgroup>`).join("");
  $("case").value = one.id;
  $("formula").value = formula.name;
  form();
}

function read() { // the address: a state, or the place of a case or a formula in the tables
  const place = location.hash.slice(1), given = new URLSearchParams(place), of_row = (f) => place === `explore-${f.row}`;
  const found = DATA.cases.find((c) => place === `explore-${c.id}` || c.formulas.some(of_row));
  pick(found?.id ?? given.get("case"), found ? found.formulas.find(of_row)?.name : given.get("formula"));
  for (const name of Object.keys(values)) if (given.has(name) && Number.isFinite(+given.get(name))) values[name] = +given.get(name);
  show();
  if (found) scrollTo(0, 0);
}

$("inputs").addEventListener("input", ({ target }) => {
  const { name, kind } = target.dataset, axis = axes.find((a) => a.name === name), x = +target.value;
  if (target.value === "" || !Number.isFinite(x) || (!axis && x <= 0)) return;
  values[name] = kind === "value" ? x : kind === "ratio" ? x * divisor(axis) : slid(axis, x) * larger(axis);
  show(target);
});
$("inputs").addEventListener("click", ({ target }) => {
  if (target.type !== "button") return;
  pick(one.id, formula.name);
  show();
});
$("inputs").addEventListener("submit", (event) => event.preventDefault());
$("case").addEventListener("change", ({ target }) => { pick(target.value); show(); });
$("formula").addEventListener("change", ({ target }) => { pick(one.id, target.value); show(); });
addEventListener("hashchange", read);
addEventListener("resize", () => show());
$("case").innerHTML = DATA.cases.map((c) => `<option value="${c.id}">${plain(c.title)} (${c.id})</option>`).join("");
$("tool").hidden = false;
read();
