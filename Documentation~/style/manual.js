// The search of the manual, and the page's own entry in a long table of contents. All else works without scripts.
"use strict";
(function () {
    const style = document.currentScript.src.replace(/manual\.js$/, ""), root = style + "../html/";
    const box = document.querySelector(".search");
    const input = box.querySelector("input");
    const list = box.querySelector("ol");
    let index = null, rows = [], chosen = -1, loading = false;

    document.querySelector("nav [aria-current]")?.scrollIntoView({ block: "nearest" });
    box.hidden = false;
    input.placeholder = "Search ( / )";

    // Scripts and no requests: a page that is opened as a file may send none.
    function load(address, done) {
        const script = document.createElement("script");
        script.src = address;
        script.onload = done;
        document.head.append(script);
    }

    function prepare() {
        if (loading)
            return;
        loading = true;
        load(style + "minisearch.js", () => load(root + "search-documents.js", () => {}));
    }

    window.manualDocuments = function (documents) {
        rows = documents;
        index = new MiniSearch({
            fields: ["title", "names", "section", "text"],
            searchOptions: { prefix: true, fuzzy: term => term.length > 4 ? 0.2 : 0, boost: { title: 4, names: 3, section: 1.5 }, combineWith: "AND" },
        });
        index.addAll(rows.map(([, title, section, text], id) => ({ id, title, names: words(title), section, text })));
        show();
    };

    // FluidEmitter is found by "emitter" too.
    function words(name) {
        return name.replace(/([a-z0-9])([A-Z])/g, "$1 $2");
    }

    function escaped(text) {
        return text.replace(/[&<>"]/g, sign => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[sign]);
    }

    function marked(text, terms) {
        const any = terms.map(term => term.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")).join("|");
        return any ? escaped(text).replace(new RegExp(`(${any})`, "gi"), "<mark>$1</mark>") : escaped(text);
    }

    // The text around the first word that was found.
    function excerpt(text, terms) {
        const lower = text.toLowerCase();
        const first = Math.min(...terms.map(term => lower.indexOf(term)).filter(at => at >= 0));
        const start = Number.isFinite(first) && first > 30 ? text.lastIndexOf(" ", first - 25) + 1 : 0;
        return (start > 0 ? "… " : "") + marked(text.slice(start, start + 160), terms);
    }

    function show() {
        const query = input.value.trim();
        list.hidden = query.length === 0;
        chosen = -1;
        if (list.hidden || index === null)
            return;
        const found = index.search(query).slice(0, 12);
        list.innerHTML = found.length === 0 ? '<li class="none">Nothing found</li>' : found.map(({ id, terms }) => {
            const [address, title, section, text] = rows[id];
            return `<li><a href="${root}${address}">${marked(title, terms)}${section ? ` <span class="section">– ${escaped(section)}</span>` : ""}` +
                `<small>${excerpt(text, terms)}</small></a></li>`;
        }).join("");
        choose(0);
    }

    function choose(next) {
        const links = list.querySelectorAll("a");
        links[chosen]?.classList.remove("chosen");
        chosen = Math.max(0, Math.min(next, links.length - 1));
        links[chosen]?.classList.add("chosen");
        links[chosen]?.scrollIntoView({ block: "nearest" });
    }

    input.addEventListener("focus", prepare);
    input.addEventListener("input", show);
    input.addEventListener("keydown", event => {
        if (event.key === "ArrowDown" || event.key === "ArrowUp") {
            choose(chosen + (event.key === "ArrowDown" ? 1 : -1));
            event.preventDefault();
        } else if (event.key === "Enter")
            list.querySelector("a.chosen")?.click();
        else if (event.key === "Escape") {
            input.value = "";
            show();
            input.blur();
        }
    });
    list.addEventListener("click", () => { list.hidden = true; });
    document.addEventListener("click", event => { if (!box.contains(event.target)) list.hidden = true; });
    document.addEventListener("keydown", event => {
        if (event.key === "/" && !/^(INPUT|TEXTAREA)$/.test(document.activeElement.tagName)) {
            input.focus();
            event.preventDefault();
        }
    });
})();
