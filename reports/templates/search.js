"use strict";
// Rows of the table that have all words of the search, in their text or in that of their case.
const field = document.getElementById("search");
const bodies = [...document.querySelectorAll("#all-rows tbody")].map((body) => {
  const [head, ...rows] = body.rows;
  const about = head.textContent.toLowerCase();
  return { body, rows: rows.map((row) => ({ row, text: `${about} ${row.textContent.toLowerCase()}` })) };
});
field.addEventListener("input", () => {
  const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
  let count = 0;
  for (const { body, rows } of bodies) {
    let some = 0;
    for (const { row, text } of rows) {
      row.hidden = !words.every((word) => text.includes(word));
      some += row.hidden ? 0 : 1;
    }
    body.hidden = some === 0;
    count += some;
  }
  document.getElementById("found").textContent = words.length ? `${count} rows` : "";
});
