// Live figures in the pages of a book: each begins as it comes near the window, and none on the page that is
// printed.

const near = new IntersectionObserver((seen) => {
    for (const { isIntersecting, target: root } of seen) {
        if (!isIntersecting) continue;
        near.unobserve(root);
        enliven(root, false);
    }
}, { rootMargin: "100%" });

// A book turns its pages by keys and opens its list by a stroke: not while a figure is held or typed into.
function keepToItself(root) {
    root.addEventListener("keydown", (event) => {
        if (event.key in WAYS && event.target.closest("input, textarea, .knob")) event.stopPropagation();
    });
    root.addEventListener("touchstart", (event) => {
        if (root.hasAttribute("data-dragging")) event.stopPropagation();
    }, { passive: true });
}

const toPrint = document.querySelector('meta[name="robots"][content="noindex"]') !== null;
const roots = toPrint ? [] : document.querySelectorAll(".tracefig-live");
if (roots.length > 0) document.head.append(make("style", {}, LOOK));
for (const root of roots) {
    keepToItself(root);
    near.observe(root);
}
