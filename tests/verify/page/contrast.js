// Contrast of every visible text with what is behind it: [ratio, element, text].
const seen = [], ctx = document.createElement("canvas").getContext("2d", {willReadFrequently: true});
const rgb = text => { ctx.clearRect(0, 0, 1, 1); ctx.fillStyle = text; ctx.fillRect(0, 0, 1, 1);
  const [r, g, b, a] = ctx.getImageData(0, 0, 1, 1).data; return [r, g, b, a / 255]; };
const lum = c => c.slice(0, 3).map(v => { v /= 255; return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4; })
  .reduce((s, v, i) => s + v * [0.2126, 0.7152, 0.0722][i], 0);
const behind = e => { for (; e; e = e.parentElement) { const c = rgb(getComputedStyle(e).backgroundColor); if (c[3] > 0.99) return c; }
  return matchMedia("(prefers-color-scheme: dark)").matches ? [18, 18, 18, 1] : [255, 255, 255, 1]; };
for (const e of document.querySelectorAll("body *")) {
  const text = [...e.childNodes].some(n => n.nodeType === 3 && n.textContent.trim()) || e.tagName === "INPUT";
  if (!text || !e.checkVisibility() || e.disabled || e.closest(":disabled") || e.tagName === "OPTION" || e.tagName === "OPTGROUP") continue;
  const style = getComputedStyle(e), ink = rgb(e.closest("svg") ? style.fill : style.color), paper = behind(e);
  const [a, b] = [lum(ink), lum(paper)].sort((x, y) => y - x);
  seen.push([(a + 0.05) / (b + 0.05), e.tagName + "." + e.className.toString(), e.textContent.slice(0, 40)]);
}
return seen;
