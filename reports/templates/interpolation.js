"use strict";
// Error and bar between the stored points of a study: linear on each axis, and nothing beyond them.
const SAME = 1e-6; // of the length of an axis: values that differ by less are equal
const minus = (text) => text.replace(/-/g, "−");
const digits = (x, n = 4) => minus(String(+x.toPrecision(n)));
const with_unit = (axis, x) => `${axis.symbol} = ${digits(x)} ${axis.unit}`.trim();
const scaled = (axis, x) => (axis.log ? Math.log(x) : x);

// values of each axis, rising, and the point at each combination of their numbers
function prepare(study) {
  study.ticks = study.axes.map((_, k) => [...new Set(study.points.map((p) => p[k]))].sort((a, b) => a - b));
  study.index = new Map(study.points.map((p, n) => [p.map((v, k) => study.ticks[k].indexOf(v)).join(), n]));
}

// numbers of the stored values beside x with their weights: one at a value, none beyond the ends
function cell(study, k, x) {
  const t = study.ticks[k];
  const at = t.findIndex((v) => Math.abs(v - x) <= SAME * (t.at(-1) - t[0]));
  if (at >= 0) return [[at, 1]];
  const i = t.findIndex((v) => v > x) - 1;
  if (i < 0) return null;
  const [a, b, middle] = [t[i], t[i + 1], x].map((v) => scaled(study.axes[k], v));
  const share = (middle - a) / (b - a);
  return [[i, 1 - share], [i + 1, share]];
}

// distance of a point from the line through its neighbours on an axis, for an interval of this width
function bend(study, error, node, k, width) {
  const beside = [-1, 0, 1].map((step) => node.map((i, j) => (j === k ? i + step : i)));
  const e = beside.map((place) => error[study.index.get(place.join())] ?? NaN);
  const x = beside.map((place) => scaled(study.axes[k], study.ticks[k][place[k]]));
  const a = x[1] - x[0], b = x[2] - x[1];
  return (Math.abs(e[1] - (e[0] * b + e[2] * a) / (a + b)) / (a * b)) * width ** 2;
}

// what a straight line along an axis may leave out, the most of all lines: NaN where no third point
// tells how the error bends; a quarter of its change stands for a turn that no point shows
function bent_along(study, error, nodes, k, cell) {
  const [p, q] = cell.map(([i]) => scaled(study.axes[k], study.ticks[k][i]));
  const lines = nodes.filter((node) => node[k] === cell[0][0]).map((node) => {
    const ends = cell.map(([i]) => node.map((v, j) => (j === k ? i : v)));
    const known = ends.map((end) => bend(study, error, end, k, q - p)).filter((v) => !Number.isNaN(v));
    const [from, to] = ends.map((end) => error[study.index.get(end.join())]);
    return known.length ? Math.max(...known) + Math.abs(to - from) / 4 : NaN;
  });
  return Math.max(...lines);
}

// error e, bar u, its part `bent` by interpolation, the `spacing` of the points; or `why` there is none
function between(study, course, at) {
  const cells = at.map((x, k) => cell(study, k, x)), out = cells.indexOf(null);
  if (out >= 0) {
    const t = study.ticks[out];
    return { why: `${with_unit(study.axes[out], at[out])} is outside the stored range of ${digits(t[0])} to ${digits(t.at(-1))}` };
  }
  let corners = [{ node: [], weight: 1 }];
  for (const one of cells)
    corners = corners.flatMap(({ node, weight }) => one.map(([i, share]) => ({ node: [...node, i], weight: weight * share })));
  const points = corners.map(({ node }) => study.index.get(node.join()));
  const lost = points.find((n) => course.error[n] === null || course.U[n] === null);
  if (lost !== undefined) {
    const where = study.axes.map((axis, k) => with_unit(axis, study.points[lost][k])).join(", ");
    return { why: `no result at the stored point ${where}: ${plain(course.problems?.[lost] ?? "")}` };
  }
  const nodes = corners.map(({ node }) => node);
  const bent = cells.reduce((sum, one, k) => sum + (one.length > 1 ? bent_along(study, course.error, nodes, k, one) : 0), 0);
  if (Number.isNaN(bent)) return { why: "between stored points without a third one beside them, no interpolation error can be stated" };
  const e = corners.reduce((sum, { weight }, n) => sum + weight * course.error[points[n]], 0);
  const beside = cells.map((one, k) => one.map(([i]) => study.ticks[k][i]));
  const spacing = beside.reduce((sum, [a, b = a]) => sum + Math.abs(b - a) / (Math.abs(a) + Math.abs(b) || 1), 0);
  return { e, u: Math.max(...points.map((n) => course.U[n])) + bent, bent, spacing, stored: corners.length === 1 };
}
