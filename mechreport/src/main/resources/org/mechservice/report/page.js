// Values of the thing pointed at.
const hover = document.getElementById("hover");
document.addEventListener("mousemove", event => {
  const text = event.target.getAttribute && event.target.getAttribute("data-t");
  hover.style.display = text ? "block" : "none";
  if (text) {
    hover.textContent = text;
    const left = Math.min(event.clientX + 14, innerWidth - hover.offsetWidth - 8);
    hover.style.left = left + "px";
    hover.style.top = Math.min(event.clientY + 14, innerHeight - hover.offsetHeight - 8) + "px";
  }
});
