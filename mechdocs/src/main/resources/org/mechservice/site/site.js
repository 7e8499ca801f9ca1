"use strict";
// Search and the list of chapters on narrow screens. Everything else is plain HTML.
(() => {
  const top = document.currentScript.dataset.top;
  const field = document.getElementById("search");
  const list = document.getElementById("found");
  const menu = document.getElementById("menu");
  const chapters = document.getElementById("chapters");
  const MOST = 20;
  let chosen = -1;

  menu.addEventListener("click", () => {
    menu.setAttribute("aria-expanded", String(chapters.classList.toggle("shown")));
  });
  const current = chapters.querySelector("[aria-current]");
  if (current && current.offsetTop > chapters.clientHeight - 60) {
    chapters.scrollTop = current.offsetTop - chapters.clientHeight / 2;
  }

  // The places are read when they are first needed: a script, since pages that are files may read
  // no data.
  let reading;
  const places = () =>
    (reading ??= new Promise((resolve, reject) => {
      const script = document.createElement("script");
      script.src = top + "assets/places.js";
      script.onload = () =>
        resolve(
          window.mechPlaces.map((place) => ({
            ...place,
            heading: place.h.toLowerCase(),
            page: place.p.toLowerCase(),
            text: place.t.toLowerCase(),
          })),
        );
      script.onerror = reject;
      document.head.append(script);
    }));

  const isLetter = (c) => c !== undefined && /[\p{L}\p{N}_]/u.test(c);
  // How well a word fits a text: as a whole word, at the beginning of one, within one, not at all.
  const fit = (text, word) => {
    let best = 0;
    for (let at = text.indexOf(word); at >= 0 && best < 3; at = text.indexOf(word, at + 1)) {
      const begins = !isLetter(text[at - 1]);
      const ends = !isLetter(text[at + word.length]);
      best = Math.max(best, begins ? (ends ? 3 : 2) : 1);
    }
    return best;
  };
  // Every word must fit somewhere; a heading counts most, then the page's title.
  const score = (place, words) => {
    let sum = 0;
    for (const word of words) {
      const of = 8 * fit(place.heading, word) + 3 * fit(place.page, word) + fit(place.text, word);
      if (of === 0) return 0;
      sum += of;
    }
    return sum - place.h.length / 100 - (place.u.includes("reports/") || place.u.includes("errors/") ? 2 : 0);
  };

  const marked = (text, words) => {
    const nodes = [];
    let rest = text;
    for (;;) {
      const hits = words.map((w) => [rest.toLowerCase().indexOf(w), w]).filter(([at]) => at >= 0);
      if (hits.length === 0) break;
      const [at, word] = hits.reduce((a, b) => (a[0] <= b[0] ? a : b));
      const mark = document.createElement("mark");
      mark.textContent = rest.slice(at, at + word.length);
      nodes.push(rest.slice(0, at), mark);
      rest = rest.slice(at + word.length);
    }
    return [...nodes, rest];
  };
  const excerpt = (place, words) => {
    const at = words.map((w) => place.text.indexOf(w)).filter((i) => i >= 0);
    const from = at.length === 0 ? 0 : Math.max(0, Math.min(...at) - 50);
    return (from > 0 ? "… " : "") + place.t.slice(from, from + 170);
  };

  const choose = (index) => {
    const items = [...list.querySelectorAll("[role=option]")];
    chosen = items.length === 0 ? -1 : (index + items.length) % items.length;
    items.forEach((item, i) => item.setAttribute("aria-selected", String(i === chosen)));
    if (chosen >= 0) {
      items[chosen].scrollIntoView({ block: "nearest" });
      field.setAttribute("aria-activedescendant", items[chosen].id);
    }
  };
  const close = () => {
    list.hidden = true;
    field.setAttribute("aria-expanded", "false");
    field.removeAttribute("aria-activedescendant");
  };
  const note = (text) => {
    const item = document.createElement("li");
    item.className = "none";
    item.textContent = text;
    list.replaceChildren(item);
  };
  const show = async () => {
    const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    if (words.length === 0) return close();
    let all;
    try {
      all = await places();
    } catch {
      note("The index assets/places.js cannot be read.");
      all = null;
    }
    if (all) {
      const best = all
        .map((place) => [score(place, words), place])
        .filter(([s]) => s > 0)
        .sort((a, b) => b[0] - a[0])
        .slice(0, MOST);
      if (best.length === 0) note("Nothing has all of these words.");
      else
        list.replaceChildren(
          ...best.map(([, place], i) => {
            const item = document.createElement("li");
            item.role = "option";
            item.id = "found-" + i;
            const heading = document.createElement("b");
            heading.append(...marked(place.h === place.p ? place.h : place.p + " › " + place.h, words));
            const text = document.createElement("span");
            text.append(...marked(excerpt(place, words), words));
            item.append(heading, text);
            item.addEventListener("mousedown", (event) => {
              event.preventDefault();
              location.href = top + place.u;
            });
            item.dataset.to = top + place.u;
            return item;
          }),
        );
    }
    list.hidden = false;
    field.setAttribute("aria-expanded", "true");
    choose(0);
  };

  field.addEventListener("input", show);
  field.addEventListener("focus", show);
  field.addEventListener("blur", close);
  field.addEventListener("keydown", (event) => {
    if (event.key === "ArrowDown") choose(chosen + 1);
    else if (event.key === "ArrowUp") choose(chosen - 1);
    else if (event.key === "Escape") close();
    else if (event.key === "Enter") {
      const item = document.getElementById("found-" + chosen);
      if (item) location.href = item.dataset.to;
    } else return;
    event.preventDefault();
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "/" && !/^(INPUT|TEXTAREA|SELECT)$/.test(document.activeElement.tagName)) {
      event.preventDefault();
      field.focus();
    }
  });
})();
