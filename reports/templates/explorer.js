// The error of a formula at the inputs of a part: form, sentence, charts, address.
const DATA = unpacked(JSON.parse(document.getElementById("explorer-data").textContent));
const LIMITS = [0.01, 0.02, 0.05, 0.1], SMALL = 0.02; // an error on the unsafe side that a conservative formula may have
const STEPS = 500, SNAP = 4; // SNAP: steps of a slider to a stored value
const $ = (name) => document.getElementById(`explorer-${name}`);
const plain = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
const percent = (x) => (Math.abs(x) >= 1e-6 ? digits(100 * Math.abs(x), 2) : x ? "< 0.0001" : "0");
const signed = (x) => (x < 0 ? "−" : "+") + digits(100 * Math.abs(x), 3);
const link = (target, words) => `<a href=${JSON.stringify(target)}>${plain(words)}</a>`;
let one, formula, axes, sizes, values; // case, its formula and inputs, what ratios divide by, numbers by name

function unpacked(data) { // errors and bars as fractions, axes with what they leave out where it is empty
  const fractions = (list) => list.map((n) => n === null ? null : n / 10 ** data.decimals);
  for (const { studies, formulas } of data.cases) {
    for (const s of studies) s.axes = s.axes.map((a) => ({ unit: "", ratio: "", per: [], ...a }));
    for (const f of formulas) f.at = f.at.map(([study, error, U, problems]) => ({ study, error: fractions(error), U: fractions(U), problems }));
  }
  return data;
}

// ---------- the part: numbers that a user types, and where they lie on the axes of the case
const product = (axis, number) => axis.per.reduce((all, p) => all * number(p) ** p.power, 1);
const larger = (axis) => product(axis, (p) => (sizes.some((s) => s.name === p.name) ? values[p.name] / p.nominal : 1));
const position = (axis) => values[axis.name] / larger(axis);
const divisor = (axis) => product(axis, (p) => values[p.name] ?? p.nominal) / axis.factor;
const centre = (axis, study) => study.at[axis.name] ?? axis.nominal; // of a study: its constant inputs
const is_central = (axis, study) => Math.abs(position(axis) - centre(axis, study)) <= SAME * Math.abs(centre(axis, study));
const stored = (axis) => formula.at.flatMap(({ study }) =>
  one.studies[study].axes.flatMap((a, k) => (a.name === axis.name ? one.studies[study].ticks[k] : [])));
const ends = (axis) => [Math.min(...stored(axis)), Math.max(...stored(axis))].map((x) => scaled(axis, x));

function described(axis) {
  const ratio = axis.ratio ? ` (${axis.ratio} = ${digits(values[axis.name] / divisor(axis))})` : "";
  return with_unit(axis, values[axis.name]) + ratio;
}

// ---------- the answer
function asked(course) { // of one study
  const study = one.studies[course.study], moved = axes.filter((a) => !is_central(a, study));
  const broken = axes.find((a) => a.whole && !Number.isInteger(values[a.name]));
  if (broken) return { why: `${broken.symbol} must be a whole number` };
  const held = moved.filter((a) => !study.axes.some((b) => b.name === a.name)), names = (list) => list.map((a) => a.symbol).join(" and ");
  if (held.length) return { why: `not compared with other values of ${names(held)}${moved.length > held.length ? " at the same time" : ""}` };
  if (study.star && moved.length > 1) return { why: `${names(moved)} were varied one at a time and not compared together` };
  return between(study, course, study.axes.map(position));
}

function best() { // of all studies: one at the inputs of the case, then the one whose points are nearest
  const found = formula.at.map((course) => ({ ...asked(course), course }));
  const rank = (q) => [one.studies[q.course.study].held ? 1 : 0, q.spacing];
  const order = (p, q) => rank(p).map((v, k) => v - rank(q)[k]).find((v) => v) ?? 0;
  return found.filter((q) => "e" in q).sort(order)[0] ?? { why: [...new Set(found.map((q) => q.why))].join("; ") };
}

function judged(q) { // class, side and words of an error
  const size = Math.abs(q.e) + q.u, limit = LIMITS.find((l) => size <= l), decided = Math.abs(q.e) > q.u;
  const side = decided && formula.safe ? (q.e * formula.safe > 0 ? "safe" : "unsafe") : "";
  const head = limit ? `Within ${100 * limit} %` : Math.abs(q.e) - q.u > 0.1 ? "Beyond 10 %" : "Not certain to be within 10 %";
  const way = `the formula is too ${q.e > 0 ? "high" : "low"}${side ? `, the ${side} side` : " (no side is stated to be safe)"}`;
  return {
    css: limit <= 0.05 ? "good" : limit || side === "safe" ? "fair" : "bad", head: head + (side && size > SMALL ? `, on the ${side} side` : ""),
    words: decided ? way : "the error bar includes both signs",
  };
}

function with_bar(e, u) { // three digits of the error, but no more decimals than two digits of its bar have
  const decimals = (x, n) => n - 1 - Math.floor(Math.log10(Math.max(100 * Math.abs(x), 1e-4)));
  const count = Math.min(6, Math.max(0, Math.min(decimals(u, 2), decimals(e, 3))));
  const bar = (100 * u).toFixed(count);
  return `${e < 0 ? "−" : "+"}${(100 * Math.abs(e)).toFixed(count)} % ± ${+bar ? bar : `< ${(10 ** -count).toFixed(count)}`} %`;
}

function factor(q) { // from the formula to the reference, and its ends by the bar
  const [at, low, high] = [0, q.u, -q.u].map((x) => (1 / (1 + q.e + x)).toPrecision(4));
  return `<p>Reference = formula × <strong>${at}</strong>${low === high ? "" : ` (${low} to ${high})`}.</p>`;
}

function answer(q) {
  const box = $("answer"), where = axes.map(described).join(", ");
  Object.assign(box.dataset, { error: q.e ?? "", bar: q.u ?? "", bent: q.bent ?? "" });
  box.className = "e" in q ? judged(q).css : "";
  if (!("e" in q)) {
    box.innerHTML = `<b>No data</b><p>At ${where}: ${q.why}. Nothing is extrapolated. <code>freewheel init ${one.id} &gt; my.toml</code>, then <code>freewheel check --fem my.toml</code> compares these inputs with finite elements.</p>`;
    return;
  }
  const { head, words } = judged(q), held = one.studies[q.course.study].held;
  const from = q.stored ? "stored point" : `between stored points, with an interpolation error of ±${percent(q.bent)} %`;
  const error = `error ${with_bar(q.e, q.u)}${formula.of ? ` of ${plain(formula.of)}` : ""} (${from}); ${words}`;
  const verdict = (v) => `<p>Verdict of ${link(`../report.html#${v.place}`, v.name)} from all its comparisons: <span class="state verdict-${v.css}">${v.verdict}</span>${v.instead && `. Use instead: ${v.instead}`}.</p>`;
  box.innerHTML = `<b>${head}</b><p>At ${where}${held && ` (stored for ${plain(held)})`}: ${error}.</p>` +
    (!formula.no_factor && q.e - q.u > -1 ? factor(q) : "") + (formula.verdicts ?? []).map((n) => verdict(DATA.verdicts[n])).join("");
}

// ---------- form and address
function form() {
  const number = (a, kind, symbol, unit) => `<label>${symbol} <input type="number" step="any" data-name="${plain(a.name)}" data-kind="${kind}" aria-label="${plain(a.name)}${kind === "ratio" ? ", dimensionless" : ""}"> ${unit}</label>`;
  const slider = (a) => `<input type="range" data-name="${plain(a.name)}" data-kind="slide" aria-label="${plain(a.name)}" min="${a.whole ? ends(a)[0] : 0}" max="${a.whole ? ends(a)[1] : STEPS}">`;
  const group = (title, numbers, more) => `<fieldset><legend>${title}</legend><div class="numbers">${numbers.join("")}</div>${more}</fieldset>`;
  const inputs = axes.map((a) => group(`${a.symbol}, ${plain(a.what)}`, [number(a, "value", a.symbol, a.unit), a.ratio ? number(a, "ratio", a.ratio, "") : ""], slider(a)));
  const size = sizes.length ? group("Size of your part", sizes.map((p) => number(p, "value", p.symbol, p.unit)), "") : "";
  $("inputs").innerHTML = inputs.join("") + size + `<div><button type="button">The inputs of the case</button></div>`;
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
  const shaded = formula.safe ? ` Shaded: unsafe side, the formula is too ${formula.safe > 0 ? "low" : "high"}.` : "";
  $("source").innerHTML = `Reference: ${plain(formula.by ?? "finite elements")}; measured ${dates}. Row ${link(`${one.id}.html#${formula.row}`, `${one.id}/${formula.name}`)}.${shaded} Hatched: no stored points. The address of this page contains the inputs.`;
  const state = new URLSearchParams({ case: one.id, formula: formula.name });
  for (const [name, value] of Object.entries(values)) state.set(name, +value.toPrecision(8));
  history.replaceState(null, "", `#${state}`);
}

function pick(id, name) { // a case and one of its formulas, at the inputs of the case
  one = DATA.cases.find((c) => c.id === id) ?? DATA.cases.find((c) => c.formulas.some((f) => f.verdicts)) ?? DATA.cases[0];
  one.studies.forEach(prepare);
  const groups = [["with a verdict", one.formulas.filter((f) => f.verdicts)], ["other comparisons", one.formulas.filter((f) => !f.verdicts)]];
  const largest = (f) => Math.max(...f.at.flatMap((a) => a.error.map(Math.abs))), first = groups.find(([, list]) => list.length)[1];
  formula = one.formulas.find((f) => f.name === name) ?? first.reduce((p, q) => (largest(q) > largest(p) ? q : p));
  const unique = (list) => [...new Map(list.map((a) => [a.name, a])).values()];
  axes = unique(formula.at.flatMap((a) => one.studies[a.study].axes));
  sizes = axes.every((a) => a.scales) ? unique(axes.flatMap((a) => a.per)).filter((p) => !axes.some((a) => a.name === p.name)) : [];
  values = Object.fromEntries([...axes, ...sizes].map((a) => [a.name, a.nominal]));
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
