"use strict";
// Rows of the table that have all words of the search, the symbol, and one of the statuses.
const GREEK = {
  α: "alpha", β: "beta", γ: "gamma", δ: "delta", ε: "epsilon", ζ: "zeta", η: "eta", θ: "theta",
  κ: "kappa", λ: "lambda", μ: "mu", ν: "nu", ξ: "xi", π: "pi", ρ: "rho", σ: "sigma", τ: "tau",
  φ: "phi", χ: "chi", ψ: "psi", ω: "omega", Δ: "Delta", Σ: "Sigma", Φ: "Phi", Ω: "Omega",
};
// "μ_{req}", "mu_req" and "μreq" are one symbol
const plain = (symbol) =>
  [...symbol.replace(/[\s_{}]/g, "")].map((letter) => GREEK[letter] ?? letter).join("");
const words = document.getElementById("search");
const symbol = document.getElementById("symbol");
const boxes = [...document.querySelectorAll(".filters [name=status]")];
const bodies = [...document.querySelectorAll("#all-rows tbody")].map((body) => {
  const [head, ...rows] = body.rows;
  const about = head.textContent.toLowerCase();
  return {
    body,
    rows: rows.map((row) => ({
      row,
      text: `${about} ${row.textContent.toLowerCase()}`,
      symbol: plain(row.cells[1].textContent),
      status: row.cells[5].textContent.trim(),
    })),
  };
});
function show() {
  const asked = words.value.toLowerCase().split(/\s+/).filter(Boolean);
  const wanted = plain(symbol.value);
  const folded = wanted === wanted.toLowerCase(); // capitals count where one is typed
  const statuses = boxes.filter((box) => box.checked).map((box) => box.value);
  let count = 0;
  for (const { body, rows } of bodies) {
    let some = 0;
    for (const one of rows) {
      const own = folded ? one.symbol.toLowerCase() : one.symbol;
      one.row.hidden = !(
        asked.every((word) => one.text.includes(word)) &&
        own.startsWith(wanted) &&
        statuses.includes(one.status)
      );
      some += one.row.hidden ? 0 : 1;
    }
    body.hidden = some === 0;
    count += some;
  }
  const all = !asked.length && !wanted && statuses.length === boxes.length;
  document.getElementById("found").textContent = all ? "" : `${count} row${count === 1 ? "" : "s"}`;
}
for (const field of [words, symbol, ...boxes]) field.addEventListener("input", show);
show(); // a browser may keep what was typed
