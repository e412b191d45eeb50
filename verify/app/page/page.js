// Messages beside inputs, the input in the sketch, the link in the address, and the end of the server.
const freewheel = {
  messages(faults, beside, assumed, answered) {
    for (const field of document.querySelectorAll(".field")) {
      const at = field.dataset.at, fault = faults[at], warned = beside[at];
      const input = field.querySelector("[data-place]");
      field.classList.toggle("fault", !!fault);
      field.classList.toggle("warned", !fault && !!warned);
      input.setAttribute("aria-invalid", fault ? "true" : "false");
      if (answered && input.placeholder) input.placeholder = assumed[at] ? `assumed: ${assumed[at][0].replace(/^.* = /, "")}` : "left out";
      const given = freewheel.inUnit(input);
      const text = fault ? fault : (warned || [given && `read as ${given}`]).join(" ");
      const message = field.querySelector(".message");
      if (message.textContent !== text) message.textContent = text;
    }
  },
  inUnit(input) {  // a number alone is in the unit below its field, as the server reads it
    const text = input.value.trim(), unit = input.dataset.unit;
    return unit && /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d{1,3})?$/i.test(text) ? `${text} ${unit}` : "";
  },
  left(event) {  // the field then has the unit
    const given = event.target.dataset.place && freewheel.inUnit(event.target);
    if (!given) return;
    event.target.value = given;
    const message = event.target.closest(".field").querySelector(".message");
    if (message.textContent === `read as ${given}`) message.textContent = "";
  },
  unfolded: new Set(),  // titles of what is unfolded in the answer, which is made again with each edit
  unfold() {
    for (const one of document.querySelectorAll(".answer details, #compared details"))
      one.open = freewheel.unfolded.has(freewheel.title(one));
  },
  title: details => details.querySelector("summary").textContent.replace(/ \(.*/, ""),
  highlight() {
    const place = document.activeElement?.dataset?.place;
    if (place) freewheel.last = place;
    for (const one of document.querySelectorAll(".sketch [data-input]"))
      one.classList.toggle("on", one.dataset.input === place);
    const note = document.getElementById("sketch-note");
    if (!note || !place) return;
    const symbol = document.activeElement.closest(".field")?.querySelector("label b");
    const shown = [...document.querySelectorAll(".sketch [data-input]")].some(one => one.dataset.input === place);
    note.replaceChildren(symbol?.cloneNode(true) ?? place, shown ? " is marked in the sketch" : " is not marked in the sketch");
  },
  focus(place) {
    const input = [...document.querySelectorAll("[data-place]")].find(one => one.dataset.place === place);
    if (input) { input.focus(); input.select?.(); }
  },
  again() {  // after the form was made again
    const back = () => { if (document.activeElement === document.body && freewheel.last) freewheel.focus(freewheel.last); };
    for (const after of [50, 250, 1000]) setTimeout(back, after);
  },
  keep(link) { history.replaceState(null, "", "/?s=" + link); },
  async ended() {  // a server that was started again has another token
    try { if ((await fetch("/", { cache: "no-store" })).status === 403) location.reload(); } catch { /* not there yet */ }
  },
};
document.addEventListener("focusin", freewheel.highlight);
document.addEventListener("change", freewheel.left);
document.addEventListener("toggle", event => {
  if (event.target.matches?.(".answer details, #compared details"))
    freewheel.unfolded[event.target.open ? "add" : "delete"](freewheel.title(event.target));
}, true);
document.addEventListener("click", event => {
  const one = event.target.closest(".sketch [data-input]");
  if (one) freewheel.focus(one.dataset.input);
});
setInterval(() => {
  const lost = !!window.socket && !window.socket.connected;
  document.body.classList.toggle("offline", lost);  // the answer is that of the inputs before
  if (lost) freewheel.ended();
}, 2000);
document.addEventListener("keydown", event => {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
  const key = event.key.toLowerCase();
  const name = key === "z" ? (event.shiftKey ? "redo" : "undo") : key === "y" ? "redo" : "";
  if (name) { event.preventDefault(); document.getElementById(name)?.click(); }
});
