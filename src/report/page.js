// SPDX-License-Identifier: GPL-3.0-or-later
// Search, filter and keys. The page can be read without it; the state is kept in the address,
// so that a filtered view can be sent as a link.
"use strict";
(() => {
  const controls = document.getElementById("controls");
  if (!controls) return;
  const query = document.getElementById("query");
  const count = document.getElementById("count");
  const keys = document.getElementById("keys");
  const unfold = document.getElementById("unfold");
  const buttons = [...controls.querySelectorAll("button[data-verdict]")];
  const claims = [...document.querySelectorAll("article.claim")];
  const texts = claims.map((claim) => claim.dataset.text.toLowerCase());

  // A verdict that no claim has needs no button.
  for (const button of buttons)
    button.hidden = !claims.some((claim) => claim.dataset.verdict === button.dataset.verdict);

  const visible = () => claims.filter((claim) => claim.offsetParent !== null);

  function apply() {
    const words = query.value.toLowerCase().split(/\s+/).filter(Boolean);
    const shown = new Set(buttons.filter((button) => button.getAttribute("aria-pressed") === "true")
      .map((button) => button.dataset.verdict));
    let number = 0;
    claims.forEach((claim, i) => {
      const fits = shown.has(claim.dataset.verdict) && words.every((word) => texts[i].includes(word));
      claim.hidden = !fits;
      number += fits;
    });
    const all = number === claims.length;
    count.textContent = (all ? "" : `${number} of `) + (claims.length === 1 ? "1 claim" : `${claims.length} claims`);
    // While something is looked for, what is not a claim is in the way.
    for (const other of document.querySelectorAll(".part > :not(h2):not(article.claim):not(.cells)")) other.hidden = !all;
    for (const cells of document.querySelectorAll("details.cells")) {
      cells.hidden = !cells.querySelector("article:not([hidden])");
      // What a search unfolds is folded again behind it.
      if (!all && !cells.open) cells.dataset.unfolded = String((cells.open = true));
      if (all && cells.dataset.unfolded) {
        cells.open = false;
        delete cells.dataset.unfolded;
      }
    }
    for (const part of document.querySelectorAll("section.part"))
      part.hidden = !all && !part.querySelector("article.claim:not([hidden])");
    remember(words.join(" "), shown, all);
  }

  function remember(words, shown, all) {
    const state = new URLSearchParams();
    if (words) state.set("q", words);
    if (shown.size < buttons.length) state.set("show", [...shown].join("."));
    const before = new URLSearchParams(location.hash.slice(1));
    if (all && !before.has("q") && !before.has("show")) return;
    history.replaceState(null, "", all ? location.pathname + location.search : "#" + state);
  }

  function recall() {
    const state = new URLSearchParams(location.hash.slice(1));
    if (state.has("q")) query.value = state.get("q");
    if (state.has("show")) {
      const shown = state.get("show").split(".");
      for (const button of buttons) button.setAttribute("aria-pressed", String(shown.includes(button.dataset.verdict)));
    }
  }

  // A link to a claim that is folded away or filtered out still leads there.
  function reveal() {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (!target) return;
    target.hidden = false;
    for (let up = target.parentElement; up; up = up.parentElement) {
      if (up.tagName === "DETAILS") up.open = true;
      if (up.hidden) up.hidden = false;
    }
    target.scrollIntoView();
    // What has come into sight has its true height only when it has been laid out.
    requestAnimationFrame(() => requestAnimationFrame(() => target.scrollIntoView({ behavior: "instant" })));
  }

  // The controls, which stay in sight, cover no place that a link leads to.
  function make_room() {
    const covers = getComputedStyle(controls).position === "sticky" ? controls.offsetHeight : 0;
    document.documentElement.style.scrollPaddingTop = `${covers + 12}px`;
  }

  function step(by) {
    const list = visible();
    if (list.length === 0) return;
    const at = list.indexOf(document.activeElement.closest("article.claim"));
    const next = at < 0 ? (by > 0 ? 0 : list.length - 1) : Math.min(list.length - 1, Math.max(0, at + by));
    list[next].focus();
    list[next].scrollIntoView({ block: "nearest" });
  }

  controls.hidden = keys.hidden = false;
  controls.addEventListener("submit", (event) => event.preventDefault());
  query.addEventListener("input", apply);
  for (const button of buttons)
    button.addEventListener("click", () => {
      button.setAttribute("aria-pressed", String(button.getAttribute("aria-pressed") !== "true"));
      apply();
    });
  unfold.addEventListener("click", () => {
    const open = unfold.textContent === "Unfold all";
    for (const details of document.querySelectorAll("#claims details")) details.open = open;
    unfold.textContent = open ? "Fold all" : "Unfold all";
  });
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const typing = event.target.matches("input");
    if (event.key === "/" && !typing) {
      event.preventDefault();
      query.focus();
    } else if (event.key === "Escape" && typing) {
      query.value = "";
      apply();
      query.blur();
    } else if ((event.key === "j" || event.key === "k") && !typing) {
      step(event.key === "j" ? 1 : -1);
    } else if (event.key === "Enter" && event.target.matches("article.claim")) {
      const details = event.target.querySelector("details");
      if (details) details.open = !details.open;
    }
  });
  window.addEventListener("hashchange", reveal);
  new ResizeObserver(make_room).observe(controls);
  recall();
  apply();
  make_room();
  reveal();
})();
