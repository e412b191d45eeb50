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
      const text = fault ? fault : (warned || []).join(" ");
      const message = field.querySelector(".message");
      if (message.textContent !== text) message.textContent = text;
    }
  },
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
