// A click on a head sorts its table; a link to a model opens its part.
for (const table of document.querySelectorAll("table.sorts")) {
  const heads = [...table.tHead.rows[0].cells], body = table.tBodies[0];
  heads.forEach((head, column) => head.addEventListener("click", () => {
    const up = head.getAttribute("aria-sort") !== "ascending";
    const key = row => { const text = row.cells[column].dataset.v ?? row.cells[column].textContent, n = Number(text); return Number.isNaN(n) ? text : n; };
    const rows = [...body.rows].sort((a, b) => { const x = key(a), y = key(b); return (x > y) - (x < y); });
    body.append(...(up ? rows : rows.reverse()));
    heads.forEach(h => h.removeAttribute("aria-sort"));
    head.setAttribute("aria-sort", up ? "ascending" : "descending");
  }));
}
const open_target = () => { const target = document.getElementById(location.hash.slice(1)); if (target) target.open = true; };
addEventListener("hashchange", open_target);
open_target();
